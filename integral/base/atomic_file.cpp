// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace integral {
namespace {

constexpr char unfinished_prefix[] = ".integral-";

/// The end of a temporary file's name, for a `process` of this machine and PID namespace.
std::string mark_of(long process)
{
    std::string host = host_name();
    std::replace(host.begin(), host.end(), '/', '-');
    return "." + host + "." + process_namespace() + "." + std::to_string(process);
}

/// The path in a symbolic link; empty if there is no link.
std::string link_at(const char* path)
{
    char text[PATH_MAX];
    const ssize_t length = readlink(path, text, sizeof text);
    return std::string(text, std::size_t(std::max<ssize_t>(0, length)));
}

/// Whether a file was last written so long ago (24 hours) that no process can still be writing it.
bool is_forgotten(const std::filesystem::directory_entry& file)
{
    std::error_code error;
    const auto written = file.last_write_time(error);
    return !error &&
           std::filesystem::file_time_type::clock::now() - written > std::chrono::hours(24);
}

/// sweep_unfinished(), the first time that this process writes to a folder.
void sweep_once(const std::string& folder)
{
    static std::mutex mutex;
    static std::set<std::string> swept;
    const std::lock_guard<std::mutex> lock(mutex);
    if (swept.insert(folder).second)
        sweep_unfinished(folder);
}

} // namespace

mode_t mode_for(const std::string& target)
{
    struct stat status;
    if (stat(target.c_str(), &status) == 0)
        return status.st_mode & 0777;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

int create_unfinished(const std::string& target, std::string& name)
{
    const auto slash = target.rfind('/');
    const std::string folder = slash == std::string::npos ? "./" : target.substr(0, slash + 1);
    sweep_once(folder);
    const std::string random = "XXXXXX", file = unfinished_name(random);
    name = folder + file;
    const int after = int(file.size() - file.find(random) - random.size());
    return mkostemps(&name[0], after, O_CLOEXEC);
}

std::string target_of(const std::string& path)
{
    char resolved[PATH_MAX];
    return realpath(path.c_str(), resolved) ? resolved : path;
}

bool is_special(const std::string& path)
{
    struct stat status;
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

AtomicFile::AtomicFile(const std::string& name, const std::string& target)
    : name_(name), target_(target)
{
}

AtomicFile::AtomicFile(const std::string& path) : target_(target_of(path))
{
    const int file = create_unfinished(target_, name_);
    if (file >= 0) {
        close(file);
        return;
    }
    name_.clear();
    finished_ = true; // nothing to delete
}

AtomicFile::~AtomicFile()
{
    if (!finished_)
        unlink(name_.c_str());
}

int AtomicFile::finish()
{
    if (chmod(name_.c_str(), mode_for(target_)) != 0 ||
        std::rename(name_.c_str(), target_.c_str()) != 0)
        return errno;
    finished_ = true;
    return 0;
}

std::string host_name()
{
    char name[256] = "";
    gethostname(name, sizeof name - 1);
    return name;
}

std::string process_namespace()
{
    if (link_at("/proc/self") != std::to_string(getpid()))
        return "";
    const std::string text = link_at("/proc/self/ns/pid"); // pid:[4026531836]
    const auto first = text.find_first_of("0123456789"), last = text.find_last_of("0123456789");
    return first == std::string::npos ? "" : text.substr(first, last + 1 - first);
}

std::string unfinished_name(const std::string& name)
{
    return unfinished_prefix + name + mark_of(getpid());
}

void sweep_unfinished(const std::string& folder)
{
    const bool can_ask = !process_namespace().empty();
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string(),
                          number = name.substr(name.rfind('.') + 1);
        if (name.rfind(unfinished_prefix, 0) != 0 || number.empty() || number.size() > 9 ||
            number.find_first_not_of("0123456789") != std::string::npos)
            continue;
        const long process = std::atol(number.c_str());
        const std::string mark = mark_of(process);
        const bool ours = can_ask && name.size() > mark.size() &&
                          name.compare(name.size() - mark.size(), mark.size(), mark) == 0;
        const bool ended = process > 0 && kill(pid_t(process), 0) != 0 && errno == ESRCH;
        if (ours ? ended : is_forgotten(entry))
            unlink(entry.path().c_str());
    }
}

} // namespace integral
