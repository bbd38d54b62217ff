// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_picture_scale.h"

#include "integral/base/number_text.h"
#include "integral/io/codecs.h"
#include "integral/io/plot_canvas.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// Colour at a position from far (0) to near (1), between stops of the map "cividis" (Nuñez,
/// Anderton and Renslow 2018), which looks the same to readers with red-green colour blindness.
PlotInk colour_of(double part)
{
    constexpr PlotInk stops[] = {
        {0.000, 0.135, 0.305}, {0.120, 0.260, 0.435}, {0.305, 0.360, 0.425}, {0.450, 0.450, 0.455},
        {0.600, 0.560, 0.470}, {0.755, 0.680, 0.430}, {0.925, 0.815, 0.320}, {0.995, 0.910, 0.215}};
    constexpr int last = int(sizeof stops / sizeof stops[0]) - 1;
    const double at = std::clamp(part, 0.0, 1.0) * last;
    const int low = std::min(int(at), last - 1);
    const double high = at - low;
    const auto mix = [&](double a, double b) { return a + high * (b - a); };
    return {mix(stops[low].red, stops[low + 1].red), mix(stops[low].green, stops[low + 1].green),
            mix(stops[low].blue, stops[low + 1].blue)};
}

/// The scale: colours with numbers next to them, near at the top.
Image scale_picture(const UprightMap& map, DisparityRange range, int height)
{
    constexpr int width = 90, bar = 16, margin = 10;
    constexpr PlotInk black{0, 0, 0};
    PlotCanvas canvas(width, height, PlotFormat::png);
    const int length = height - 2 * margin - 14;
    canvas.set_font(11, false);
    canvas.write(map.scale ? "mm behind" : "disparity", margin, margin + 4, black);
    const double top = margin + 14;
    for (int y = 0; y < length; ++y) {
        const double low = top + y, high = low + 1.5;
        canvas.fill_polygon(
            {{margin, low}, {margin + bar, low}, {margin + bar, high}, {margin, high}},
            colour_of(1 - (y + 0.5) / length), 1);
    }
    const int labels = std::clamp(length / 40, 1, 10);
    for (int k = 0; k <= labels; ++k) {
        const double part = double(k) / labels,
                     disparity = range.greatest + part * (range.least - range.greatest);
        const double value = map.scale ? map.scale->mm(disparity) : disparity;
        canvas.write(std::isfinite(value) ? with_decimals(value, map.scale ? 1 : 2) : "endless",
                     margin + bar + 5, top + part * length + 4, black);
    }
    return decode_png(canvas.finish("")).image;
}

} // namespace

Image depth_picture_with_scale(const UprightMap& map)
{
    const DisparityRange range = shown_range(map);
    constexpr int least_height = 120;
    const Image scale = scale_picture(map, range, std::max(map.height, least_height));
    Image picture = make_image<std::uint8_t>(map.width + scale.width, scale.height, 3, Encoding());
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (x >= map.width) {
                store_pixel(picture, x, y, stored_pixel(scale, x - map.width, y));
                continue;
            }
            const float d = y < map.height ? map.disparity[std::size_t(y) * map.width + x] : NAN;
            const PlotInk ink = std::isnan(d)
                                    ? PlotInk{0.5, 0.5, 0.5}
                                    : colour_of((d - range.least) / (range.greatest - range.least));
            store_pixel(picture, x, y, {float(ink.red), float(ink.green), float(ink.blue), 1});
        }
    return picture;
}

} // namespace integral
