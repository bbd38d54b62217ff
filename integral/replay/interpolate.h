// SPDX-License-Identifier: AGPL-3.0-or-later
// Interpolates colours between pixels and between views.
#ifndef INTEGRAL_REPLAY_INTERPOLATE_H
#define INTEGRAL_REPLAY_INTERPOLATE_H

#include "integral/base/parallel.h"
#include "integral/frame/image.h"
#include "integral/optics/film.h"

#include <algorithm>

namespace integral {

/// Bilinear interpolation at (x, y) in a grid of `columns` x `rows` points, the first at (0, 0).
/// Outside the grid the nearest edge value counts. at(column, row) returns a Colour, linear and
/// premultiplied.
template <class At> Colour between(double x, double y, int columns, int rows, At at)
{
    x = std::clamp(x, 0.0, columns - 1.0);
    y = std::clamp(y, 0.0, rows - 1.0);
    const int left = std::min(int(x), std::max(0, columns - 2)),
              top = std::min(int(y), std::max(0, rows - 2));
    Colour sum{0, 0, 0, 0};
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const double weight = (i ? x - left : 1 - (x - left)) * (j ? y - top : 1 - (y - top));
            if (weight > 0) {
                const Colour c = at(left + i, top + j);
                const float w = float(weight);
                sum = {sum.r + w * c.r, sum.g + w * c.g, sum.b + w * c.b, sum.a + w * c.a};
            }
        }
    return sum;
}

/// Combines one colour for each channel of a film with subpixels: red of at(0), green of at(1),
/// blue of at(2), and their mean alpha. Without subpixels returns at(1).
template <class At> Colour each_channel(const Subpixels& subpixels, At at)
{
    if (subpixels == Subpixels::none)
        return at(1);
    const Colour red = at(0), green = at(1), blue = at(2);
    return {red.r, green.g, blue.b, (red.a + green.a + blue.a) / 3};
}

/// Draws rows of a film from `first` on, as many as the band is high. at(film_point, x, y) gives
/// the light of a pixel, or of one of its subpixels. `threads` and `progress` as in for_each_row.
template <class At>
bool draw_film(const Film& film, int first, Image& band, int threads, const Progress& progress,
               At at)
{
    const auto row = [&](int y) {
        for (int x = 0; x < film.width; ++x)
            store_linear(band, x, y, each_channel(film.subpixels, [&](int channel) {
                             const Vec2 pixel = subpixel_centre(film.subpixels, x, first + y,
                                                                channel);
                             return at(film_from_pixel(film, pixel), x, first + y);
                         }));
    };
    return for_each_row(band.height, threads, row, progress);
}

/// The colour that the film's subpixels of a channel show at a point in pixel coordinates:
/// interpolated between the four nearest of them; or, for patterns of cells, which form no regular
/// grid, the colour of the nearest.
inline Colour of_subpixels(const LinearReader& light, const Film& film, Vec2 pixel, int channel)
{
    if (film.subpixels == Subpixels::cells) {
        const PixelPlace at = pixel_of_nearest_subpixel(film.subpixels, pixel, channel);
        return light(std::clamp(at.column, 0, film.width - 1),
                     std::clamp(at.row, 0, film.height - 1));
    }
    const Vec2 shift = subpixel_shift(film.subpixels, pixel, channel);
    return between(pixel.x - 0.5 - shift.x, pixel.y - 0.5 - shift.y, film.width, film.height,
                   [&](int x, int y) { return light(x, y); });
}

} // namespace integral

#endif
