// SPDX-License-Identifier: AGPL-3.0-or-later
// How one step of a batch is run as a program, and what is read off it afterwards.
#ifndef INTEGRAL_BATCH_BATCH_STEPS_H
#define INTEGRAL_BATCH_BATCH_STEPS_H

#include "integral/batch/batch_folder.h"
#include "integral/batch/child_process.h"
#include "integral/io/codecs.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// Which programs run, in their own words. Throws InputError where povray-integral cannot be run.
BatchPrograms batch_programs();

/// The command line of a step: program, words, threads, output.
std::vector<std::string> command_line(const BatchFolder& folder, const BatchStep& step,
                                      const std::string& frame, int threads);

/// What a frame's file says before its pixels. Throws InputError where it is no picture.
PictureHeader frame_header(const std::string& path);

/// The document of a frame. Throws InputError where it has none.
FrameMetadata metadata_in(const PictureHeader& header);

/// Pixels of the frame that a step makes or takes, as far as the plan or the file says; else those
/// of the renderer's own default.
double pixels_of(const BatchStep& step, const std::string& frame);

/// One line that says why a step's program failed, from its log and its end.
std::string failure_of(const BatchStep& step, const std::string& log, const ChildEnd& end);

/// What a finished frame says of itself: its estimated error and its size. Throws InputError where
/// it is no whole integral frame.
void read_figures(const std::string& frame, StepRecord& record);

/// Publishes what a step's program has made, with the record filled in, once it has ended; returns
/// "", or one line that says why not. `frame` is what it took, `log` what it said.
std::string publish_made(const BatchFolder& folder, const BatchStep& step, const std::string& frame,
                         const std::string& log, const ChildEnd& end, StepRecord& record);

/// Publishes as a step's output a copy of what another made of the same inputs, with what is known
/// of that filled into the record. Throws OutputError.
void publish_copy(const BatchFolder& folder, const BatchStep& step, const BatchStep& other,
                  StepRecord& record);

/// Now, as 2026-01-31T12:00:00Z.
std::string time_now();

} // namespace integral

#endif
