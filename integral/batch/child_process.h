// SPDX-License-Identifier: AGPL-3.0-or-later
// Other programs, run beside this one.
#ifndef INTEGRAL_BATCH_CHILD_PROCESS_H
#define INTEGRAL_BATCH_CHILD_PROCESS_H

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace integral {

constexpr int program_cannot_be_run = 127; ///< status, as a shell's

/// How a child ended.
struct ChildEnd {
    int status = 0;    ///< of exit; -1 if a signal ended it
    int signal = 0;    ///< that ended it, or 0
    double memory = 0; ///< bytes, the most that it had
};

/// One running program. It does not outlive this one: the kernel kills it then, however this
/// program ends.
class ChildProcess {
public:
    /// Starts `words` (the first one is the program: a path, or a name to be looked for on PATH) in
    /// `folder`, without input; what it says goes to the file `log`. To be called by the program's
    /// first thread, whose end is what the child dies of. Throws OutputError where the log cannot
    /// be written or no process can be made; a program that cannot be run ends with status
    /// program_cannot_be_run.
    ChildProcess(const std::vector<std::string>& words, const std::string& folder,
                 const std::string& log);
    /// Kills it if it still runs.
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept : process_(other.process_) { other.process_ = -1; }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ChildProcess& operator=(ChildProcess&&) = delete;

    /// Looks whether it has ended; once it has, not to be called again.
    std::optional<ChildEnd> ended();
    /// Waits for its end; not to be called again. Throws Interrupted, having asked it to end and
    /// waited for that.
    ChildEnd wait();
    /// Asks it to end.
    void stop();
    /// Bytes that it has in memory now.
    double memory_now() const;

private:
    pid_t process_;
};

} // namespace integral

#endif
