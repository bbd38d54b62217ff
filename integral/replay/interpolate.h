// SPDX-License-Identifier: AGPL-3.0-or-later
// Colours between pixels, and between views.
#ifndef INTEGRAL_REPLAY_INTERPOLATE_H
#define INTEGRAL_REPLAY_INTERPOLATE_H

#include "integral/lightfield/image.h"
#include "integral/optics/film.h"

#include <algorithm>

namespace integral {

/// Between the four neighbours of a place among `columns` x `rows` centres, whose first is at (0, 0); beyond the outermost, these.
/// at(column, row) is a Color, linear and premultiplied.
template <class At> Color between(double x, double y, int columns, int rows, At at)
{
    x = std::clamp(x, 0.0, columns - 1.0);
    y = std::clamp(y, 0.0, rows - 1.0);
    const int left = std::min(int(x), std::max(0, columns - 2)), top = std::min(int(y), std::max(0, rows - 2));
    Color sum{0, 0, 0, 0};
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const double weight = (i ? x - left : 1 - (x - left)) * (j ? y - top : 1 - (y - top));
            if (weight > 0) {
                const Color c = at(left + i, top + j);
                const float w = float(weight);
                sum = {sum.r + w * c.r, sum.g + w * c.g, sum.b + w * c.b, sum.a + w * c.a};
            }
        }
    return sum;
}

/// A colour whose channels stand side by side on the film, each a shift (in pixels) from the pixel's centre; their mean alpha.
template <class At> Color each_channel(Subpixels subpixels, At at)
{
    if (subpixels == Subpixels::none)
        return at(0.0);
    const auto of = [&](int channel) { return at(subpixel_shift(subpixels, channel)); };
    const Color red = of(0), green = of(1), blue = of(2);
    return {red.r, green.g, blue.b, (red.a + green.a + blue.a) / 3};
}

} // namespace integral

#endif
