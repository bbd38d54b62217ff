// SPDX-License-Identifier: AGPL-3.0-or-later
// Where povray-integral finds its own include files, scenes and settings: in
// ../share/povray-integral-3.7 from the running program, so that it works in the build folder and
// after `make install` at any prefix, without options.
#ifndef POVRAY_INTEGRAL_PATHS_H
#define POVRAY_INTEGRAL_PATHS_H

#include <string>

namespace vfe
{
class vfeRenderOptions;
}

namespace vfePlatform
{
/// The share folder's path without a final slash, or "" where there is none.
std::string IntegralShareDirectory();

/// Where the machine has no POV-Ray settings of its own, take those in the share folder; where the
/// user has none, look for none. Arguments: the paths of povray.conf and povray.ini that POV-Ray
/// would read.
void UseIntegralSettings(std::string& system_conf, std::string& user_conf, std::string& system_ini);

/// Adds the share folder and its ini, include and scenes behind every library path of the settings
/// and the command line: advanced/chess2.pov and integral/biplane.pov are found from anywhere.
void AddIntegralLibraryPaths(vfe::vfeRenderOptions& options);
}

#endif
