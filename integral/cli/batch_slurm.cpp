// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/batch_slurm.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/batch/batch_strips.h"
#include "integral/batch/slurm.h"
#include "integral/cli/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <thread>

namespace integral {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(2000),
               between_signals = std::chrono::milliseconds(50);
constexpr int most_strips = 10000;

/// What one task does, as its command line's end: "--only JOB", "--strip JOB:K", "--merge JOB",
/// "--summary".
using Task = std::string;

/// What was submitted in one go: an array.
struct Submission {
    std::string file, job;
    std::vector<Task> tasks;
};

std::string slurm_folder(const PlannedBatch& batch)
{
    return batch_folder(batch.manifest.output).own() + "/slurm";
}

std::vector<Submission> read_submissions(const std::string& folder)
{
    std::vector<Submission> all;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".json")
            try {
                const Json json = parse_json(read_file(entry.path()));
                all.push_back({entry.path(), json.at("job"), json.at("tasks")});
            } catch (const JsonError&) { // none of ours
            } catch (const Json::exception&) {
            }
    std::sort(all.begin(), all.end(),
              [](const Submission& a, const Submission& b) { return a.file < b.file; });
    return all;
}

/// A task in Slurm's queue.
struct Queued {
    std::string id; ///< as scancel and dependencies take it
    SlurmTask slurm;
};

/// What is in the queue of the batch's submissions, by task; the files of those that have ended are
/// deleted.
std::map<Task, Queued> queue_of(const std::string& folder)
{
    std::map<Task, Queued> queued;
    const auto submissions = read_submissions(folder);
    std::vector<std::string> jobs;
    for (const Submission& one : submissions)
        jobs.push_back(one.job);
    const auto tasks = slurm_queue(jobs);
    for (const Submission& one : submissions) {
        bool any = false;
        for (const SlurmTask& task : tasks) {
            const std::size_t index = std::size_t(std::max(task.task, 0));
            if (task.job != one.job || index >= one.tasks.size() ||
                task.state == "COMPLETING") // the program has ended
                continue;
            any = true;
            queued[one.tasks[index]] = {one.job + "_" + std::to_string(index), task};
        }
        std::error_code ignored;
        if (!any)
            for (const char* extension : {".json", ".txt"})
                std::filesystem::remove(
                    std::filesystem::path(one.file).replace_extension(extension), ignored);
    }
    return queued;
}

/// Submits a batch's tasks.
class Submitter {
public:
    Submitter(const options::variables_map& arguments, const PlannedBatch& batch,
              std::string folder)
        : folder_(std::move(folder)),
          limit_(slurm_array_limit()),
          manifest_(std::filesystem::absolute(batch.manifest.path)),
          log_(batch_folder(batch.manifest.output).path + "/logs/slurm")
    {
        if (batch.manifest.path == "-")
            throw UsageError(
                "a manifest from standard input cannot be submitted; put it into a file");
        std::filesystem::create_directories(folder_);
        std::filesystem::create_directories(log_);
        request_.name = one_line("integral:" +
                                 std::filesystem::path(batch.manifest.path).stem().string());
        request_.partition = text_of(arguments, "partition");
        request_.time = text_of(arguments, "time");
        if (batch.wanted.memory > 0)
            request_.memory = with_decimals(std::ceil(batch.wanted.memory / (1 << 20)), 0) + "M";
        request_.cpus = in_range(arguments, "cpus", 1, 4096);
        if (given(arguments, "sbatch"))
            request_.options = arguments["sbatch"].as<std::vector<std::string>>();
        request_.log_folder = log_;
        request_.folder = std::filesystem::current_path();
        retries_ = in_range(arguments, "retry", 0, 100);
    }

    /// Submits tasks that may run in any order, once the jobs `after` have ended; the numbers of
    /// the new jobs.
    std::vector<std::string> submit(const std::vector<Task>& tasks,
                                    const std::vector<std::string>& after)
    {
        std::vector<std::string> jobs;
        for (std::size_t first = 0; first < tasks.size(); first += std::size_t(limit_))
            jobs.push_back(submit_array(
                {tasks.begin() + std::ptrdiff_t(first),
                 tasks.begin() +
                     std::ptrdiff_t(std::min(tasks.size(), first + std::size_t(limit_)))},
                after));
        return jobs;
    }

