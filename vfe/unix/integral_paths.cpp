// SPDX-License-Identifier: AGPL-3.0-or-later
// See integral_paths.h.
#include <cstdlib>
#include <list>
#include <string>
#include <unistd.h>

#include "vfe.h"
#include "integral_paths.h"

namespace vfePlatform
{
static bool Readable(const std::string& path) { return access(path.c_str(), R_OK) == 0; }

std::string IntegralShareDirectory()
{
    char *program = realpath("/proc/self/exe", NULL);
    if (program == NULL)
        return "";
    std::string directory(program);
    free(program);
    directory.erase(directory.rfind('/'));     // the program's folder, bin
    directory.erase(directory.rfind('/') + 1); // its parent, with a final slash
    directory += "share/povray-integral-3.7";
    return Readable(directory) ? directory : "";
}

void UseIntegralSettings(std::string& system_conf, std::string& user_conf, std::string& system_ini)
{
    const std::string share = IntegralShareDirectory();
    if (!Readable(system_conf) && Readable(share + "/povray.conf"))
        system_conf = share + "/povray.conf";
    if (!Readable(system_ini) && Readable(share + "/povray.ini"))
        system_ini = share + "/povray.ini";
    if (!Readable(user_conf))
        user_conf.clear();
}

void FindIntegralSettings(char **argv)
{
    static std::list<std::string> found;
    const std::string share = IntegralShareDirectory();
    for (; *argv != NULL; ++argv)
    {
        std::string name = *argv; // "NAME.ini[SECTION]", perhaps in quotation marks
        if (name.size() > 2 && (name[0] == '"' || name[0] == '\'') && name.back() == name[0])
            name = name.substr(1, name.size() - 2);
        const std::string file = name.substr(0, name.find('['));
        if (file.size() < 4 || file.compare(file.size() - 4, 4, ".ini") != 0 || Readable(file))
            continue;
        for (const char *folder : {"/include/", "/include/integral/"})
            if (Readable(share + folder + file))
            {
                found.push_back('"' + share + folder + name + '"');
                *argv = &found.back()[0];
                break;
            }
    }
}

void AddIntegralLibraryPaths(vfe::vfeRenderOptions& options)
{
    const std::string share = IntegralShareDirectory();
    if (share.empty())
        return;
    options.AddLibraryPath(share);
    options.AddLibraryPath(share + "/ini");
    options.AddLibraryPath(share + "/include");
    options.AddLibraryPath(share + "/scenes");
    // Debian's package povray-examples installs upstream's scenes here.
    const std::string examples = share + "/../doc/povray/examples";
    if (Readable(examples))
        options.AddLibraryPath(examples);
}
}
