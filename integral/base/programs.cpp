// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/programs.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace integral {

std::optional<std::string> program_on_path(const std::string& name)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + name).c_str(), X_OK) == 0)
            return std::filesystem::weakly_canonical(folder + "/" + name).string();
    return std::nullopt;
}

std::vector<char*> exec_arguments(const std::vector<std::string>& words)
{
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    return arguments;
}

StartedProgram start_program(const std::vector<std::string>& words, int input, int output,
                             int errors)
{
    const std::vector<char*> arguments = exec_arguments(words);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    int number = 0;
    for (const int file : {input, output, errors}) {
        if (file >= 0)
            posix_spawn_file_actions_adddup2(&actions, file, number);
        else
            posix_spawn_file_actions_addopen(&actions, number, "/dev/null",
                                             number == 0 ? O_RDONLY : O_WRONLY, 0);
        ++number;
    }
    StartedProgram started;
    started.error = posix_spawnp(&started.process, arguments[0], &actions, nullptr,
                                 arguments.data(), environ);
    if (started.error)
        started.process = -1;
    posix_spawn_file_actions_destroy(&actions);
    return started;
}

int wait_for_program(pid_t process)
{
    int status = -1;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR)
        ;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace integral
