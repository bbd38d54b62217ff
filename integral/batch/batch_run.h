// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs the steps of a batch on this machine's cores.
#ifndef INTEGRAL_BATCH_BATCH_RUN_H
#define INTEGRAL_BATCH_BATCH_RUN_H

#include "integral/batch/batch_memory.h"
#include "integral/batch/planned_batch.h"
#include "integral/batch/step_states.h"

#include <set>

namespace integral {

struct RunOptions {
    int at_once = 1;            ///< programs that run at the same time
    int retries = 0;            ///< after a failure
    double memory = 0;          ///< bytes for all programs together; 0: the machine's free memory
    OutputPixels output_pixels; ///< for the forecast of memory
    std::set<int> jobs;         ///< jobs to run, as indices in the manifest; empty: all
};

/// Returns the fate of every step of the plan without running any: kept or waiting. Throws
/// Interrupted.
std::vector<StepResult> survey(PlannedBatch& batch, const RunOptions& options);

/// Runs the steps that are not done. If a step fails, leaves out the steps that read its output and
/// reports the failure on standard error. Throws Interrupted, keeping finished steps; OutputError
/// if the output folder cannot be written or, when all jobs are run, is in use by another batch.
std::vector<StepResult> run_batch(PlannedBatch& batch, const RunOptions& options,
                                  const BatchReporter& reporter);

/// Like run_batch, for a plan of other steps in the batch's folder, such as strips.
std::vector<StepResult> run_steps(PlannedBatch& batch, const BatchPlan& plan,
                                  const RunOptions& options, const BatchReporter& reporter);

} // namespace integral

#endif
