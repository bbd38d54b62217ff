// SPDX-License-Identifier: AGPL-3.0-or-later
// How one step of a batch is run as a program, and what is read off it afterwards.
#ifndef INTEGRAL_CLI_BATCH_STEPS_H
#define INTEGRAL_CLI_BATCH_STEPS_H

#include "integral/batch/batch_folder.h"
#include "integral/cli/child_process.h"

namespace integral {

/// Which programs run, in their own words. Throws InputError where povray-integral cannot be run.
BatchPrograms batch_programs();

/// The command line of a step: program, words, threads, output.
std::vector<std::string> command_line(const BatchFolder& folder, const BatchStep& step, const std::string& frame, int threads);

/// Pixels of the frame that a step makes or takes, as far as the plan or the file says; else those of the renderer's own default.
double pixels_of(const BatchStep& step, const std::string& frame);

/// Bytes of memory that a step will need: by its pixels, and by what earlier steps of its kind needed, `known` bytes at `known_pixels`.
double memory_for(StepKind kind, double pixels, double known, double known_pixels);

/// Bytes of memory that programs can still have, by the kernel's account.
double free_memory();

/// One line that says why a step's program failed, from its log and its end.
std::string failure_of(const BatchStep& step, const std::string& log, const ChildEnd& end);

/// What a step's program said of its frame though it made its file, without the program's and the frame's name; empty if nothing.
std::string remark_of(const BatchStep& step, const std::string& log, const std::string& frame);

/// What a finished frame says of itself: its estimated error and its size. Throws InputError where it is no whole integral frame.
void read_figures(const std::string& frame, StepRecord& record);

/// Now, as 2026-01-31T12:00:00Z.
std::string time_now();

} // namespace integral

#endif
