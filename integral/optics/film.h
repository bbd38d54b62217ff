// SPDX-License-Identifier: AGPL-3.0-or-later
// The film: a raster of pixels at z = thickness in the sheet frame.
#ifndef INTEGRAL_OPTICS_FILM_H
#define INTEGRAL_OPTICS_FILM_H

#include "integral/optics/subpixels.h"

#include <algorithm>

namespace integral {

constexpr double mm_per_inch = 25.4;
constexpr int largest_side = 1000000; ///< pixels of a film across or down

/// The size of a picture in pixels.
struct PixelSize {
    int width = 0, height = 0;
};

struct Film {
    int width = 0, height = 0; ///< pixels; > 0
    Vec2 pixel_pitch;          ///< mm; > 0; mm_per_inch / dpi, and may differ between x and y
    Subpixels subpixels = {};
    double bleed = 0; ///< width of the margin that is cut off all around after printing, mm; >= 0
};

/// Size on paper, mm.
inline Vec2 size_of(const Film& film)
{
    return {film.width * film.pixel_pitch.x, film.height * film.pixel_pitch.y};
}

/// Size of what is left when the bleed is cut off, mm.
inline Vec2 trimmed_size(const Film& film)
{
    return size_of(film) - Vec2{2 * film.bleed, 2 * film.bleed};
}

/// A draft of a film: equally large in mm, with one pixel for every n x n pixels (n >= 1). If n
/// does not divide a number of pixels, the quotient is rounded, and the pitch keeps the size.
inline Film draft_of(const Film& film, int n)
{
    const auto pixels = [n](int side) { return std::max(1, (side + n / 2) / n); };
    Film draft = film;
    draft.width = pixels(film.width);
    draft.height = pixels(film.height);
    draft.pixel_pitch.x *= double(film.width) / draft.width;
    draft.pixel_pitch.y *= double(film.height) / draft.height;
    return draft;
}

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
