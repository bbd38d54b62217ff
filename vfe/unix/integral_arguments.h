// SPDX-License-Identifier: AGPL-3.0-or-later
// Restores the quotes of Integral_Camera="...", Integral_Sheet="..." and Integral_Panel="..." on
// the command line. The shell removes them, and without them POV-Ray's option parser would end the
// value at its first blank.
#ifndef POVRAY_INTEGRAL_ARGUMENTS_H
#define POVRAY_INTEGRAL_ARGUMENTS_H

namespace vfePlatform
{
/// Quotes the value of every argument of the forms Integral_Camera=value, Integral_Sheet=value and
/// Integral_Panel=value (in any case) that is not quoted yet. `argv` ends with a null pointer.
/// Replaced entries point to strings that exist until the program ends.
void QuoteIntegralArguments(char **argv);
}

#endif