    int tasks = 0, jobs = 0; ///< submitted so far

private:
    std::string submit_array(const std::vector<Task>& some, const std::vector<std::string>& after)
    {
        const std::string list = new_list(some);
        SlurmRequest request = request_;
        request.tasks = int(some.size());
        request.after = after;
        const std::string program = std::filesystem::read_symlink("/proc/self/exe");
        // A line of the list is an option and its value, without blanks in either.
        request.commands = "task=$(sed -n \"$((SLURM_ARRAY_TASK_ID + 1))p\" " + for_shell(list) +
                           ")\nexec " + for_shell(program) + " batch " + for_shell(manifest_) +
                           " --jobs " + std::to_string(request.cpus) + " --retry " +
                           std::to_string(retries_) + " $task\n";
        std::string job;
        try {
            job = slurm_submit(request);
        } catch (const InputError& error) {
            std::error_code ignored;
            std::filesystem::remove(list, ignored);
            throw InputError(error.what() +
                             std::string(tasks > 0 ? "; " + counted(tasks, "task") +
                                                         " submitted before: --follow or --cancel"
                                                   : ""));
        }
        write_file(std::filesystem::path(list).replace_extension(".json"),
                   Json{{"job", job}, {"tasks", some}}.dump() + "\n");
        tasks += int(some.size());
        ++jobs;
        return job;
    }

    /// The next free name for a list of tasks, with the list in it.
    std::string new_list(const std::vector<Task>& some) const
    {
        std::string text;
        for (const Task& task : some)
            text += task + "\n";
        for (int number = 1;; ++number) {
            char name[40];
            std::snprintf(name, sizeof name, "/tasks-%06d.txt", number);
            if (!std::filesystem::exists(folder_ + name)) {
                write_file(folder_ + name, text);
                return folder_ + name;
            }
        }
    }

    std::string folder_;
    int limit_;
    std::string manifest_, log_;
    SlurmRequest request_;
    int retries_;
};

const BatchStep& frame_of(const PlannedBatch& batch, int job)
{
    return *std::find_if(
        batch.plan.steps.begin(), batch.plan.steps.end(),
        [&](const BatchStep& step) { return step.job == job && step.kind == StepKind::frame; });
}

int job_called(const PlannedBatch& batch, const char* option, const std::string& name)
{
    for (std::size_t j = 0; j < batch.manifest.jobs.size(); ++j)
        if (batch.manifest.jobs[j].name == name)
            return int(j);
    throw UsageError(std::string("--") + option + " " + name +
                     ": there is no such job; --dry-run lists them");
}

/// A job's frame in strips: those that are not done and not in the queue, then what makes the frame
/// of them.
void submit_strips(const PlannedBatch& batch, int job, int number,
                   const std::map<Task, Queued>& queued, Submitter& submitter,
                   std::vector<std::string>& all)
{
    const BatchFolder folder = batch_folder(batch.manifest.output);
    const BatchStep& frame = frame_of(batch, job);
    const std::string& name = batch.manifest.jobs[std::size_t(job)].name;
    const StripPlan plan = plan_strips(folder, frame, batch.inputs.hash(frame, ""), number,
                                       batch.programs);
    const BatchPlan steps = strip_steps(frame, plan);
    std::vector<Task> tasks;
    std::vector<std::string> before;
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
    for (const std::string& one : submitter.submit(tasks, {})) {
        before.push_back(one);
        all.push_back(one);
    }
    if (!queued.count("--merge " + name))
        for (const std::string& one : submitter.submit({"--merge " + name}, before))
            all.push_back(one);
}

