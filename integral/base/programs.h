// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds and starts programs.
#ifndef INTEGRAL_BASE_PROGRAMS_H
#define INTEGRAL_BASE_PROGRAMS_H

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace integral {

/// The path of the program that a bare name runs, found on PATH; nothing if there is none.
std::optional<std::string> program_on_path(const std::string& name);

/// The process of a program, or why there is none.
struct StartedProgram {
    pid_t process = -1; ///< greater than 0 if the program was started
    int error = 0;      ///< errno otherwise
};

/// A program's words as the functions of exec take them. They point into `words`, and a null
/// pointer follows them.
std::vector<char*> exec_arguments(const std::vector<std::string>& words);

/// Starts the program of the first word (a path, or a name to find on PATH). Its standard input,
/// output and error are the given file descriptors, or /dev/null for -1.
StartedProgram start_program(const std::vector<std::string>& words, int input = -1, int output = -1,
                             int errors = -1);

/// Waits for a process to end. Returns its exit status, or 128 + the number of the signal that
/// ended it, or 255 if the status is not available.
int wait_for_program(pid_t process);

} // namespace integral

#endif
