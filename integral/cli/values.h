// SPDX-License-Identifier: AGPL-3.0-or-later
// Parses values of options strictly, in any locale; errors name the option.
#ifndef INTEGRAL_CLI_VALUES_H
#define INTEGRAL_CLI_VALUES_H

#include "integral/frame/view_grid.h"
#include "integral/optics/film.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Throws UsageError: "--eye 1,2: X,Y,DISTANCE is expected".
[[noreturn]] void throw_usage(const std::string& option, const std::string& text,
                              const std::string& form);

/// The finite decimal number that a whole text is; nothing if it is none.
std::optional<double> number_in(const std::string& text);

/// Each throws UsageError naming the option, the text and `form`, as in "--eye 1,2: X,Y,DISTANCE
/// is expected". Numbers are finite decimals.
double parse_number(const char* option, const std::string& text, const char* form);

/// A number from `least` to `greatest`. If the number is outside, the error quotes `range`.
double parse_number_between(const char* option, const std::string& text, const char* form,
                            double least, double greatest, const std::string& range);

/// Reads an option's number into `value`, if given.
void read_number(const char* option, const std::optional<std::string>& text, double& value);

/// Reads an option's number, which must be greater than 0, into `value`, if given. `form` as above.
void read_positive(const char* option, const std::optional<std::string>& text, double& value,
                   const char* form = "a number");

/// Reads an option's X,Y or X,Y,Z into `value`, if given.
void read_vector(const char* option, const std::optional<std::string>& text, Vec2& value);
void read_vector(const char* option, const std::optional<std::string>& text, Vec3& value);

/// Numbers separated by commas, from `least` to `most` of them.
std::vector<double> parse_numbers(const char* option, const std::string& text, const char* form,
                                  std::size_t least, std::size_t most);

/// One number for both axes, or two separated by a comma.
Vec2 parse_one_or_two(const char* option, const std::string& text, const char* form);

/// Dots per inch, across and down: D or D,D, greater than 0.
Vec2 parse_dpi(const char* option, const std::string& text);

/// WxH, each from 1 to `most`; `form` describes it in errors.
PixelSize parse_size(const char* option, const std::string& text, int most,
                     const char* form = "WxH");

/// Reads an option's WxH into `width` and `height`, if given.
void read_size(const char* option, const std::optional<std::string>& text, int most, int& width,
               int& height);

/// WxH in mm, e.g. 150x100; each from 1 to `most`.
Vec2 parse_size_mm(const char* option, const std::string& text, double most);

/// The parts of a text between its commas; at least one.
std::vector<std::string> parts_between_commas(const std::string& text);

/// "a, b or c".
std::string alternatives(const std::vector<std::string>& names);

/// An option's name, and whether the line contains it.
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

/// The name of the first given option; nullptr if there is none.
const char* first_given(std::initializer_list<GivenOption> all);

/// Throws UsageError "--NAME REASON" for the first given option, if any.
void throw_if_given(std::initializer_list<GivenOption> all, const std::string& reason);

/// Returns `value` if it is from `least` to `most`; else throws UsageError.
int in_range(const char* option, int value, int least, int most);

/// The value of --bits, 8 or 16, if given; the second form returns `otherwise` if it is not. Throw
/// UsageError.
std::optional<int> bits_given(const std::optional<int>& bits);
int bits_given(const std::optional<int>& bits, int otherwise);

/// The path of -o. Throws UsageError "-o WHAT is missing" if it is absent or empty.
std::string needed_output(const std::optional<std::string>& output, const std::string& what);

/// Throws OutputError if no picture can be written to this path: unknown format or missing folder.
/// To be called before long work.
void check_picture(const std::string& path);

/// Throws UsageError unless an option's path ends in .exr, as a depth frame's does.
void check_depth_name(const char* option, const std::string& path);

/// Checks the given paths before long work. Throws OutputError if one cannot be written, and
/// UsageError if two are one file; "-" may stand twice.
void check_outputs(std::initializer_list<std::optional<std::string>> paths);

constexpr int most_views_a_side = 256;

/// Parses CxR views, the value of --views.
ViewGrid parse_view_grid(const std::string& text);

/// Parses seconds, the value of --at.
double parse_video_time(const std::string& text);

} // namespace integral

#endif
