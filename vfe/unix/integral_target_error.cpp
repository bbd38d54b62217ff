// SPDX-License-Identifier: AGPL-3.0-or-later
// See integral_target_error.h.
#include "integral_target_error.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <strings.h>
#include <unistd.h>
#include <vector>

#include "integral/base/programs.h"

namespace vfePlatform
{
namespace
{

/// Whether an argument begins with an option's name, in any case; `value` is what follows it.
bool Is_Option(const std::string& argument, const std::string& name, std::string& value)
{
    if (strncasecmp(argument.c_str(), name.c_str(), name.size()) != 0)
        return false;
    value = argument.substr(name.size());
    return true;
}

bool Ends_With(const std::string& text, const std::string& end)
{
    return text.size() > end.size() &&
           strcasecmp(text.c_str() + text.size() - end.size(), end.c_str()) == 0;
}

/// Whether an argument names the scene.
bool Is_Scene(const std::string& argument, std::string& scene)
{
    if (Is_Option(argument, "+I", scene) || Is_Option(argument, "Input_File_Name=", scene))
        return true;
    scene = argument;
    return argument[0] != '+' && argument[0] != '-' && argument.find('=') == std::string::npos &&
           (Ends_With(argument, ".pov") ||
            Ends_With(argument.substr(0, argument.find('[')), ".ini"));
}

/// The program `integral` in this program's folder, or its bare name, to be searched for on PATH.
std::string Tools()
{
    char *const own = realpath("/proc/self/exe", NULL);
    std::string program = own ? own : "";
    free(own);
    program = program.substr(0, program.rfind('/') + 1) + "integral";
    return access(program.c_str(), X_OK) == 0 ? program : "integral";
}

}

void RenderToTargetError(char **argv)
{
    std::string target, scene, value;
    std::vector<std::string> others;
    bool requested = false;
    for (char **next = argv + 1; *next != NULL; ++next)
    {
        const std::string argument = *next;
        if (Is_Option(argument, "Integral_Target_Error=", value))
        {
            requested = true;
            target = value;
        }
        else if (scene.empty() && !argument.empty() && Is_Scene(argument, value))
            scene = value;
        else
            others.push_back(argument);
    }
    if (!requested)
        return;
    if (scene.empty())
    {
        std::fprintf(stderr, "Integral_Target_Error=%s: name the scene on the command line, too, "
                             "as +Iscene.pov\n", target.c_str());
        std::exit(1);
    }
    std::vector<std::string> words = {Tools(), "tune", "--target-error=" + target, "--render", "--",
                                      scene};
    words.insert(words.end(), others.begin(), others.end());
    execvp(words[0].c_str(), integral::exec_arguments(words).data());
    std::fprintf(stderr, "Integral_Target_Error=%s: the program integral, which looks for the "
                         "settings, is not here; install it (Debian: integral-imaging), or render "
                         "with +A0.1 +AM2 +R5\n", target.c_str());
    std::exit(1);
}
}
