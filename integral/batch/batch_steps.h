// SPDX-License-Identifier: AGPL-3.0-or-later
// Builds the command line of a step's program, and reads its files and messages afterwards.
#ifndef INTEGRAL_BATCH_BATCH_STEPS_H
#define INTEGRAL_BATCH_BATCH_STEPS_H

#include "integral/batch/batch_folder.h"
#include "integral/batch/child_process.h"
#include "integral/frame/frame.h"
#include "integral/io/codecs.h"

namespace integral {

/// The versions of the steps' programs. Throws InputError if povray-integral cannot be run.
BatchPrograms batch_programs();

/// The command line of a step: program, words, threads, output. `frame` is the path of its input
/// frame.
std::vector<std::string> command_line(const BatchFolder& folder, const BatchStep& step,
                                      const std::string& frame, int threads);

/// The header of a frame's file. Throws InputError if the file is no picture.
PictureHeader frame_header(const std::string& path);

/// The metadata in a header. Throws InputError if there is none: the camera was not integral.
FrameMetadata metadata_in(const PictureHeader& header);

/// Pixels of the frame that a step makes or reads: from the plan, or from the header of `frame`;
/// else the renderer's default size.
double pixels_of(const BatchStep& step, const std::string& frame);

/// One line with the reason of a failure, from the program's output in `log` and its exit `end`.
std::string failure_of(const BatchStep& step, const std::string& log, const ChildEnd& end);

/// Copies a finished frame's size, seconds and estimated error from its header into the record.
/// Throws InputError if the file is no integral frame.
void read_figures(const std::string& frame, StepRecord& record);

/// Completes the record of a step whose program has ended, and publishes its result. Returns "", or
/// one line with the reason why nothing is published. `frame` is the path of the step's input,
/// `log` of its program's output.
std::string publish_made(const BatchFolder& folder, const BatchStep& step, const std::string& frame,
                         const std::string& log, const ChildEnd& end, StepRecord& record);

/// Publishes a copy of what another step has made from the same inputs, and copies that step's
/// figures to the record. Throws OutputError.
void publish_copy(const BatchFolder& folder, const BatchStep& step, const BatchStep& other,
                  StepRecord& record);

/// The current time, as 2026-01-31T12:00:00Z.
std::string time_now();

} // namespace integral

#endif
