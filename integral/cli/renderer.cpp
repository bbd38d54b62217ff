// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/renderer.h"

#include "integral/cli/progress.h"
#include "integral/io/file_bytes.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace integral {

ScratchFolder::ScratchFolder()
{
    const char* place = std::getenv("TMPDIR");
    path_ = std::string(place && *place ? place : "/tmp") + "/integral.XXXXXX";
    if (!mkdtemp(path_.data()))
        throw OutputError(path_ + ": cannot be made: " + std::strerror(errno));
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

namespace {

constexpr char name[] = "povray-integral";

} // namespace

std::string renderer_program()
{
    std::error_code error;
    const auto own = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto beside = own.parent_path() / name;
    return !error && access(beside.c_str(), X_OK) == 0 ? beside.string() : name;
}

std::string reason_in(const std::string& said)
{
    std::string last;
    for (std::size_t begin = 0; begin < said.size();) {
        std::size_t end = said.find('\n', begin);
        end = end == std::string::npos ? said.size() : end;
        std::string line = said.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t error = line.find("rror:");
        if (error != std::string::npos) {
            // A line goes on in those that begin with a blank.
            while (begin < said.size() && said[begin] == ' ') {
                end = said.find('\n', begin);
                end = end == std::string::npos ? said.size() : end;
                line += said.substr(begin, end - begin);
                begin = end + 1;
            }
            return line;
        }
        if (line.find_first_not_of(" \r") != std::string::npos)
            last = line;
    }
    return last;
}

namespace {

/// Waits for its end and returns its status. An interrupt of this program is passed on, as it may have come to this one alone.
int wait_for(pid_t child)
{
    int status = 0;
    bool told = false;
    for (pid_t ended = 0; ended == 0 || (ended < 0 && errno == EINTR);) {
        if (interrupted() && !told)
            told = kill(child, SIGTERM) == 0;
        ended = waitpid(child, &status, WNOHANG); // and not until it ends: a signal just before would go unnoticed
        if (ended == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return status;
}

} // namespace

void render(const std::string& what, const std::vector<std::string>& options, const ScratchFolder& scratch)
{
    const std::string program = renderer_program(), log = scratch.path("said.txt");
    std::vector<std::string> words = options;
    words.insert(words.begin(), name);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    pid_t child;
    const int failed = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed)
        throw InputError(what + ": povray-integral cannot be run: " + std::strerror(failed) + "; it belongs beside this program, or on PATH");
    const int status = wait_for(child);
    stop_if_interrupted();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw InputError(what + ": it cannot be rendered: " + reason_in(read_file(log)));
}

} // namespace integral