/// Returns whether every job was submitted, having said on standard error why not.
bool submit_batch(const options::variables_map& arguments, const PlannedBatch& batch)
{
    make_batch_folder(batch.manifest.output, batch.plan);
    std::filesystem::create_directories(batch_folder(batch.manifest.output).own() + "/strips");
    const int strips = given(arguments, "strips") ? in_range(arguments, "strips", 1, most_strips)
                                                  : 1;
    const auto results = survey(batch.manifest, batch.plan, batch.inputs, batch.wanted);
    const std::string folder = slurm_folder(batch);
    Submitter submitter(arguments, batch, folder);
    const auto queued = queue_of(folder);
    std::vector<Task> whole;
    std::vector<std::string> all;
    for (const auto& [task, one] : queued)
        all.push_back(one.id);
    std::set<int> in_strips, jobs;
    for (std::size_t i = 0; i < batch.plan.steps.size(); ++i) {
        const BatchStep& step = batch.plan.steps[i];
        if (results[i].fate != StepFate::waiting ||
            (!batch.wanted.jobs.empty() && !batch.wanted.jobs.count(step.job)))
            continue;
        jobs.insert(step.job);
        if (strips > 1 && step.kind == StepKind::frame)
            in_strips.insert(step.job);
    }
    bool good = true;
    for (const int job : jobs) {
        const std::string& name = batch.manifest.jobs[std::size_t(job)].name;
        if (queued.count("--only " + name) ||
            (queued.count("--merge " + name) && !in_strips.count(job)))
            continue;
        if (!in_strips.count(job)) {
            whole.push_back("--only " + name);
            continue;
        }
        try {
            submit_strips(batch, job, strips, queued, submitter, all);
        } catch (const InputError& error) {
            say("batch", error.what());
            good = false;
        }
    }
    for (const std::string& one : submitter.submit(whole, {}))
        all.push_back(one);
    const int tasks = submitter.tasks,
              in_queue = int(queued.size()) - int(queued.count("--summary"));
    if (tasks > 0 && batch.wanted.jobs.empty()) {
        if (queued.count("--summary"))
            slurm_cancel({queued.at("--summary").id});
        all.erase(std::remove_if(all.begin(), all.end(),
                                 [&](const std::string& id) {
                                     return queued.count("--summary") &&
                                            queued.at("--summary").id == id;
                                 }),
                  all.end());
        submitter.submit({"--summary"}, all);
    }
    std::cout << counted(tasks, "task") << " submitted, " << in_queue << " in the queue before\n"
              << std::flush;
    return good;
}

