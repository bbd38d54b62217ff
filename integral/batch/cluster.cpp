// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/cluster.h"

#include "integral/base/file_bytes.h"
#include "integral/base/folders.h"
#include "integral/base/interrupt.h"
#include "integral/base/message_text.h"
#include "integral/base/number_text.h"
#include "integral/batch/batch_strips.h"
#include "integral/batch/child_process.h"
#include "integral/batch/cluster_queue.h"
#include "integral/io/markup.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

namespace integral {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(2000),
               between_signals = std::chrono::milliseconds(50);

using Queue = std::map<Task, QueuedTask>;

void append(Names& all, const Names& more) { all.insert(all.end(), more.begin(), more.end()); }

/// The common part of all requests for a batch.
SlurmRequest request_for(const PlannedBatch& batch, const RunOptions& requested,
                         const ClusterOptions& cluster)
{
    SlurmRequest request;
    request.name = one_line("integral:" +
                            std::filesystem::path(batch.manifest.path).stem().string());
    request.partition = cluster.partition;
    request.time = cluster.time;
    if (requested.memory > 0)
        request.memory = with_decimals(std::ceil(requested.memory / (1 << 20)), 0) + "M";
    request.cpus = cluster.cpus;
    request.options = cluster.sbatch;
    request.log_folder = batch.folder.path + "/logs/slurm";
    request.folder = std::filesystem::current_path();
    return request;
}

/// Submits a batch's tasks, in arrays as long as the cluster allows.
class Submitter {
public:
    Submitter(const PlannedBatch& batch, const RunOptions& requested, const ClusterOptions& cluster)
        : batch_(batch),
          limit_(std::size_t(slurm_array_limit())),
          retries_(requested.retries),
          request_(request_for(batch, requested, cluster))
    {
        make_folder(cluster_folder(batch.folder));
        make_folder(request_.log_folder);
    }

    /// Submits tasks that may run in any order, to begin after the Slurm jobs `after` have ended.
    /// Returns the new arrays' numbers.
    Names submit(const std::vector<Task>& tasks, const Names& after)
    {
        Names arrays;
        for (std::size_t first = 0; first < tasks.size(); first += limit_) {
            const std::size_t end = std::min(tasks.size(), first + limit_);
            arrays.push_back(submit_array(
                {tasks.begin() + std::ptrdiff_t(first), tasks.begin() + std::ptrdiff_t(end)},
                after));
        }
        return arrays;
    }

    int tasks() const { return tasks_; } ///< submitted so far

private:
    std::string submit_array(const std::vector<Task>& some, const Names& after)
    {
        const std::string list = write_task_list(batch_.folder, some);
        SlurmRequest request = request_;
        request.tasks = int(some.size());
        request.after = after;
        request.commands = commands_for(list);
        std::string array;
        try {
            array = slurm_submit(request);
        } catch (const InputError& error) {
            std::error_code ignored;
            std::filesystem::remove(list, ignored);
            throw InputError(error.what() +
                             std::string(tasks_ > 0 ? "; " + counted(tasks_, "task") +
                                                          " submitted before: --follow or --cancel"
                                                    : ""));
        }
        note_submission(list, array, some);
        tasks_ += int(some.size());
        return array;
    }

    /// The shell commands of each task. They run this program with the words of the task's line in
    /// `list`: an option, and its value if any, without blanks.
    std::string commands_for(const std::string& list) const
    {
        const std::string program = own_program();
        const std::string manifest = std::filesystem::absolute(batch_.manifest.path);
        return "task=$(sed -n \"$((SLURM_ARRAY_TASK_ID + 1))p\" " + for_shell(list) + ")\nexec " +
               for_shell(program) + " batch " + for_shell(manifest) + " --jobs " +
               std::to_string(request_.cpus) + " --retry " + std::to_string(retries_) + " $task\n";
    }

