// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs other programs as child processes.
#ifndef INTEGRAL_BATCH_CHILD_PROCESS_H
#define INTEGRAL_BATCH_CHILD_PROCESS_H

#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace integral {

constexpr int program_cannot_be_run = 127; ///< status, as a shell's

/// How a child ended.
struct ChildEnd {
    int status = 0;       ///< of exit; -1 if a signal ended it
    int signal = 0;       ///< that ended it, or 0
    double memory = 0;    ///< the most that it took, bytes
    double processor = 0; ///< seconds of all processors together
};

/// One running program. When this program ends, in whatever way, the kernel kills it.
class ChildProcess {
public:
    /// Starts the program of the first word (a path, or a name that is looked for on PATH) in
    /// `folder`, without input; what it prints goes to the file `log`. Must be called by this
    /// program's first thread, as the child is killed when the thread that started it ends. Throws
    /// OutputError if the log cannot be written or no process can be made. A program that cannot be
    /// run ends with status program_cannot_be_run.
    ChildProcess(const std::vector<std::string>& words, const std::string& folder,
                 const std::string& log);
    /// Kills it if it still runs.
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept : process_(other.process_) { other.process_ = -1; }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ChildProcess& operator=(ChildProcess&&) = delete;

    /// How it has ended; nothing while it runs. Must not be called again once it has ended.
    std::optional<ChildEnd> ended();
    /// Waits for its end; must not be called again. If this program is interrupted, asks it to end,
    /// waits for that, and throws Interrupted. Calls `meanwhile`, if any, ten times a second.
    ChildEnd wait(const std::function<void()>& meanwhile = {});
    /// Asks it to end.
    void stop();
    /// Bytes that it has in memory now.
    double memory_now() const;

private:
    pid_t process_;
};

} // namespace integral

#endif
