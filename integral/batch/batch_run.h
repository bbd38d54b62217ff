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
    double memory = 0;          ///< bytes that all together may take; 0: what the machine has free
    OutputPixels output_pixels; ///< for the forecast of memory
    std::set<int> jobs;         ///< that are run, in the manifest's list; empty: all
};

/// The fate of every step of the plan, without running any: kept, or waiting to be done. Throws
/// Interrupted.
std::vector<StepResult> survey(PlannedBatch& batch, const RunOptions& options);

/// Runs what is to be done. A failure leaves out only what depends on it, and is said on standard
/// error at once. Throws Interrupted, with what was finished kept, and OutputError if the output
/// folder cannot be written or, when all jobs are run, another batch works in it.
std::vector<StepResult> run_batch(PlannedBatch& batch, const RunOptions& options,
                                  const BatchReporter& reporter);

/// The same for a plan of other steps in the batch's folder, as strips are.
std::vector<StepResult> run_steps(PlannedBatch& batch, const BatchPlan& plan,
                                  const RunOptions& options, const BatchReporter& reporter);

} // namespace integral

#endif
