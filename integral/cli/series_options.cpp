// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/series_options.h"

#include "integral/base/file_bytes.h"
#include "integral/cli/values.h"

namespace integral {

void declare(options::options_description& all, SeriesOptions& series)
{
    add(all, "fps", series.fps, "N", "pictures a second of an animation, 0.1 to 100 (default: 25)");
    add(all, "quality", series.quality, "N (=90)",
        "of an animation's pictures, 0 to 100, or a pair's (95 by itself); 100 of .webp keeps every "
        "8-bit value");
}

void check_series_options(const SeriesOptions& given, const std::string& output)
{
    const bool has_quality = is_animation(output) || extension_of(output) == "mpo";
    if ((!is_animation(output) && given.fps) || (!has_quality && given.quality))
        throw UsageError("--fps and --quality are for animations, whose names end in .webp, .webm "
                         "or .mp4, and --quality for pairs, .mpo");
}

AnimationSettings animation_settings(const SeriesOptions& given)
{
    AnimationSettings settings;
    read_number("fps", given.fps, settings.pictures_a_second);
    if (!(settings.pictures_a_second >= 0.1 && settings.pictures_a_second <= 100))
        throw_usage("fps", given.fps.value_or(""), "0.1 to 100 pictures a second");
    if (given.quality)
        settings.quality = in_range("quality", *given.quality, 0, 100);
    return settings;
}

} // namespace integral
