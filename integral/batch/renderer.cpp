// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/renderer.h"

#include "integral/base/programs.h"
#include "integral/batch/renderer_options.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
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

void become_renderer(const std::vector<std::string>& words)
{
    const std::string program = renderer_program();
    std::vector<std::string> line = {program};
    line.insert(line.end(), words.begin(), words.end());
    execvp(program.c_str(), exec_arguments(line).data());
    throw no_renderer(program + ": " + std::strerror(errno));
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
            // Lines that begin with a blank continue the line before.
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

std::vector<std::string> scene_words(const std::string& scene,
                                     const std::vector<std::string>& options)
{
    if (scene == "-" || is_special(scene))
        throw InputError(scene +
                         ": a pipe can be read only once, and this scene is rendered several "
                         "times; save it as a file");
    const std::string why = unopenable_name(scene);
    if (!why.empty())
        throw InputError(scene + ": " + why);
    std::vector<std::string> words;
    const std::string folder = std::filesystem::path(scene).parent_path().string();
    if (!folder.empty() && std::filesystem::exists(without_section(scene)))
        words.push_back("+L\"" + folder + "\"");
    words.push_back((names_settings(scene) ? "" : "+I") + quoted(scene));
    for (const char* word : {"-D", "+KFI1", "+KFF1"})
        words.push_back(word);
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

double rendered_part(const std::string& said)
{
    constexpr std::streamoff some = 4096;
    std::ifstream file(said, std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    if (!file || size <= 0)
        return 0;
    std::string text(std::size_t(std::min(some, size)), '\0');
    file.seekg(-std::streamoff(text.size()), std::ios::end);
    file.read(text.data(), std::streamsize(text.size()));
    double done = 0, all = 0;
    for (auto at = text.rfind("Rendered "); at != std::string::npos;
         at = at > 0 ? text.rfind("Rendered ", at - 1) : std::string::npos)
        if (std::sscanf(text.c_str() + at, "Rendered %lf of %lf pixels", &done, &all) == 2)
            return all > 0 ? std::clamp(done / all, 0.0, 1.0) : 0;
    return 0;
}

ChildEnd render(const std::string& what, const std::vector<std::string>& options,
                const ScratchFolder& scratch, const Progress& progress)
{
    std::vector<std::string> words = options;
    words.insert(words.begin(), renderer_program());
    const std::string log = scratch.path("said.txt");
    const auto tell = [&] { progress(int(100 * rendered_part(log)), 100); };
    const ChildEnd end = ChildProcess(words, ".", log)
                             .wait(progress ? std::function(tell) : std::function<void()>());
    if (progress)
        progress(100, 100);
    if (end.status == program_cannot_be_run)
        throw InputError(what + ": " + no_renderer(read_file(log)).what());
    if (end.status != 0)
        throw InputError(what + (std::filesystem::exists(without_section(what))
                                     ? ": it cannot be rendered: " + reason_in(read_file(log))
                                     : ": cannot be read: it is neither here nor where "
                                       "povray-integral looks for scenes; +LFOLDER adds a folder"));
    return end;
}

} // namespace integral