/// Waits until nothing of the batch is in the queue.
void follow(const PlannedBatch& batch)
{
    const std::string folder = slurm_folder(batch);
    const Progress progress = progress_bar("cluster");
    std::size_t most = 1;
    std::set<std::string> said;
    for (;;) {
        const auto queued = queue_of(folder);
        most = std::max(most, queued.size());
        for (const auto& [task, one] : queued)
            if (one.slurm.state == "PENDING" &&
                (one.slurm.reason.find("Limit") != std::string::npos ||
                 one.slurm.reason.find("NotAvail") != std::string::npos) &&
                said.insert(one.slurm.reason).second)
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

void cancel(const PlannedBatch& batch)
{
    const auto queued = queue_of(slurm_folder(batch));
    std::set<std::string> jobs;
    for (const auto& [task, one] : queued)
        jobs.insert(one.slurm.job);
    slurm_cancel({jobs.begin(), jobs.end()});
    std::cout << counted(int(queued.size()), "task") << " cancelled\n" << std::flush;
}

} // namespace

void add_slurm_options(options::options_description& all)
{
    all.add_options()("slurm", options::bool_switch(),
                      "submit what is not done, and not in the queue, to a Slurm cluster whose "
                      "nodes share these folders; again: what is left")(
        "follow", options::bool_switch(),
        "wait until the cluster has done it, then write the summary; an interrupt leaves the tasks "
        "in the queue")("cancel", options::bool_switch(),
                        "take the batch from the cluster's queue; what is done is kept")(
        "strips", options::value<int>()->value_name("N"),
        "with --slurm: render each frame in so many strips of rows, 1 to 10000, and join them")(
        "cpus", options::value<int>()->value_name("N")->default_value(1),
        "with --slurm: cores of each task")(
        "partition", options::value<std::string>()->value_name("NAME"),
        "with --slurm: the cluster's partition. --memory is each task's")(
        "time", options::value<std::string>()->value_name("TIME"),
        "with --slurm: the most that a task may take, minutes or DAYS-HOURS:MINUTES")(
        "sbatch", options::value<std::vector<std::string>>()->value_name("OPTION"),
        "with --slurm: one more option of sbatch's, as in --sbatch=--account=art; may be given "
        "again")("strip", options::value<std::string>()->value_name("JOB:K"),
                 "what a task does: render the K-th strip of a frame that --slurm has cut")(
        "merge", options::value<std::string>()->value_name("JOB"),
        "what a task does: make the frame of its strips, then all that is made of it");
}

AfterSlurm use_slurm(const options::variables_map& arguments, const PlannedBatch& batch)
{
    const bool submits = arguments["slurm"].as<bool>(), follows = arguments["follow"].as<bool>(),
               cancels = arguments["cancel"].as<bool>();
    if (cancels && (submits || follows))
        throw UsageError("--cancel goes alone");
    if (arguments["dry-run"].as<bool>() && (submits || follows || cancels))
        throw UsageError("--dry-run goes without --slurm, --follow and --cancel; what it says to "
                         "do is what --slurm submits");
    if (!submits && !arguments["cpus"].defaulted())
        throw UsageError("--cpus is for --slurm; --jobs says how many programs run here");
    if (!submits)
        for (const char* option : {"strips", "partition", "time", "sbatch"})
            if (given(arguments, option))
                throw UsageError(std::string("--") + option + " is for --slurm");
    if (cancels)
        cancel(batch);
    const bool good = !submits || submit_batch(arguments, batch);
    if (follows)
        follow(batch);
    if (!good && !follows)
        throw InputError("not every job could be submitted");
    return follows              ? AfterSlurm::summary
           : submits || cancels ? AfterSlurm::nothing
                                : AfterSlurm::run;
}

std::optional<bool> do_task(const options::variables_map& arguments, const PlannedBatch& batch,
                            std::set<int>& merged)
{
    const BatchFolder folder = batch_folder(batch.manifest.output);
    if (given(arguments, "merge")) {
        const int job = job_called(batch, "merge", text_of(arguments, "merge"));
        make_batch_folder(batch.manifest.output, batch.plan);
        const std::string reason = merge_frame(folder, frame_of(batch, job), batch.inputs);
        if (!reason.empty())
            say("batch", frame_of(batch, job).name + ": " + reason);
        merged = {job};
        return reason.empty();
    }
    if (!given(arguments, "strip"))
        return std::nullopt;
    const std::string text = text_of(arguments, "strip");
    const auto colon = text.rfind(':');
    const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (number.empty() || number.size() > 6 ||
        number.find_first_not_of("0123456789") != std::string::npos)
        throw UsageError("--strip " + text + ": JOB:K is expected, K from 1 on");
    const BatchStep& frame = frame_of(batch, job_called(batch, "strip", text.substr(0, colon)));
    const std::string inputs = batch.inputs.hash(frame, "");
    if (is_done(folder, frame, read_record(folder.record(frame)), inputs))
        return true;
    const auto plan = read_strip_plan(folder, frame, inputs);
    const std::size_t k = std::stoul(number);
    if (!plan || k < 1 || k > plan->strips.size())
        throw InputError(frame.name + ": " +
                         (plan ? "it has " + counted(int(plan->strips.size()), "strip")
                               : "it is not cut in strips, or its scene has changed since; --slurm "
                                 "--strips N does it"));
    BatchPlan one;
    one.steps = {strip_steps(frame, *plan).steps[k - 1]};
    RunOptions options = batch.wanted;
    options.jobs = {frame.job};
    const auto results = run_batch(batch.manifest, one, batch.inputs, options,
                                   progress_bar("strip"));
    return results[0].fate != StepFate::failed;
}

} // namespace integral