    const PlannedBatch& batch_;
    std::size_t limit_;
    int retries_;
    SlurmRequest request_;
    int tasks_ = 0;
};

/// Jobs to make. `in_strips`: those jobs whose frame has to be made in strips.
struct JobsToMake {
    std::set<int> all, in_strips;
};

JobsToMake jobs_to_make(PlannedBatch& batch, const RunOptions& requested, int strips)
{
    JobsToMake jobs;
    const auto results = survey(batch, requested);
    for (std::size_t i = 0; i < batch.plan.steps.size(); ++i) {
        const BatchStep& step = batch.plan.steps[i];
        if (results[i].fate != StepFate::waiting ||
            (!requested.jobs.empty() && !requested.jobs.count(step.job)))
            continue;
        jobs.all.insert(step.job);
        if (strips > 1 && step.kind == StepKind::frame)
            jobs.in_strips.insert(step.job);
    }
    return jobs;
}

/// Submits the strips of a job's frame that are neither done nor in the queue, then the task that
/// joins them and makes the job's other steps. Adds the new arrays to `added`, even if it throws.
void submit_strips(PlannedBatch& batch, int job, int number, const Queue& queued,
                   Submitter& submitter, Names& added)
{
    const BatchFolder& folder = batch.folder;
    const std::string& name = batch.job(job).name;
    const BatchPlan steps = strip_steps(batch.frame_of(job), plan_strips(batch, job, number));
    std::vector<Task> tasks;
    Names before;
    for (std::size_t k = 0; k < steps.steps.size(); ++k) {
        const BatchStep& strip = steps.steps[k];
        const Task task = "--strip " + name + ":" + std::to_string(k + 1);
        const auto there = queued.find(task);
        if (there != queued.end())
            before.push_back(there->second.id);
        else if (!is_done(folder, strip, read_record(folder.record(strip)),
                          batch.inputs.hash(strip, "")))
            tasks.push_back(task);
    }
    const Names arrays = submitter.submit(tasks, {});
    append(before, arrays);
    append(added, arrays);
    if (!queued.count("--merge " + name))
        append(added, submitter.submit({"--merge " + name}, before));
}

/// Submits the task that writes the summary, to begin after the queued tasks and the arrays `added`
/// have ended. Cancels a summary task that is already queued.
void submit_summary(const Queue& queued, const Names& added, Submitter& submitter)
{
    Names after;
    for (const auto& [task, one] : queued)
        if (task == "--summary")
            slurm_cancel({one.id});
        else
            after.push_back(one.id);
    append(after, added);
    submitter.submit({"--summary"}, after);
}

/// Whether a task waits because of a limit of the cluster or the account.
bool is_held_by_limit(const SlurmTask& task)
{
    return task.state == "PENDING" && (task.reason.find("Limit") != std::string::npos ||
                                       task.reason.find("NotAvail") != std::string::npos);
}

} // namespace

Submitted submit_batch(PlannedBatch& batch, const RunOptions& requested,
                       const ClusterOptions& cluster)
{
    make_batch_folder(batch.manifest.output, batch.plan);
    make_folder(batch.folder.own() + "/strips");
    const JobsToMake jobs = jobs_to_make(batch, requested, cluster.strips);
    Submitter submitter(batch, requested, cluster);
    const Queue queued = queued_tasks(batch.folder);
    Submitted submitted;
    std::vector<Task> whole; // jobs
    Names added;             // arrays
    for (const int job : jobs.all) {
        const std::string& name = batch.job(job).name;
        const bool in_strips = jobs.in_strips.count(job);
        if (queued.count("--only " + name) || (queued.count("--merge " + name) && !in_strips))
            continue;
        if (!in_strips) {
            whole.push_back("--only " + name);
            continue;
        }
        try {
            submit_strips(batch, job, cluster.strips, queued, submitter, added);
        } catch (const InputError& error) {
            say("batch", error.what());
            submitted.every_job = false;
        }
    }
    append(added, submitter.submit(whole, {}));
    submitted.tasks = submitter.tasks();
    submitted.queued_before = int(queued.size()) - int(queued.count("--summary"));
    if (submitted.tasks > 0 && requested.jobs.empty())
        submit_summary(queued, added, submitter);
    return submitted;
}

void follow_batch(const PlannedBatch& batch, const Progress& progress)
{
    std::size_t most = 1;
    std::set<std::string> said;
    for (;;) {
        const Queue queued = queued_tasks(batch.folder);
        most = std::max(most, queued.size());
        for (const auto& [task, one] : queued)
            if (is_held_by_limit(one.slurm) && said.insert(one.slurm.reason).second)
                say("batch", "Slurm lets tasks wait: " + one.slurm.reason);
        const bool going = progress(int(most - queued.size()), int(most));
        if (queued.empty())
            return;
        if (!going)
            throw Interrupted();
        for (auto waited = between_signals; waited < between_looks && !interrupted();
             waited += between_signals)
            std::this_thread::sleep_for(between_signals);
    }
}

int cancel_batch(const PlannedBatch& batch)
{
    const Queue queued = queued_tasks(batch.folder);
    std::set<std::string> arrays;
    for (const auto& [task, one] : queued)
        arrays.insert(one.slurm.job);
    slurm_cancel({arrays.begin(), arrays.end()});
    return int(queued.size());
}

} // namespace integral
