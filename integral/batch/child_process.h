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

constexpr int program_cannot_be_run = 127; ///< exit status, as a shell's

/// Exit and resource use of a child.
struct ChildEnd {
    int status = 0;       ///< exit status; -1 if a signal ended it
    int signal = 0;       ///< the signal that ended it, or 0
    double memory = 0;    ///< maximum memory, bytes
    double processor = 0; ///< seconds of all processors together
};

/// Path of this program.
std::string own_program();

/// One running program. The kernel kills it when this program ends, in whatever way.
class ChildProcess {
public:
    /// Starts the program of the first word (a path, or a name to find on PATH) in `folder`,
    /// without input; its output goes to the file `log`. Must be called by this program's first
    /// thread, as the child is killed when the thread that started it ends. Throws OutputError if
    /// the log cannot be written or no process can be made. A program that cannot be run ends with
    /// status program_cannot_be_run.
    ChildProcess(const std::vector<std::string>& words, const std::string& folder,
                 const std::string& log);
    /// Kills the program if it still runs.
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept : process_(other.process_) { other.process_ = -1; }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ChildProcess& operator=(ChildProcess&&) = delete;

    /// The program's end; empty while it runs. Must not be called again after it returned an end.
    std::optional<ChildEnd> ended();
    /// Waits for the child's end; must not be called twice. If this program is interrupted, stops
    /// the child, waits for its end and throws Interrupted. Calls `meanwhile`, if any, ten times a
    /// second.
    ChildEnd wait(const std::function<void()>& meanwhile = {});
    /// Sends SIGTERM.
    void stop();
    /// The child's current memory, bytes.
    double memory_now() const;

private:
    pid_t process_;
};

} // namespace integral

#endif
