// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/picture_series.h"

#include "integral/cli/values.h"
#include "integral/io/image_file.h"

#include <cmath>

namespace integral {

void add_series_options(options::options_description& all)
{
    all.add_options()("fps", options::value<std::string>()->value_name("N"),
                      "pictures a second of an animation, 0.1 to 100 (default: 25)")(
        "quality", options::value<int>()->value_name("N")->default_value(90),
        "of an animation's pictures, 0 to 100; 100 keeps every 8-bit value");
}

bool is_animation(const std::string& path) { return extension_of(path) == "webp"; }

void check_series_options(const options::variables_map& arguments, const std::string& output)
{
    if (!is_animation(output) && (given(arguments, "fps") || !arguments["quality"].defaulted()))
        throw UsageError("--fps and --quality are for animations, whose names end in .webp");
}

namespace {

double pictures_a_second(const options::variables_map& arguments)
{
    constexpr double plain = 25;
    if (!given(arguments, "fps"))
        return plain;
    const double value = parse_number("fps", text_of(arguments, "fps"), "a number");
    if (!(value >= 0.1 && value <= 100))
        throw UsageError("--fps " + text_of(arguments, "fps") +
                         ": 0.1 to 100 pictures a second is expected");
    return value;
}

} // namespace

PictureSeries::PictureSeries(const options::variables_map& arguments, const std::string& path,
                             int count, int first)
    : path_(path),
      last_(first + count - 1),
      next_(first),
      pictures_a_second_(pictures_a_second(arguments)),
      animation_(in_range(arguments, "quality", 0, 100))
{
    if (path == "-")
        throw UsageError("-o -: several pictures need a name, FILE.webp for an animation or "
                         "FILE.png for files with numbers");
    if (is_animation(path)) {
        if (!can_animate())
            throw OutputError(path + ": this program was built without libwebp; a name that ends "
                                     "in .png gives files with numbers");
        check_writable(path);
        return;
    }
    format_for(path);
    check_writable(numbered(path_, last_, last_));
}

std::string numbered(const std::string& path, int number, int last)
{
    std::string digits = std::to_string(number);
    digits.insert(0, std::to_string(last).size() - digits.size(), '0');
    const std::size_t dot = path.rfind('.');
    return path.substr(0, dot) + digits + path.substr(dot);
}

void PictureSeries::add(Image picture, const std::optional<FrameMetadata>& metadata)
{
    if (!is_animation(path_)) {
        write_frame(numbered(path_, next_++, last_), Frame{std::move(picture), metadata});
        return;
    }
    try {
        animation_.add(picture);
    } catch (const std::runtime_error& error) {
        throw OutputError(path_ + ": " + error.what());
    }
}

void PictureSeries::finish(bool there_and_back)
{
    if (!is_animation(path_))
        return;
    constexpr double milliseconds_a_second = 1000;
    std::string bytes;
    try {
        bytes = animation_.bytes(int(std::lround(milliseconds_a_second / pictures_a_second_)),
                                 there_and_back);
    } catch (const std::runtime_error& error) {
        throw OutputError(path_ + ": " + error.what());
    }
    write_file(path_, bytes);
}

} // namespace integral
