// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/picture_series.h"

#include "integral/io/image_file.h"

#include <cmath>
#include <stdexcept>

namespace integral {

bool is_animation(const std::string& path)
{
    return extension_of(path) == "webp" || is_video(path);
}

PictureSeries::PictureSeries(const std::string& path, const AnimationSettings& settings, int count,
                             int first)
    : path_(path),
      last_(first + count - 1),
      next_(first),
      settings_(settings),
      animation_(settings.quality)
{
    if (path == "-")
        throw std::invalid_argument(
            "-o -: several pictures need a name, FILE.webp, .webm or .mp4 for an "
            "animation or FILE.png for files with numbers");
    if (is_video(path)) {
        check_writable(path);
        video_ = std::make_unique<Video>(path, settings.quality, settings.pictures_a_second,
                                         settings.there_and_back);
        return;
    }
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
    if (video_)
        return video_->add(picture);
    try {
        animation_.add(picture);
    } catch (const std::runtime_error& error) {
        throw OutputError(path_ + ": " + error.what());
    }
}

void PictureSeries::finish()
{
    if (!is_animation(path_))
        return;
    if (video_)
        return video_->finish();
    constexpr double milliseconds_a_second = 1000;
    std::string bytes;
    try {
        bytes = animation_.bytes(
            int(std::lround(milliseconds_a_second / settings_.pictures_a_second)),
            settings_.there_and_back);
    } catch (const std::runtime_error& error) {
        throw OutputError(path_ + ": " + error.what());
    }
    write_file(path_, bytes);
}

} // namespace integral
