// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/lock_file.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace integral {
namespace {

struct Holder {
    std::string host, boot;
    long process = 0;
    std::string begun;      ///< start in the kernel's ticks; needed as process numbers are reused
    std::string name_space; ///< the PID namespace of the number; empty: unknown
};

bool operator==(const Holder& a, const Holder& b)
{
    return a.host == b.host && a.boot == b.boot && a.process == b.process && a.begun == b.begun &&
           a.name_space == b.name_space;
}

std::string first_line(const std::string& path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

/// Start of a process in the kernel's ticks; empty if there is no such process.
std::string begin_of_process(long process)
{
    const std::string status = first_line("/proc/" + std::to_string(process) + "/stat");
    const auto name_end = status.rfind(')'); // the name before it may contain any character
    if (name_end == std::string::npos)
        return "";
    std::istringstream rest(status.substr(name_end + 1));
    std::string field, state;
    rest >> state;
    for (int i = 4; i <= 22; ++i)
        rest >> field;
    return state == "Z" ? "" : field;
}

Holder myself()
{
    return {host_name(), first_line("/proc/sys/kernel/random/boot_id"), long(getpid()),
            begin_of_process(getpid()), process_namespace()};
}

Holder holder_in(const std::string& path)
{
    Holder holder;
    try {
        const Json json = parse_json(read_file(path));
        holder = {json.at("host"), json.at("boot"), json.at("process"), json.at("begun"),
                  json.value("namespace", "")}; // earlier locks have none
    } catch (const InputError&) {
    } catch (const JsonError&) {
    } catch (const Json::exception&) {
    }
    return holder;
}

/// Whether a lock's holder has ended. `path` is the lock's file; `now` is the time of the file
/// system's clock.
bool is_dead(const Holder& holder, const std::string& path, const struct timespec& now)
{
    const Holder me = myself();
    const bool can_be_asked = holder.host == me.host && holder.name_space == me.name_space &&
                              !me.name_space.empty();
    if (can_be_asked && holder.boot == me.boot)
        return begin_of_process(holder.process) != holder.begun;
    if (can_be_asked && !holder.boot.empty())
        return true; // it ran before this machine's last start
    struct stat status;
    return stat(path.c_str(), &status) == 0 &&
           now.tv_sec - status.st_mtim.tv_sec > LockFile::seconds_of_silence;
}

/// Keeps other processes from judging and taking over locks at the same time, if the file system
/// supports flock. The kernel releases the guard when the process ends.
class Guard {
public:
    explicit Guard(const std::string& path)
        : descriptor_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
    {
        while (descriptor_ >= 0 && flock(descriptor_, LOCK_EX) != 0 && errno == EINTR)
            ;
    }
    ~Guard()
    {
        if (descriptor_ >= 0)
            close(descriptor_);
    }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

private:
    int descriptor_;
};

} // namespace

LockFile& LockFile::operator=(LockFile&& other) noexcept
{
    if (this != &other) {
        release();
        path_ = std::move(other.path_);
        other.path_.clear();
    }
    return *this;
}

bool LockFile::take(const std::string& path, std::string& holder)
{
    release();
    const auto slash = path.rfind('/');
    const Guard guard(path.substr(0, slash + 1) + "guard");
    const Holder me = myself();
    // The file is written under a name of its own and then linked to the lock's name: only one
    // process succeeds in that.
    const std::string own = path.substr(0, slash + 1) + unfinished_name("lock");
    const Json json{{"host", me.host},
                    {"process", me.process},
                    {"begun", me.begun},
                    {"boot", me.boot},
                    {"namespace", me.name_space}};
    write_file(own, json.dump() + "\n");
    struct stat status = {};
    stat(own.c_str(), &status);
    for (int round = 0; round < 2; ++round) {
        if (link(own.c_str(), path.c_str()) == 0) {
            path_ = path;
            break;
        }
        if (errno != EEXIST) {
            const int error = errno;
            unlink(own.c_str());
            throw OutputError(path + ": this folder cannot be locked: " + std::strerror(error));
        }
        const Holder other = holder_in(path);
        if (!is_dead(other, path, status.st_mtim)) {
            holder = other.process == 0
                         ? "another process"
                         : "process " + std::to_string(other.process) + " on " + other.host;
            break;
        }
        unlink(path.c_str());
    }
    unlink(own.c_str());
    return held();
}

void LockFile::refresh() const
{
    if (held())
        utimensat(AT_FDCWD, path_.c_str(), nullptr, 0);
}

void LockFile::release()
{
    if (held() && holder_in(path_) == myself()) // after a long silence another process may have
                                                // taken it over
        unlink(path_.c_str());
    path_.clear();
}

} // namespace integral
