// SPDX-License-Identifier: AGPL-3.0-or-later
// Values of options: read strictly, whatever the locale, and refused by name.
#ifndef INTEGRAL_CLI_VALUES_H
#define INTEGRAL_CLI_VALUES_H

#include "integral/lightfield/view_grid.h"

#include <string>
#include <vector>

namespace integral {

/// Each throws UsageError naming the option, the text and `form`, as in "--eye 1,2: X,Y,DISTANCE
/// is expected". Numbers are finite decimals.
double parse_number(const char* option, const std::string& text, const char* form);

/// Numbers separated by commas, from `least` to `most` of them.
std::vector<double> parse_numbers(const char* option, const std::string& text, const char* form,
                                  std::size_t least, std::size_t most);

/// One number for both axes, or two separated by a comma.
Vec2 parse_one_or_two(const char* option, const std::string& text, const char* form);

struct PixelSize {
    int width = 0, height = 0;
};

/// WxH, each from 1 to `most`; `form` is what a complaint calls it.
PixelSize parse_size(const char* option, const std::string& text, int most,
                     const char* form = "WxH");

constexpr int most_views_a_side = 256;

/// CxR views, the value of --views.
ViewGrid parse_view_grid(const std::string& text);

} // namespace integral

#endif
