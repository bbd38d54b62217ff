// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral camera's part of --help.
#ifndef POVRAY_INTEGRAL_HELP_H
#define POVRAY_INTEGRAL_HELP_H

namespace vfePlatform
{
/// Prints the integral camera's INI keywords and the first steps to standard error, where --help
/// prints POV-Ray's own options.
void PrintIntegralHelp();
}

#endif
