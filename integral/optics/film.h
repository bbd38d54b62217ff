// SPDX-License-Identifier: AGPL-3.0-or-later
// The film: a raster of pixels at z = thickness in the sheet frame.
#ifndef INTEGRAL_OPTICS_FILM_H
#define INTEGRAL_OPTICS_FILM_H

#include "integral/optics/subpixels.h"

namespace integral {

constexpr double mm_per_inch = 25.4;

struct Film {
    int width = 0, height = 0; ///< pixels; > 0
    Vec2 pixel_pitch;          ///< mm; > 0; mm_per_inch / dpi, and may differ between x and y
    Subpixels subpixels = {};
};

/// Film point (mm, sheet frame) of continuous pixel coordinates: origin at the top-left corner
/// of the top-left pixel, pixel (i, j) centred at (i + 1/2, j + 1/2).
inline Vec2 film_from_pixel(const Film& film, Vec2 pixel)
{
    return {(pixel.x - 0.5 * film.width) * film.pixel_pitch.x,
            (0.5 * film.height - pixel.y) * film.pixel_pitch.y};
}

/// Inverse of film_from_pixel.
inline Vec2 pixel_from_film(const Film& film, Vec2 point)
{
    return {point.x / film.pixel_pitch.x + 0.5 * film.width,
            0.5 * film.height - point.y / film.pixel_pitch.y};
}

} // namespace integral

#endif
