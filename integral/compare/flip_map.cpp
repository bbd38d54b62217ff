// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/flip_map.h"

#include <algorithm>
#include <iterator>

namespace integral {

Colour flip_colour(float value)
{
    // sRGB colours at equal steps, whose lightness grows evenly.
    static const Colour stops[] = {{0, 0, 0.02f, 1},         {0.17f, 0.06f, 0.37f, 1},
                                   {0.45f, 0.12f, 0.51f, 1}, {0.75f, 0.22f, 0.46f, 1},
                                   {0.95f, 0.42f, 0.37f, 1}, {1, 0.69f, 0.46f, 1},
                                   {1, 0.97f, 0.78f, 1}};
    constexpr int last = int(std::size(stops)) - 1;
    const float place = std::clamp(value, 0.0f, 1.0f) * last;
    const int k = std::min(int(place), last - 1);
    const auto between = [&](float low, float high) { return low + (place - k) * (high - low); };
    const Colour &a = stops[k], &b = stops[k + 1];
    return {between(a.r, b.r), between(a.g, b.g), between(a.b, b.b), 1};
}

Image flip_map_form(int width, int height, bool as_values)
{
    return as_values ? form_of(32, width, height, 3, {Encoding::Kind::linear, 1})
                     : form_of(8, width, height, 3, {});
}

Image flip_map_rows(const float* map, int width, int rows, bool as_values)
{
    Image picture = blank_like(flip_map_form(width, rows, as_values), width, rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < width; ++x) {
            const float value = map[std::size_t(y) * width + x];
            store_pixel(picture, x, y,
                        as_values ? Colour{value, value, value, 1} : flip_colour(value));
        }
    return picture;
}

} // namespace integral
