// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds povray-integral's include files, scenes and settings in ../share/povray-integral-3.7,
// relative to the running program, so that it works without options both in the build folder and
// after `make install` with any prefix.
#ifndef POVRAY_INTEGRAL_PATHS_H
#define POVRAY_INTEGRAL_PATHS_H

#include <string>

namespace vfe
{
class vfeRenderOptions;
}

namespace vfePlatform
{
/// The share folder's path without a final slash, or "" if there is no such folder.
std::string IntegralShareDirectory();

/// If settings files that POV-Ray would read do not exist, replaces their paths: a system file's by that of
/// the share folder's file (if any), the path of the user's povray.conf by "".
void UseIntegralSettings(std::string& system_conf, std::string& user_conf, std::string& system_ini);

/// Replaces each argument that names an INI file which is not there, but is in the share folder's
/// include or include/integral, by its path: `povray-integral print-4x6.ini +Iscene.pov` works from
/// any folder. (POV-Ray reads INI files before it knows the library paths.) `argv` ends with a null
/// pointer. Replaced entries point to strings that exist until the program ends.
void FindIntegralSettings(char **argv);

/// Appends the share folder and its subfolders ini, include and scenes to the library paths of the
/// settings and the command line, so that advanced/chess2.pov and integral/biplane.pov are found
/// from any folder. Upstream's scenes may also be where Debian's package povray-examples has them.
void AddIntegralLibraryPaths(vfe::vfeRenderOptions& options);
}

#endif
