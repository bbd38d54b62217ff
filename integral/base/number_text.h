// SPDX-License-Identifier: AGPL-3.0-or-later
// Numbers as text, whatever the locale.
#ifndef INTEGRAL_BASE_NUMBER_TEXT_H
#define INTEGRAL_BASE_NUMBER_TEXT_H

#include <string>

namespace integral {

/// With so many decimals.
std::string with_decimals(double value, int decimals);

/// With at most so many digits, and none that says nothing: 1.5, 300, 1e+09.
std::string with_digits(double value, int digits);

/// How many there are of a thing whose plural ends in s: "1 job", "0 jobs".
std::string counted(long long count, const std::string& thing);

/// Pixels, 640x480.
std::string size_text(int width, int height);

} // namespace integral

#endif
