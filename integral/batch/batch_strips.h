// SPDX-License-Identifier: AGPL-3.0-or-later
// Renders frames of a batch as strips of rows, on several machines: each strip is a step of its
// own, and a last task joins them to the frame.
#ifndef INTEGRAL_BATCH_BATCH_STRIPS_H
#define INTEGRAL_BATCH_BATCH_STRIPS_H

#include "integral/batch/batch_run.h"

namespace integral {

/// Division of a frame into strips. The tasks read it from a file in the batch's folder.
struct StripPlan {
    std::string inputs; ///< hash of the frame step's inputs
    int height = 0;     ///< rows of the frame
    std::vector<RowStrip> strips;
};

/// The steps that make the strips, in the strips' order.
BatchPlan strip_steps(const BatchStep& frame, const StripPlan& plan);

/// Cuts a job's frame into at most `number` strips and writes the plan. First renders two rows:
/// their picture gives the frame's size and sheet, and the settings that the renderer prints show
/// whether it anti-aliases. Keeps an existing plan for the same inputs, and thus its finished
/// strips, if it has `number` strips or only one. Warns on standard error if strips may differ from
/// the whole frame, with the reason. Throws InputError, with the renderer's reason, if there can be
/// no strips; OutputError.
StripPlan plan_strips(PlannedBatch& batch, int job, int number);

/// The plan of a frame's strips in the batch's folder; empty if there is none, or if its inputs
/// differ, e.g. after a change of the scene.
std::optional<StripPlan> read_strip_plan(const BatchFolder& folder, const BatchStep& frame,
                                         const std::string& inputs);

/// Renders strip `number` (from 1) of a job's frame, unless the frame is done. Returns false if the
/// rendering failed, and prints the reason to standard error. Throws InputError if the frame has
/// fewer strips; else as run_steps.
bool render_strip(PlannedBatch& batch, int job, std::size_t number, RunOptions options,
                  const BatchReporter& reporter);

/// Joins a job's strips to its frame, unless the frame is done, and deletes the strips. Returns "",
/// or the reason of a failure, which is also written to the frame's record. Throws OutputError.
std::string merge_frame(PlannedBatch& batch, int job);

} // namespace integral

#endif
