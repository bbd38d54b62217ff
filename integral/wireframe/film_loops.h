// SPDX-License-Identifier: AGPL-3.0-or-later
// Where the pole of one lens puts many scene points on the film, worked out side by side.
#ifndef INTEGRAL_WIREFRAME_FILM_LOOPS_H
#define INTEGRAL_WIREFRAME_FILM_LOOPS_H

#include "integral/optics/film.h"
#include "integral/optics/refraction.h"

namespace integral {

/// One square or hexagonal lens, and the pixels behind it.
struct PoleView {
    Medium medium;
    Vec2 pole;
    bool mirrored; ///< film points are mirrored at the pole
    Film film;
    Vec2 shift; ///< subtracted from pixel coordinates
    /// Of the lens's raster: its first pixel, its number of columns and rows, and the step from a
    /// row's places to the next row's.
    int left, top, columns, rows, stride;
};

/// As many points as are worked out together. Lanes that are not needed may hold any point with z
/// not 0.
struct FilmChunk {
    static constexpr int most = 64;
    double x[most], y[most], z[most]; ///< in: sheet frame, mm
    double across[most], down[most];  ///< out: continuous pixel coordinates
    /// Out: the raster's place of the pixel; of a pixel that the raster has not, of the border.
    int place[most];
};

/// `across` and `down` are those of film_point_through_pole, bit for bit.
void project(const PoleView& view, FilmChunk& chunk);

/// Least and greatest pixel coordinates of something, from the raster's top left corner. All four
/// numbers grow smaller by what is added.
using FilmExtent __attribute__((vector_size(16))) = float; ///< x, y, -x, -y

inline FilmExtent extent_of_both(FilmExtent a, FilmExtent b) { return a < b ? a : b; }

/// Pixels beside the raster that an extent still tells apart.
constexpr float extent_beside = 8;

/// The extents of a chunk's points; farther from the raster than extent_beside they are there.
void find_extents(const PoleView& view, const FilmChunk& chunk, FilmExtent* extents);

} // namespace integral

#endif
