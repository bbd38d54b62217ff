// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/renderer.h"

#include "integral/batch/child_process.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <unistd.h>

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

InputError no_renderer(const std::string& said)
{
    const std::string before = "cannot be run: ";
    const auto place = said.find(before);
    const std::string reason = reason_in(
        place == std::string::npos ? said : said.substr(place + before.size()));
    return InputError("povray-integral cannot be run: " + reason +
                      "; it belongs beside this program, or on PATH");
}

void render(const std::string& what, const std::vector<std::string>& options,
            const ScratchFolder& scratch)
{
    std::vector<std::string> words = options;
    words.insert(words.begin(), renderer_program());
    const std::string log = scratch.path("said.txt");
    const ChildEnd end = ChildProcess(words, ".", log).wait();
    if (end.status == program_cannot_be_run)
        throw InputError(what + ": " + no_renderer(read_file(log)).what());
    if (end.status != 0)
        throw InputError(what + ": it cannot be rendered: " + reason_in(read_file(log)));
}

} // namespace integral
