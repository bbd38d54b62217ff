// SPDX-License-Identifier: AGPL-3.0-or-later
// Handles Integral_Target_Error=E on the command line: renders with the fastest settings whose
// estimated error is at most E.
#ifndef POVRAY_INTEGRAL_TARGET_ERROR_H
#define POVRAY_INTEGRAL_TARGET_ERROR_H

namespace vfePlatform
{
/// Replaces this program by `integral tune`, which searches for the settings and makes this program
/// render with them. No effect if no argument has that form. Ends this program with status 1 and a
/// message if there is no scene among the arguments or no `integral`. `argv` ends with a null
/// pointer.
void RenderToTargetError(char **argv);
}

#endif
