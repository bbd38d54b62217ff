// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/renderer.h"

#include "integral/base/file_bytes.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <regex>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace integral::bench {

namespace {

/// This process's environment, changed so that the renderer reads the INI file `ini` and none of
/// the user's.
std::vector<std::string> environment_with(const std::string& ini)
{
    std::vector<std::string> result{"POVINI=" + ini};
    for (char** variable = environ; *variable; ++variable)
        if (std::strncmp(*variable, "POVINI=", 7) != 0)
            result.push_back(*variable);
    return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts)
{
    std::vector<char*> result;
    for (std::string& text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Runs a program to its end; standard output and error go to the file `log`. Returns the exit
/// status, or 128 plus the number of the signal that ended the program.
int run(std::vector<std::string> command, std::vector<std::string> environment,
        const std::string& log)
{
    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_addopen(&streams, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&streams, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&streams, 1, 2);
    pid_t child = 0;
    const int failure = posix_spawn(&child, command[0].c_str(), &streams, nullptr,
                                    pointers(command).data(), pointers(environment).data());
    posix_spawn_file_actions_destroy(&streams);
    if (failure != 0)
        throw std::runtime_error(command[0] + ": cannot be run: " + std::strerror(failure));
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            throw std::runtime_error(std::string("waiting for the renderer: ") +
                                     std::strerror(errno));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string last_lines(const std::string& text, int lines)
{
    std::size_t start = text.size();
    while (start > 0 && lines >= 0)
        if (text[--start] == '\n')
            --lines;
    return text.substr(start);
}

/// The number in the first group of the pattern's first match. Throws if there is no match.
double number_in(const std::string& text, const char* pattern, const std::string& log)
{
    std::smatch match;
    if (!std::regex_search(text, match, std::regex(pattern)))
        throw std::runtime_error(log + ": the renderer's statistics do not say " + pattern);
    return std::stod(match[1]);
}

} // namespace

std::string Sheet::words() const
{
    std::ostringstream text;
    text.precision(12);
    text << name << " pitch " << pitch << " thickness " << thickness << " ior " << ior;
    return text.str();
}

std::string Setting::full_name() const
{
    std::string text = words;
    for (const std::string& option : options)
        text += (text.empty() ? "" : " ") + option;
    return text;
}

const std::vector<Sheet>& sheets()
{
    static const std::vector<Sheet> all = {
        {"lenticular", "1.27 mm lenticular", 1.27, 3.08, 1.6},
        {"square", "1.124 mm square", 1.124, 3.23, 1.675},
    };
    return all;
}

std::string camera_words(const Sheet& sheet, const Setting& setting)
{
    return "lens_sheet { " + sheet.words() + " } film { dpi " + std::to_string(int(dots_per_inch)) +
           " } " + setting.words;
}

RenderCost Renderer::render(const std::string& scene, const std::string& name,
                            const std::optional<std::string>& camera,
                            const std::vector<std::string>& options, int times) const
{
    const std::string ini = work_folder + "/settings.ini", log = work_folder + "/" + name + ".log";
    write_file(ini, "Display=off\nVerbose=off\nBits_Per_Color=16\nWork_Threads=1\n");
    std::vector<std::string> command;
    if (patience > 0)
        command = {"/usr/bin/timeout", std::to_string(patience)};
    command.insert(
        command.end(),
        {program, "+I" + scene_folder + "/" + scene + ".pov", "+L" + scene_folder,
         "+O" + picture(name), "+W" + std::to_string(times * width),
         "+H" + std::to_string(times * height),
         "Declare=Film_Width=" + std::to_string(width * mm_per_inch / dots_per_inch)});
    if (camera)
        command.push_back("Integral_Camera=" + *camera);
    command.insert(command.end(), options.begin(), options.end());

    unlink(picture(name).c_str());
    const int status = run(command, environment_with(ini), log);
    std::string said = read_file(log);
    std::replace(said.begin(), said.end(), '\r', '\n');
    if (patience > 0 && status == 124) // as timeout has it
        throw std::runtime_error("takes longer than " + std::to_string(patience) + " s");
    if (status != 0)
        throw std::runtime_error(program + " ended with status " + std::to_string(status) + " on " +
                                 scene + ".pov:\n" + last_lines(said, 15));
    RenderCost cost;
    cost.cpu_seconds = number_in(said, "Trace Time:[^\\n]*\\n[^\\n]* with +([0-9.]+) CPU-seconds",
                                 log);
    if (std::regex_search(said, std::regex("Radiosity Time:[^\\n]*seconds\\)")))
        cost.cpu_seconds += number_in(
            said, "Radiosity Time:[^\\n]*\\n[^\\n]* with +([0-9.]+) CPU-seconds", log);
    cost.rays = (long long)(number_in(said, "\\nRays: +([0-9]+) +Saved:", log));
    if (!camera)
        return cost;
    cost.camera_rays = (long long)(number_in(said, "\\nRays: +([0-9]+) [^\\n]* an imaged point",
                                             log));
    const auto metadata = read_metadata(picture(name));
    if (!metadata.render)
        throw std::runtime_error(picture(name) + ": the metadata have no record of the render");
    cost.seconds = metadata.render->seconds;
    return cost;
}

} // namespace integral::bench
