// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs a batch's jobs as tasks of a Slurm cluster whose nodes share the batch's folder: submits
// what is neither done nor queued, follows the queue, and cancels queued tasks. Every function
// throws InputError if Slurm refuses.
#ifndef INTEGRAL_BATCH_CLUSTER_H
#define INTEGRAL_BATCH_CLUSTER_H

#include "integral/base/parallel.h"
#include "integral/batch/batch_run.h"

namespace integral {

/// Resources of each task. An empty text stands for the cluster's default. RunOptions give memory,
/// retries and the jobs to submit.
struct ClusterOptions {
    int strips = 1; ///< maximum per frame; 1: frames are rendered whole
    int cpus = 1;
    std::string partition, time;
    Names sbatch; ///< further options of sbatch
};

struct Submitted {
    int tasks = 0;         ///< submitted now
    int queued_before = 0; ///< tasks in the queue before
    bool every_job = true; ///< false: a job was not submitted, and standard error has the reason
};

/// Submits the requested jobs that are neither done nor queued and, if all jobs are requested, a
/// task that finally writes the summary. The manifest must be a file. Throws OutputError.
Submitted submit_batch(PlannedBatch& batch, const RunOptions& requested,
                       const ClusterOptions& cluster);

/// Waits until no task of the batch is in the queue. Prints to standard error which limits of the
/// cluster make tasks wait. Throws Interrupted; the tasks then go on.
void follow_batch(const PlannedBatch& batch, const Progress& progress);

/// Removes all of the batch's tasks from the queue and returns their number.
int cancel_batch(const PlannedBatch& batch);

} // namespace integral

#endif
