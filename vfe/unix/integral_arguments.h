// SPDX-License-Identifier: AGPL-3.0-or-later
// Integral_Camera="..." on the command line: the shell takes the quotes away, and POV-Ray's option
// parser would end the value at its first blank. This puts quotes back.
#ifndef POVRAY_INTEGRAL_ARGUMENTS_H
#define POVRAY_INTEGRAL_ARGUMENTS_H

namespace vfePlatform
{
/// Quotes the value of every argument of the form Integral_Camera=value (in any case) that is not
/// quoted yet. `argv` ends with a null pointer; its entries are replaced, and live as long as the
/// program.
void QuoteIntegralCamera(char **argv);
}

#endif
