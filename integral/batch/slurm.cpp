// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/slurm.h"

#include "integral/base/file_bytes.h"
#include "integral/base/programs.h"
#include "integral/io/markup.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <unistd.h>

namespace integral {
namespace {

/// Output and exit status of a program.
struct Said {
    int status;
    std::string output, errors;
};

/// A pipe; the destructor closes its ends.
struct Pipe {
    Pipe()
    {
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw InputError(std::string("Slurm's programs cannot be run: ") +
                             std::strerror(errno));
    }
    ~Pipe()
    {
        shut(0);
        shut(1);
    }
    void shut(int end)
    {
        if (ends[end] >= 0)
            close(ends[end]);
        ends[end] = -1;
    }
    int ends[2];
};

/// Reads both pipes to their ends.
void read_both(Pipe& first, std::string& first_text, Pipe& second, std::string& second_text)
{
    pollfd open[2] = {{first.ends[0], POLLIN, 0}, {second.ends[0], POLLIN, 0}};
    std::string* texts[2] = {&first_text, &second_text};
    while (open[0].fd >= 0 || open[1].fd >= 0) {
        if (poll(open, 2, -1) < 0 && errno != EINTR)
            return;
        for (int k = 0; k < 2; ++k)
            if (open[k].fd >= 0 && open[k].revents) {
                char buffer[4096];
                const ssize_t count = read(open[k].fd, buffer, sizeof buffer);
                if (count > 0)
                    texts[k]->append(buffer, std::size_t(count));
                else if (count == 0 || errno != EINTR)
                    open[k].fd = -1;
            }
    }
}

/// Runs a Slurm program, found on PATH, with `input` on its standard input: a script shorter than a
/// pipe's buffer.
Said run(const std::vector<std::string>& words, const std::string& input = "")
{
    Pipe in, out, errors;
    const StartedProgram child = start_program(words, in.ends[0], out.ends[1], errors.ends[1]);
    if (child.error)
        throw InputError(words[0] + ": it cannot be run: " + std::strerror(child.error) +
                         "; batches on a cluster need Slurm's own programs on PATH (Debian's "
                         "package slurm-client)");
    in.shut(0);
    out.shut(1);
    errors.shut(1);
    if (!input.empty() && write(in.ends[1], input.data(), input.size()) != ssize_t(input.size()))
        errno = 0; // the program has ended already, and its output has the reason
    in.shut(1);
    Said said{0, "", ""};
    read_both(out, said.output, errors, said.errors);
    said.status = wait_for_program(child.process);
    return said;
}

/// The messages of a program, joined to one line.
std::string reason_of(const Said& said)
{
    std::string text = said.errors.empty() ? said.output : said.errors;
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    for (char& c : text)
        if (c == '\n')
            c = ' ';
    return text.empty() ? "it ended with status " + std::to_string(said.status) : text;
}

[[noreturn]] void refuse(const char* program, const Said& said)
{
    throw InputError(std::string(program) + ": " + reason_of(said));
}

std::string joined(const std::vector<std::string>& words, char separator)
{
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : std::string(1, separator)) + word;
    return text;
}

/// Whether Slurm does not know a job: it forgets jobs some minutes after their end.
bool says_unknown(const Said& said)
{
    return said.errors.find("Invalid job id") != std::string::npos;
}

/// Parses squeue's output in slurm_queue's format.
std::vector<SlurmTask> tasks_in(const std::string& text)
{
    std::vector<SlurmTask> tasks;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::string id;
        SlurmTask task;
        if (!std::getline(fields, id, '|') || !std::getline(fields, task.state, '|') ||
            !std::getline(fields, task.reason))
            continue;
        const auto bar = id.find('_');
        task.job = id.substr(0, bar);
        if (bar != std::string::npos)
            task.task = std::atoi(id.c_str() + bar + 1);
        tasks.push_back(task);
    }
    return tasks;
}

bool has_backslash(const std::string& text) { return text.find('\\') != std::string::npos; }

/// Slurm's pattern for the names of the tasks' output files. A % in the folder's name is written
/// %%. Slurm expands no pattern with a backslash; redirection() then names the file in the script.
std::string log_pattern(const std::string& folder)
{
    if (has_backslash(folder))
        return "/dev/null";
    std::string pattern;
    for (const char c : folder)
        pattern += c == '%' ? "%%" : std::string(1, c);
    return pattern + "/%A_%a.txt";
}

/// The first line of a task's script if no pattern can name the folder; otherwise empty.
std::string redirection(const std::string& folder)
{
    if (!has_backslash(folder))
        return "";
    return "exec >> " + for_shell(folder) +
           "/\"${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID.txt\" 2>&1\n";
}

} // namespace

std::string slurm_submit(const SlurmRequest& request)
{
    std::vector<std::string> words{"sbatch",
                                   "--parsable",
                                   "--job-name=" + request.name,
                                   "--output=" + log_pattern(request.log_folder),
                                   "--chdir=" + request.folder,
                                   "--ntasks=1",
                                   "--cpus-per-task=" + std::to_string(request.cpus),
                                   "--open-mode=append"};
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty())
            words.push_back(std::string(option) + value);
    };
    add("--partition=", request.partition);
    add("--time=", request.time);
    add("--mem=", request.memory);
    words.push_back("--array=0-" + std::to_string(request.tasks - 1));
    add("--dependency=afterany:", joined(request.after, ':'));
    words.insert(words.end(), request.options.begin(), request.options.end());
    const Said said = run(words,
                          "#!/bin/sh\n" + redirection(request.log_folder) + request.commands);
    const std::string number = said.output.substr(
        0, said.output.find_first_of(";\n")); // NUMBER[;CLUSTER]
    if (said.status != 0 || number.empty() ||
        number.find_first_not_of("0123456789") != std::string::npos)
        refuse("sbatch", said);
    return number;
}

int slurm_array_limit()
{
    const Said said = run({"scontrol", "show", "config"});
    const std::string name = "MaxArraySize";
    const auto place = said.output.find(name);
    if (said.status != 0 || place == std::string::npos)
        refuse("scontrol", said);
    const int limit = std::atoi(said.output.c_str() + said.output.find('=', place) +
                                1); // the largest index plus 1
    if (limit < 1)
        throw InputError("scontrol: Slurm allows no job arrays here (MaxArraySize is " +
                         std::to_string(limit) + ")");
    return limit;
}

std::vector<SlurmTask> slurm_queue(const std::vector<std::string>& jobs)
{
    std::vector<SlurmTask> tasks;
    if (jobs.empty())
        return tasks;
    const auto ask = [](const std::string& ids) {
        return run({"squeue", "--noheader", "--array", "--format=%i|%T|%r", "--jobs=" + ids});
    };
    Said said = ask(joined(jobs, ','));
    if (said.status == 0)
        return tasks_in(said.output);
    if (!says_unknown(said))
        refuse("squeue", said);
    for (const std::string& job : jobs) {
        said = ask(job);
        if (said.status != 0 && !says_unknown(said))
            refuse("squeue", said);
        if (said.status == 0)
            for (SlurmTask& task : tasks_in(said.output))
                tasks.push_back(std::move(task));
    }
    return tasks;
}

void slurm_cancel(const std::vector<std::string>& jobs)
{
    if (jobs.empty())
        return;
    std::vector<std::string> words{"scancel"};
    words.insert(words.end(), jobs.begin(), jobs.end());
    const Said said = run(words);
    if (said.status != 0 && !says_unknown(said))
        refuse("scancel", said);
}

} // namespace integral
