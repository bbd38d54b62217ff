// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/values.h"

#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

namespace integral {
namespace {

/// Reads a finite number that spans the whole of [begin, end). Returns whether there is one.
bool read_number(const char* begin, const char* end, double& value)
{
    if (begin != end && *begin == '+')
        ++begin;
    const auto read = std::from_chars(begin, end, value);
    return read.ec == std::errc() && read.ptr == end && std::isfinite(value);
}

} // namespace

std::optional<double> number_in(const std::string& text)
{
    double value;
    return read_number(text.data(), text.data() + text.size(), value) ? std::optional(value)
                                                                      : std::nullopt;
}

void throw_usage(const std::string& option, const std::string& text, const std::string& form)
{
    throw UsageError("--" + option + " " + text + ": " + form + " is expected");
}

std::vector<std::string> parts_between_commas(const std::string& text)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, comma - begin));
        begin = comma + 1;
    }
    return parts;
}

std::string alternatives(const std::vector<std::string>& names)
{
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k)
        text += (k == 0 ? "" : k + 1 < names.size() ? ", " : " or ") + names[k];
    return text;
}

std::vector<double> parse_numbers(const char* option, const std::string& text, const char* form,
                                  std::size_t least, std::size_t most)
{
    std::vector<double> numbers;
    for (const std::string& part : parts_between_commas(text)) {
        const auto number = number_in(part);
        if (!number)
            throw_usage(option, text, form);
        numbers.push_back(*number);
    }
    if (numbers.size() < least || numbers.size() > most)
        throw_usage(option, text, form);
    return numbers;
}

double parse_number(const char* option, const std::string& text, const char* form)
{
    return parse_numbers(option, text, form, 1, 1)[0];
}

double parse_number_between(const char* option, const std::string& text, const char* form,
                            double least, double greatest, const std::string& range)
{
    const double value = parse_number(option, text, form);
    if (!(value >= least && value <= greatest))
        throw_usage(option, text, range);
    return value;
}

void read_number(const char* option, const std::optional<std::string>& text, double& value)
{
    if (text)
        value = parse_number(option, *text, "a number");
}

void read_positive(const char* option, const std::optional<std::string>& text, double& value,
                   const char* form)
{
    if (!text)
        return;
    value = parse_number(option, *text, form);
    if (!(value > 0))
        throw UsageError(std::string("--") + option + " " + *text + ": it must be greater than 0");
}

void read_vector(const char* option, const std::optional<std::string>& text, Vec2& value)
{
    if (!text)
        return;
    const auto v = parse_numbers(option, *text, "X,Y", 2, 2);
    value = {v[0], v[1]};
}

void read_vector(const char* option, const std::optional<std::string>& text, Vec3& value)
{
    if (!text)
        return;
    const auto v = parse_numbers(option, *text, "X,Y,Z", 3, 3);
    value = {v[0], v[1], v[2]};
}

Vec2 parse_dpi(const char* option, const std::string& text)
{
    const Vec2 dpi = parse_one_or_two(option, text, "D or D,D");
    if (!(dpi.x > 0 && dpi.y > 0))
        throw UsageError(std::string("--") + option + " " + text + ": it must be greater than 0");
    return dpi;
}

Vec2 parse_one_or_two(const char* option, const std::string& text, const char* form)
{
    const auto numbers = parse_numbers(option, text, form, 1, 2);
    return {numbers.front(), numbers.back()};
}

PixelSize parse_size(const char* option, const std::string& text, int most, const char* form)
{
    PixelSize size;
    const char *begin = text.data(), *end = begin + text.size();
    const auto width = std::from_chars(begin, end, size.width);
    bool good = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    if (good) {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        good = height.ec == std::errc() && height.ptr == end;
    }
    if (!good || size.width < 1 || size.height < 1 || size.width > most || size.height > most)
        throw_usage(option, text,
                    std::string(form) + ", each from 1 to " + std::to_string(most) + ",");
    return size;
}

void read_size(const char* option, const std::optional<std::string>& text, int most, int& width,
               int& height)
{
    if (!text)
        return;
    const PixelSize size = parse_size(option, *text, most);
    width = size.width;
    height = size.height;
}

Vec2 parse_size_mm(const char* option, const std::string& text, double most)
{
    const auto cross = text.find('x');
    Vec2 size;
    try {
        size.x = parse_number(option, text.substr(0, cross), "");
        size.y = parse_number(option, cross == std::string::npos ? "" : text.substr(cross + 1), "");
    } catch (const UsageError&) {
        throw_usage(option, text, "WxH, in mm,");
    }
    if (!(size.x >= 1 && size.y >= 1 && size.x <= most && size.y <= most))
        throw_usage(option, text, "WxH with sides of 1 to " + with_digits(most, 9) + " mm");
    return size;
}

const char* first_given(std::initializer_list<GivenOption> all)
{
    for (const GivenOption& option : all)
        if (option.given)
            return option.name;
    return nullptr;
}

void throw_if_given(std::initializer_list<GivenOption> all, const std::string& reason)
{
    if (const char* option = first_given(all))
        throw UsageError(std::string("--") + option + " " + reason);
}

std::optional<int> bits_given(const std::optional<int>& bits)
{
    if (bits && *bits != 8 && *bits != 16)
        throw_usage("bits", std::to_string(*bits), "8 or 16");
    return bits;
}

int bits_given(const std::optional<int>& bits, int otherwise)
{
    return bits_given(bits).value_or(otherwise);
}

std::string needed_output(const std::optional<std::string>& output, const std::string& what)
{
    if (output.value_or("").empty())
        throw UsageError("-o " + what + " is missing");
    return *output;
}

void check_picture(const std::string& path)
{
    format_for(path);
    check_writable(path);
}

void check_depth_name(const char* option, const std::string& path)
{
    if (extension_of(path) != "exr")
        throw UsageError(std::string("--") + option + " " + path +
                         ": a depth frame is an OpenEXR file; end its name in .exr");
}

void check_outputs(std::initializer_list<std::optional<std::string>> paths)
{
    std::set<std::filesystem::path> files;
    for (const auto& path : paths) {
        if (!path)
            continue;
        check_writable(*path);
        std::error_code unknown;
        std::filesystem::path file = std::filesystem::weakly_canonical(
            std::filesystem::absolute(*path, unknown), unknown);
        if (unknown)
            file = *path;
        if (*path != "-" && !files.insert(file).second)
            throw UsageError(*path + " is the name of two outputs; give each its own");
    }
}

int in_range(const char* option, int value, int least, int most)
{
    if (value < least || value > most)
        throw_usage(option, std::to_string(value),
                    "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value;
}

ViewGrid parse_view_grid(const std::string& text)
{
    const PixelSize size = parse_size("views", text, most_views_a_side, "CxR");
    return {size.width, size.height};
}

double parse_video_time(const std::string& text)
{
    return parse_number_between("at", text, "a number of seconds", 0, 1e6, "0 to 1000000 s");
}

} // namespace integral
