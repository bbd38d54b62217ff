// SPDX-License-Identifier: AGPL-3.0-or-later
// Values of options: read strictly, whatever the locale, and refused by name.
#ifndef INTEGRAL_CLI_VALUES_H
#define INTEGRAL_CLI_VALUES_H

#include "integral/lightfield/view_grid.h"
#include "integral/optics/film.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Throws UsageError: "--eye 1,2: X,Y,DISTANCE is expected".
[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& form);

/// Each throws UsageError naming the option, the text and `form`, as in "--eye 1,2: X,Y,DISTANCE
/// is expected". Numbers are finite decimals.
double parse_number(const char* option, const std::string& text, const char* form);

/// A number from `least` to `greatest`; a number beyond is refused by the words of `range`.
double parse_number_between(const char* option, const std::string& text, const char* form,
                            double least, double greatest, const std::string& range);

/// Reads an option's number, if it was given, into `value`.
void read_number(const char* option, const std::optional<std::string>& text, double& value);

/// Reads an option's number, if it was given, into `value`, which has to be greater than 0 then.
/// `form` as above.
void read_positive(const char* option, const std::optional<std::string>& text, double& value,
                   const char* form = "a number");

/// Reads an option's X,Y or X,Y,Z, if it was given, into `value`.
void read_vector(const char* option, const std::optional<std::string>& text, Vec2& value);
void read_vector(const char* option, const std::optional<std::string>& text, Vec3& value);

/// Numbers separated by commas, from `least` to `most` of them.
std::vector<double> parse_numbers(const char* option, const std::string& text, const char* form,
                                  std::size_t least, std::size_t most);

/// One number for both axes, or two separated by a comma.
Vec2 parse_one_or_two(const char* option, const std::string& text, const char* form);

/// Dots per inch, across and down: D or D,D, greater than 0.
Vec2 parse_dpi(const char* option, const std::string& text);

/// WxH, each from 1 to `most`; `form` is what a complaint calls it.
PixelSize parse_size(const char* option, const std::string& text, int most,
                     const char* form = "WxH");

/// Reads an option's WxH, if it was given, into `width` and `height`.
void read_size(const char* option, const std::optional<std::string>& text, int most, int& width,
               int& height);

/// WxH in mm, as 150x100; each from 1 to `most`.
Vec2 parse_size_mm(const char* option, const std::string& text, double most);

/// "a, b or c".
std::string alternatives(const std::vector<std::string>& names);

/// An option's name, and whether the line has it.
struct GivenOption {
    GivenOption(const char* option, bool is_given) : name(option), given(is_given) {}
    template <class T>
    GivenOption(const char* option, const std::optional<T>& value)
        : name(option), given(value.has_value())
    {
    }
    const char* name;
    bool given;
};

/// The name of the first of them that was given; none: nullptr.
const char* first_given(std::initializer_list<GivenOption> all);

/// Throws UsageError "--NAME REASON" for the first of them that was given, if any.
void refuse_given(std::initializer_list<GivenOption> all, const std::string& reason);

/// A whole number from `least` to `most`.
int in_range(const char* option, int value, int least, int most);

/// The value of --bits, 8 or 16; `otherwise` if it was not given.
int bits_given(const std::optional<int>& bits, int otherwise);

/// The path of -o. Throws UsageError "-o WHAT is missing" if it is not given, or empty.
std::string needed_output(const std::optional<std::string>& output, const std::string& what);

/// Throws where a picture cannot be written to this path: OutputError for the name of no format, or
/// a folder that is missing. To be called before long work.
void check_picture(const std::string& path);

/// Checks the paths that were given, before long work. Throws OutputError where one cannot be
/// written.
void check_outputs(std::initializer_list<std::optional<std::string>> paths);

constexpr int most_views_a_side = 256;

/// CxR views, the value of --views.
ViewGrid parse_view_grid(const std::string& text);

} // namespace integral

#endif
