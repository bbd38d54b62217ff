// SPDX-License-Identifier: AGPL-3.0-or-later
// A batch's jobs as tasks of a Slurm cluster whose nodes share the batch's folder. All that is
// known of them is kept there: what is not done and not in the queue is submitted again.
#ifndef INTEGRAL_CLI_BATCH_SLURM_H
#define INTEGRAL_CLI_BATCH_SLURM_H

#include "integral/batch/batch_run.h"
#include "integral/cli/command.h"

namespace integral {

/// Options of integral batch for a cluster: --slurm, --follow, --cancel and what belongs to them.
void add_slurm_options(options::options_description& all);

/// A batch as the command has read it.
struct PlannedBatch {
    const Manifest& manifest;
    const BatchPlan& plan;
    StepInputs& inputs;
    const BatchPrograms& programs;
    const RunOptions& wanted;
};

/// What remains for the command to do.
enum class AfterSlurm {
    run,     ///< none of these options was given
    summary, ///< the batch was followed to its end: its summary
    nothing,
};

/// Submits, follows or cancels, as the options say; says on standard output what was submitted or
/// cancelled. Throws UsageError, InputError where Slurm refuses, OutputError, Interrupted:
/// following ends, the jobs go on.
AfterSlurm use_slurm(const options::variables_map& arguments, const PlannedBatch& batch);

/// What tasks are: --strip JOB:K renders one strip of a frame, --merge JOB makes the frame of its
/// strips. Returns whether the strip or the frame was made, having said on standard error why not;
/// nothing if neither option was given. After --merge the job's other steps are to be run: it is in
/// `merged`.
std::optional<bool> do_task(const options::variables_map& arguments, const PlannedBatch& batch,
                            std::set<int>& merged);

} // namespace integral

#endif
