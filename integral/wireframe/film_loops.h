// SPDX-License-Identifier: AGPL-3.0-or-later
// Projects many scene points through the pole of one lens to the film, in vector loops.
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
    /// The lens's raster: its first pixel, its number of columns and rows, and the step between the
    /// places of successive rows.
    int left, top, columns, rows, stride;
};

/// A batch of points that are projected together. Unused elements must hold any point with z != 0.
struct FilmChunk {
    static constexpr int most = 64;
    double x[most], y[most], z[most]; ///< in: sheet frame, mm
    double across[most], down[most];  ///< out: continuous pixel coordinates
    /// Out: the pixel's place in the raster; a place on the border if the raster lacks the pixel.
    int place[most];
};

/// Projects a batch. `across` and `down` equal the results of film_point_through_pole bit for bit.
void project(const PoleView& view, FilmChunk& chunk);

/// Minimum and maximum pixel coordinates, from the raster's top left corner. The maxima are
/// negated, so that a larger extent has smaller numbers.
using FilmExtent __attribute__((vector_size(16))) = float; ///< x, y, -x, -y

inline FilmExtent extent_of_both(FilmExtent a, FilmExtent b) { return a < b ? a : b; }

/// Margin (pixels) around the raster to which extents are clamped.
constexpr float extent_beside = 8;

/// Extents of a chunk's points, clamped to extent_beside pixels around the raster.
void find_extents(const PoleView& view, const FilmChunk& chunk, FilmExtent* extents);

} // namespace integral

#endif
