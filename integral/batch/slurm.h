// SPDX-License-Identifier: AGPL-3.0-or-later
// Calls Slurm through its own programs: sbatch, squeue, scancel, scontrol. If they are missing, an
// error names the package; no Slurm library is linked.
#ifndef INTEGRAL_BATCH_SLURM_H
#define INTEGRAL_BATCH_SLURM_H

#include <string>
#include <vector>

namespace integral {

/// A request to sbatch: an array of tasks. An empty text stands for the cluster's default.
struct SlurmRequest {
    std::string name; ///< as squeue shows it
    std::string partition, time, memory;
    int cpus = 1;                     ///< of each task
    std::vector<std::string> options; ///< further options of sbatch
    int tasks = 1;                    ///< of the array, numbered from 0
    std::vector<std::string> after;   ///< jobs that must end, well or not, before this begins
    std::string log_folder;           ///< the output of task T of job J goes to J_T.txt there
    std::string folder;               ///< working folder of the tasks
    std::string commands;             ///< for /bin/sh
};

/// Submits an array and returns its number. Throws InputError with sbatch's reason.
std::string slurm_submit(const SlurmRequest& request);

/// The maximum number of tasks in one array here. Throws InputError.
int slurm_array_limit();

/// One waiting or running task of an array.
struct SlurmTask {
    std::string job; ///< the array's number
    int task = 0;
    std::string state;  ///< PENDING, RUNNING ...
    std::string reason; ///< why it waits, "None" if it does not
};

/// The jobs' tasks that have not ended. Jobs that Slurm has forgotten count as ended. Throws
/// InputError.
std::vector<SlurmTask> slurm_queue(const std::vector<std::string>& jobs);

/// Removes arrays, or tasks of them ("12_3"), from the queue and ends their running tasks. Throws
/// InputError.
void slurm_cancel(const std::vector<std::string>& jobs);

} // namespace integral

#endif
