// SPDX-License-Identifier: AGPL-3.0-or-later
// A batch's jobs as tasks of a Slurm cluster whose nodes share the batch's folder: submits what is
// neither done nor in the queue, follows the queue, and takes tasks from it. Every function throws
// InputError where Slurm refuses.
#ifndef INTEGRAL_BATCH_CLUSTER_H
#define INTEGRAL_BATCH_CLUSTER_H

#include "integral/base/parallel.h"
#include "integral/batch/batch_run.h"

namespace integral {

/// What each task gets. An empty text is the cluster's own default. Memory, retries and the jobs to
/// submit are those of RunOptions.
struct ClusterOptions {
    int strips = 1; ///< that each frame is cut into, at most; 1: frames are rendered whole
    int cpus = 1;
    std::string partition, time;
    Names sbatch; ///< further options of sbatch
};

struct Submitted {
    int tasks = 0;         ///< that were submitted
    int queued_before = 0; ///< tasks that were in the queue already
    bool every_job = true; ///< false: why a job was not submitted was said on standard error
};

/// Submits every job that is neither done nor in the queue, and a task that writes the summary when
/// all have ended. The manifest must be a file. Throws OutputError.
Submitted submit_batch(PlannedBatch& batch, const RunOptions& wanted,
                       const ClusterOptions& cluster);

/// Waits until none of the batch's tasks is in the queue. Says on standard error which limits of
/// the cluster let tasks wait. Throws Interrupted; the tasks then go on.
void follow_batch(const PlannedBatch& batch, const Progress& progress);

/// Takes all of the batch's tasks from the queue and returns their number.
int cancel_batch(const PlannedBatch& batch);

} // namespace integral

#endif
