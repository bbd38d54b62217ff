// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs the steps of a batch on this machine's cores.
#ifndef INTEGRAL_BATCH_BATCH_RUN_H
#define INTEGRAL_BATCH_BATCH_RUN_H

#include "integral/base/parallel.h"
#include "integral/batch/batch_folder.h"
#include "integral/batch/batch_memory.h"
#include "integral/batch/plan.h"

#include <map>
#include <set>

namespace integral {

struct RunOptions {
    int at_once = 1;            ///< programs that run at the same time
    int retries = 0;            ///< after a failure
    double memory = 0;          ///< bytes that all together may take; 0: what the machine has free
    OutputPixels output_pixels; ///< for the bounds of memory
    std::set<int> jobs;         ///< of the manifest; empty: all
};

enum class StepFate {
    waiting, ///< not yet looked at, or to be done
    kept,    ///< was there already, of the same inputs
    made,
    copied, ///< another step of the same inputs made it
    failed,
    blocked, ///< its frame failed
};
const char* name_of(StepFate fate);

struct StepResult {
    StepFate fate = StepFate::waiting;
    std::string reason; ///< of a failure
};

/// Looks at every step: kept, or waiting to be done. Nothing is run.
std::vector<StepResult> survey(const Manifest& manifest, const BatchPlan& plan, StepInputs& inputs,
                               const RunOptions& options);

/// Runs what is to be done. A failure leaves out only what depends on it, and is said on standard
/// error at once. Throws Interrupted, with what was finished kept, and OutputError where the folder
/// itself cannot be written.
std::vector<StepResult> run_batch(const Manifest& manifest, const BatchPlan& plan,
                                  StepInputs& inputs, const RunOptions& options,
                                  const Progress& progress);

} // namespace integral

#endif
