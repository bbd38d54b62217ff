// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/child_process.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/memory.h"
#include "integral/base/programs.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace integral {

std::string own_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

ChildProcess::ChildProcess(const std::vector<std::string>& words, const std::string& folder,
                           const std::string& log)
{
    const std::vector<char*> arguments = exec_arguments(words);
    const int said = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666),
              nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    const pid_t parent = getpid();
    process_ = said < 0 || nothing < 0 ? -1 : fork();
    const int error = errno;
    if (process_ == 0) { // only calls that are safe between fork and exec
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) // the parent ended before prctl
            _exit(program_cannot_be_run);
        dup2(nothing, 0);
        dup2(said, 1);
        dup2(said, 2);
        if (chdir(folder.c_str()) == 0)
            execvp(arguments[0], arguments.data());
        const char* why = std::strerror(errno);
        for (const char* text :
             {"Error: ", static_cast<const char*>(arguments[0]), " cannot be run: ", why, "\n"})
            if (write(2, text, std::strlen(text)) < 0)
                break;
        _exit(program_cannot_be_run);
    }
    if (said >= 0)
        close(said);
    if (nothing >= 0)
        close(nothing);
    if (process_ < 0)
        throw OutputError(log +
                          (said < 0 ? ": cannot be written: " : ": no process can be made: ") +
                          std::strerror(error));
}

ChildProcess::~ChildProcess()
{
    if (process_ > 0) {
        kill(process_, SIGKILL);
        wait_for_program(process_);
    }
}

std::optional<ChildEnd> ChildProcess::ended()
{
    int status = 0;
    struct rusage usage = {};
    const pid_t ended = wait4(process_, &status, WNOHANG, &usage);
    if (ended == 0 || (ended < 0 && errno == EINTR))
        return std::nullopt;
    process_ = -1;
    ChildEnd end;
    end.status = ended > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    end.signal = ended > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.memory = double(usage.ru_maxrss) * 1024;
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
        end.processor += double(time.tv_sec) + 1e-6 * double(time.tv_usec);
    return end;
}

ChildEnd ChildProcess::wait(const std::function<void()>& meanwhile)
{
    constexpr int naps_between = 20;
    bool told = false; // the interrupt may not have reached the child
    for (int nap = 0;; ++nap) {
        if (const auto end = ended()) {
            stop_if_interrupted();
            return *end;
        }
        if (interrupted() && !told) {
            stop();
            told = true;
        }
        if (meanwhile && nap % naps_between == 0)
            meanwhile();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

void ChildProcess::stop() { kill(process_, SIGTERM); }

double ChildProcess::memory_now() const { return resident_memory(std::to_string(process_)); }

} // namespace integral
