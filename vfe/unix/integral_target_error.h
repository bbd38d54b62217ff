// SPDX-License-Identifier: AGPL-3.0-or-later
// Integral_Target_Error=E on the command line: renders with the fastest settings whose estimated
// error is at most E.
#ifndef POVRAY_INTEGRAL_TARGET_ERROR_H
#define POVRAY_INTEGRAL_TARGET_ERROR_H

namespace vfePlatform
{
/// Does nothing if no argument has that form. Else the program `integral tune` takes this program's
/// place: it looks for the settings and has this program render with them. Ends this program with
/// status 1 and a message if there is no scene among the arguments or no `integral`. `argv` ends
/// with a null pointer.
void RenderToTargetError(char **argv);
}

#endif
