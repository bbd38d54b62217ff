// SPDX-License-Identifier: AGPL-3.0-or-later
// Frames of a batch that are rendered as strips of rows, on several machines: each strip is a step
// of its own, and a last task joins them to the frame.
#ifndef INTEGRAL_BATCH_BATCH_STRIPS_H
#define INTEGRAL_BATCH_BATCH_STRIPS_H

#include "integral/batch/batch_run.h"

namespace integral {

/// How a frame is cut into strips. A file in the batch's folder tells it to the tasks.
struct StripPlan {
    std::string inputs; ///< hash of the frame step's inputs
    int height = 0;     ///< rows of the frame
    std::vector<RowStrip> strips;
};

/// The steps that make the strips, in order.
BatchPlan strip_steps(const BatchStep& frame, const StripPlan& plan);

/// Cuts a job's frame into at most `number` strips and writes the plan. Runs the renderer for two
/// rows, whose picture tells the frame's size and sheet, and whose words tell whether there is
/// anti-aliasing. If there is a plan already, of the same inputs and number, it is kept, so that
/// finished strips count. Says on standard error why strips may differ from the whole frame, if
/// they may. Throws InputError, with the renderer's reason, if there can be no strips; OutputError.
StripPlan plan_strips(PlannedBatch& batch, int job, int number);

/// The plan of a frame's strips in the batch's folder; nothing if there is none, or if it was made
/// of other inputs, as of an earlier state of the scene.
std::optional<StripPlan> read_strip_plan(const BatchFolder& folder, const BatchStep& frame,
                                         const std::string& inputs);

/// Renders one strip, from 1, of a job's frame, unless that frame is done. Returns whether it was
/// made; if not, the reason was said on standard error. Throws InputError if the frame has no such
/// strip; else as run_steps does.
bool render_strip(PlannedBatch& batch, int job, std::size_t number, RunOptions options,
                  const BatchReporter& reporter);

/// Makes a job's frame of its strips, unless it is done, and deletes them. Returns "", or why it
/// cannot be made, which is also written to the frame's record. Throws OutputError.
std::string merge_frame(PlannedBatch& batch, int job);

} // namespace integral

#endif
