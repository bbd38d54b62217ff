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

/// Replaces the paths of the settings files that POV-Ray would read: a system file that does not
/// exist by the one in the share folder, and the user's povray.conf by "" if it does not exist.
void UseIntegralSettings(std::string& system_conf, std::string& user_conf, std::string& system_ini);

/// Appends the share folder and its subfolders ini, include and scenes to the library paths of the
/// settings and the command line, so that advanced/chess2.pov and integral/biplane.pov are found
/// from any folder.
void AddIntegralLibraryPaths(vfe::vfeRenderOptions& options);
}

#endif
