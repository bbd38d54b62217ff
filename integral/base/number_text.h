// SPDX-License-Identifier: AGPL-3.0-or-later
// Formats numbers as text, independently of the locale.
#ifndef INTEGRAL_BASE_NUMBER_TEXT_H
#define INTEGRAL_BASE_NUMBER_TEXT_H

#include <string>

namespace integral {

/// A number with exactly `decimals` digits after the point.
std::string with_decimals(double value, int decimals);

/// A number with at most `digits` significant digits and without trailing zeros: 1.5, 300, 1e+09.
std::string with_digits(double value, int digits);

/// A count and a noun whose plural ends in s: "1 job", "0 jobs".
std::string counted(long long count, const std::string& thing);

/// A size in pixels: "640x480".
std::string size_text(int width, int height);

} // namespace integral

#endif
