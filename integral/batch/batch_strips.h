// SPDX-License-Identifier: AGPL-3.0-or-later
// Frames of a batch that are rendered in strips of rows: each strip is a step of its own, on
// whatever machine, and the frame is put together of them.
#ifndef INTEGRAL_BATCH_BATCH_STRIPS_H
#define INTEGRAL_BATCH_BATCH_STRIPS_H

#include "integral/batch/batch_run.h"

namespace integral {

/// How a frame is cut, as a file in the batch's folder tells the tasks: made from the frame's own
/// inputs.
struct StripPlan {
    std::string inputs; ///< hash of the frame step's
    int height = 0;     ///< rows of the frame
    std::vector<RowStrip> strips;
};

/// The steps that make the strips, in order.
BatchPlan strip_steps(const BatchStep& frame, const StripPlan& plan);

/// Cuts a frame in `number` strips at most: runs the renderer for two rows, which tells the size,
/// the sheet and whether there is anti-aliasing. A plan of the same inputs and number that is there
/// already is kept, so that finished strips count. Writes the plan. Says on standard error why
/// strips cannot be promised to equal the whole frame, where that is so. Throws InputError, with
/// the renderer's reason, where there can be no strips; OutputError.
StripPlan plan_strips(const BatchFolder& folder, const BatchStep& frame, const std::string& inputs,
                      int number, const BatchPrograms& programs);

/// The plan that is there of a frame; nothing if there is none, or one of other inputs: the scene
/// has changed since.
std::optional<StripPlan> read_strip_plan(const BatchFolder& folder, const BatchStep& frame,
                                         const std::string& inputs);

/// Makes the frame of its strips, unless it is there already, and deletes them. Returns why it
/// cannot be made, which its record says too; empty: it is made. Throws OutputError.
std::string merge_frame(const BatchFolder& folder, const BatchStep& frame, StepInputs& inputs);

} // namespace integral

#endif
