// SPDX-License-Identifier: AGPL-3.0-or-later
// The tasks of a batch in Slurm's queue. Which task does what is written to the batch's folder when
// it is submitted, in OUTPUT/.integral-batch/slurm: nothing else is kept of them.
#ifndef INTEGRAL_BATCH_CLUSTER_QUEUE_H
#define INTEGRAL_BATCH_CLUSTER_QUEUE_H

#include "integral/batch/batch_folder.h"
#include "integral/batch/slurm.h"

#include <map>

namespace integral {

/// What one task does, as the end of its command line: "--only JOB", "--strip JOB:K",
/// "--merge JOB" or "--summary".
using Task = std::string;

/// A task in Slurm's queue.
struct QueuedTask {
    std::string id; ///< as scancel and dependencies take it: ARRAY_INDEX
    SlurmTask slurm;
};

std::string cluster_folder(const BatchFolder& folder);

/// Writes a list of tasks, one a line, to a new file in the cluster's folder and returns its path.
std::string write_task_list(const BatchFolder& folder, const std::vector<Task>& tasks);

/// Writes beside a list of tasks that they were submitted as the array `job`.
void note_submission(const std::string& list, const std::string& job,
                     const std::vector<Task>& tasks);

/// The batch's tasks that wait or run. Deletes the lists of arrays that have ended. Throws
/// InputError where Slurm cannot be asked.
std::map<Task, QueuedTask> queued_tasks(const BatchFolder& folder);

} // namespace integral

#endif
