// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/memory.h"

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
/// stands in the number's place.
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

/// Names of the folder and the files of a version of control groups.
struct GroupVersion {
    const char* folder;
    const char *limit, *used, *cached; ///< `cached` is a word in the file memory.stat
};
constexpr GroupVersion version_1 = {"/sys/fs/cgroup/memory", "memory.limit_in_bytes",
                                    "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupVersion version_2 = {"/sys/fs/cgroup", "memory.max", "memory.current",
                                    "inactive_file"};

/// Bytes that the limits of the group at `path` and of the groups above it leave. In a container,
/// `path` may be the group's path on the host; the top folder is then the container's own group.
double free_of_groups(const std::string& root, const GroupVersion& version, std::string path)
{
    double least = unknown;
    while (!path.empty()) {
        const std::string folder = root + version.folder + (path == "/" ? "" : path) + "/";
        const double most = figure(folder + version.limit, "", unknown);
        if (most < unknown) {
            const double used = figure(folder + version.used, "", 0);
            const double cached = figure(folder + "memory.stat", version.cached, 0);
            least = std::min(least, most - used + cached);
        }
        if (path == "/")
            break;
        path.erase(std::max<std::size_t>(path.rfind('/'), 1));
    }
    return least;
}

/// Whether a list "a,b,c" has a word.
bool has_word(const std::string& list, const std::string& word)
{
    return ("," + list + ",").find("," + word + ",") != std::string::npos;
}

} // namespace

double free_of_control_groups(const std::string& root)
{
    std::ifstream groups(root + "/proc/self/cgroup");
    double least = unknown;
    // Each line is NUMBER:CONTROLLERS:PATH; version 2 has the line 0::PATH.
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos)
            continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string path = line.substr(second + 1);
        if (controllers.empty())
            least = std::min(least, free_of_groups(root, version_2, path));
        else if (has_word(controllers, "memory"))
            least = std::min(least, free_of_groups(root, version_1, path));
    }
    return least;
}

double free_memory_of_machine()
{
    return std::max(0.0, std::min(free_of_machine(), free_of_control_groups("")));
}

double free_memory()
{
    return std::max(0.0, std::min(free_memory_of_machine(), free_of_process()));
}

double resident_memory(const std::string& process)
{
    std::ifstream file("/proc/" + process + "/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return resident * double(sysconf(_SC_PAGESIZE));
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
