// SPDX-License-Identifier: AGPL-3.0-or-later
// The tasks of a batch in Slurm's queue. The command of each task is written to the batch's folder
// on submission, in OUTPUT/.integral-batch/slurm; no other record of the tasks exists.
#ifndef INTEGRAL_BATCH_CLUSTER_QUEUE_H
#define INTEGRAL_BATCH_CLUSTER_QUEUE_H

#include "integral/batch/batch_folder.h"
#include "integral/batch/slurm.h"

#include <map>

namespace integral {

/// The command of one task, as the end of its command line: "--only JOB", "--strip JOB:K",
/// "--merge JOB" or "--summary".
using Task = std::string;

/// A task in Slurm's queue.
struct QueuedTask {
    std::string id; ///< for scancel and dependencies: ARRAY_INDEX
    SlurmTask slurm;
};

std::string cluster_folder(const BatchFolder& folder);

/// Writes a list of tasks, one per line, to a new file in the cluster's folder; returns its path.
std::string write_task_list(const BatchFolder& folder, const std::vector<Task>& tasks);

/// Records in a file next to a list of tasks that these were submitted as the array `job`.
void note_submission(const std::string& list, const std::string& job,
                     const std::vector<Task>& tasks);

/// The batch's waiting and running tasks. Deletes the lists of arrays that have ended. Throws
/// InputError if squeue fails.
std::map<Task, QueuedTask> queued_tasks(const BatchFolder& folder);

} // namespace integral

#endif
