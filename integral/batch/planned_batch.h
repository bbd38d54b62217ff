// SPDX-License-Identifier: AGPL-3.0-or-later
// A manifest with its plan and everything else for running, submitting or reporting a batch.
#ifndef INTEGRAL_BATCH_PLANNED_BATCH_H
#define INTEGRAL_BATCH_PLANNED_BATCH_H

#include "integral/batch/batch_folder.h"
#include "integral/batch/plan.h"

namespace integral {

struct PlannedBatch {
    /// Runs povray-integral for its version. Throws InputError if that fails.
    explicit PlannedBatch(Manifest read);
    PlannedBatch(const PlannedBatch&) = delete; // inputs refers to manifest
    PlannedBatch& operator=(const PlannedBatch&) = delete;

    const BatchJob& job(int index) const { return manifest.jobs[std::size_t(index)]; }
    /// The step that makes a job's frame.
    const BatchStep& frame_of(int job) const
    {
        return plan.steps[std::size_t(plan.frames[std::size_t(job)])];
    }

    const Manifest manifest;
    const BatchPlan plan;
    const BatchPrograms programs;
    const BatchFolder folder;
    StepInputs inputs;
};

} // namespace integral

#endif
