// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/memory.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace integral {
namespace {

constexpr double unknown = 1e300;

/// The number after `word` in a file like /proc/meminfo; use the word "" for a file that begins
/// with the number. Returns `otherwise` if the file or the word is missing, or if "max" (no limit)
/// stands for the number.
double figure(const std::string& file, const std::string& word, double otherwise)
{
    std::ifstream lines(file);
    std::string name;
    double value;
    if (word.empty())
        return lines >> value ? value : otherwise;
    for (std::string rest; lines >> name; std::getline(lines, rest))
        if (name == word)
            return lines >> value ? value : otherwise;
    return otherwise;
}

double free_of_machine()
{
    constexpr double kilobyte = 1024;
    const double available = figure("/proc/meminfo", "MemAvailable:", -1);
    return available >= 0 ? available * kilobyte : unknown;
}

/// Bytes that the process may still allocate under RLIMIT_AS.
double free_of_process()
{
    rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return unknown;
    const double pages = figure("/proc/self/statm", "", 0); // the first number: mapped pages
    return double(limit.rlim_cur) - pages * double(sysconf(_SC_PAGESIZE));
}

/// Bytes that the process may still allocate under the limits of its control group and the groups
/// above it (cgroup version 2). File cache counts as free.
double free_of_group()
{
    std::ifstream groups("/proc/self/cgroup");
    std::string line, path;
    while (std::getline(groups, line))
        if (line.rfind("0::", 0) == 0)
            path = line.substr(3);
    double least = unknown;
    while (!path.empty()) {
        const std::string folder = "/sys/fs/cgroup" + (path == "/" ? "" : path) + "/memory.";
        const double most = figure(folder + "max", "", unknown);
        if (most < unknown) {
            const double used = figure(folder + "current", "", 0);
            const double cached = figure(folder + "stat", "inactive_file", 0);
            least = std::min(least, most - used + cached);
        }
        if (path == "/")
            break;
        path.erase(std::max<std::size_t>(path.rfind('/'), 1));
    }
    return least;
}

} // namespace

double free_memory()
{
    return std::max(0.0, std::min({free_of_machine(), free_of_process(), free_of_group()}));
}

void check_memory(double bytes)
{
    const double free = free_memory();
    if (bytes <= free)
        return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "it needs %.3g GB of memory, and %.3g GB are free; a smaller picture would do",
                  bytes / 1e9, free / 1e9);
    throw std::runtime_error(text);
}

} // namespace integral
