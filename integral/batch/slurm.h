// SPDX-License-Identifier: AGPL-3.0-or-later
// Calls Slurm through its own programs: sbatch, squeue, scancel, scontrol. If they are missing, a
// message says so; no library of Slurm's is linked.
#ifndef INTEGRAL_BATCH_SLURM_H
#define INTEGRAL_BATCH_SLURM_H

#include <string>
#include <vector>

namespace integral {

/// A request for sbatch: an array of tasks. An empty text is the cluster's default.
struct SlurmRequest {
    std::string name; ///< as squeue shows it
    std::string partition, time, memory;
    int cpus = 1;                     ///< of each task
    std::vector<std::string> options; ///< more of sbatch's own
    int tasks = 1;                    ///< of the array, numbered from 0
    std::vector<std::string> after; ///< jobs that must have ended, well or not, before this begins
    std::string log_folder;         ///< what task T of job J prints goes to J_T.txt there
    std::string folder;             ///< in which the tasks run
    std::string commands;           ///< for /bin/sh
};

/// Submits an array and returns its number. Throws InputError with sbatch's reason.
std::string slurm_submit(const SlurmRequest& request);

/// The most tasks that one array may have here. Throws InputError.
int slurm_array_limit();

/// One task of an array that waits or runs.
struct SlurmTask {
    std::string job; ///< the array's number
    int task = 0;
    std::string state;  ///< PENDING, RUNNING ...
    std::string reason; ///< why it waits, "None" if it does not
};

/// Those of the jobs' tasks that have not ended. Jobs that Slurm has forgotten have ended. Throws
/// InputError.
std::vector<SlurmTask> slurm_queue(const std::vector<std::string>& jobs);

/// Takes arrays, or tasks of them ("12_3"), from the queue and ends what runs of them. Throws
/// InputError.
void slurm_cancel(const std::vector<std::string>& jobs);

} // namespace integral

#endif
