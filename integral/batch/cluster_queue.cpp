// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/cluster_queue.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace integral {
namespace {

/// An array of tasks, as written by note_submission.
struct Submission {
    std::string file, job;
    std::vector<Task> tasks;
};

std::vector<Submission> read_submissions(const std::string& folder)
{
    std::vector<Submission> all;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".json")
            try {
                const Json json = parse_json(read_file(entry.path()));
                all.push_back({entry.path(), json.at("job"), json.at("tasks")});
            } catch (const JsonError&) { // another program's file
            } catch (const Json::exception&) {
            }
    std::sort(all.begin(), all.end(),
              [](const Submission& a, const Submission& b) { return a.file < b.file; });
    return all;
}

/// Adds the tasks of an array that are in the queue; returns whether there are any.
bool add_queued(const Submission& array, const std::vector<SlurmTask>& in_queue,
                std::map<Task, QueuedTask>& queued)
{
    bool any = false;
    for (const SlurmTask& task : in_queue) {
        const std::size_t index = std::size_t(std::max(task.task, 0));
        const bool has_ended = task.state == "COMPLETING"; // Slurm tidies up after it
        if (task.job != array.job || index >= array.tasks.size() || has_ended)
            continue;
        any = true;
        queued[array.tasks[index]] = {array.job + "_" + std::to_string(index), task};
    }
    return any;
}

} // namespace

std::string cluster_folder(const BatchFolder& folder) { return folder.own() + "/slurm"; }

std::string write_task_list(const BatchFolder& folder, const std::vector<Task>& tasks)
{
    std::string text;
    for (const Task& task : tasks)
        text += task + "\n";
    for (int number = 1;; ++number) {
        char name[40];
        std::snprintf(name, sizeof name, "/tasks-%06d.txt", number);
        const std::string path = cluster_folder(folder) + name;
        if (!std::filesystem::exists(path)) {
            write_file(path, text);
            return path;
        }
    }
}

void note_submission(const std::string& list, const std::string& job,
                     const std::vector<Task>& tasks)
{
    write_file(std::filesystem::path(list).replace_extension(".json"),
               Json{{"job", job}, {"tasks", tasks}}.dump() + "\n");
}

std::map<Task, QueuedTask> queued_tasks(const BatchFolder& folder)
{
    const auto submissions = read_submissions(cluster_folder(folder));
    std::vector<std::string> jobs;
    for (const Submission& one : submissions)
        jobs.push_back(one.job);
    const auto in_queue = slurm_queue(jobs);
    std::map<Task, QueuedTask> queued;
    for (const Submission& one : submissions)
        if (!add_queued(one, in_queue, queued))
            for (const char* extension : {".json", ".txt"}) {
                std::error_code ignored;
                std::filesystem::remove(
                    std::filesystem::path(one.file).replace_extension(extension), ignored);
            }
    return queued;
}

} // namespace integral
