// SPDX-License-Identifier: AGPL-3.0-or-later
// Subpixels: the positions of the colours in a pixel.
#ifndef INTEGRAL_OPTICS_SUBPIXELS_H
#define INTEGRAL_OPTICS_SUBPIXELS_H

#include "integral/optics/vec.h"

#include <array>

namespace integral {

/// Positions of the red, green and blue subpixels relative to the pixel's centre, in pixels: +x to
/// the right, +y up; -1 to 1.
using PixelCell = std::array<Vec2, 3>;

/// Assigns a cell of the panel to each pixel, by its column and row counted from the top left. The
/// result is taken modulo the number of cells.
enum class CellPattern {
    same,         ///< cell 0 everywhere
    checkerboard, ///< 0 if column + row is even, else 1
    columns,      ///< column modulo 2
    rows,         ///< row modulo 2
    staggered     ///< row + 2 (column modulo 2), modulo 4
};

/// The layout of a pixel's colours: all at the pixel's centre (none), in three vertical stripes
/// from left to right (rgb, bgr), in three horizontal stripes from top to bottom (vrgb, vbgr), or
/// each at a given position (cells).
struct Subpixels {
    enum Order { none, rgb, bgr, vrgb, vbgr, cells };
    static constexpr int most_cells = 4;

    Order order = none;
    CellPattern pattern = CellPattern::same; ///< for the order `cells`
    int number = 0; ///< number of cells, 1 to most_cells; 0 for the other orders
    std::array<PixelCell, most_cells> cell{};

    Subpixels() = default;
    Subpixels(Order stripes) : order(stripes) {} ///< any but `cells`, which needs positions

    friend bool operator==(const Subpixels& a, Order b) { return a.order == b; }
    friend bool operator!=(const Subpixels& a, Order b) { return a.order != b; }
};

/// Whether two layouts are the same.
bool same_layout(const Subpixels& a, const Subpixels& b);

/// The layout of a panel of `columns` x `rows` pixels after mirroring it in x, in y or in both.
/// Columns or rows are then counted from the other side, and each colour is on the other side of
/// its pixel's centre.
Subpixels mirrored(const Subpixels& subpixels, int columns, int rows, bool x, bool y);

/// The cell of the pixel at a column and row, 0 to number - 1. Column and row may be negative.
int cell_of(const Subpixels& subpixels, int column, int row);

/// The position of a colour (0 red, 1 green, 2 blue) relative to its pixel's centre, in pixel
/// coordinates: +x to the right, +y down. `pixel`: any point of the pixel, in pixel coordinates.
Vec2 subpixel_shift(const Subpixels& subpixels, Vec2 pixel, int channel);

/// The position of a colour of the pixel at a column and row, in pixel coordinates.
inline Vec2 subpixel_centre(const Subpixels& subpixels, int column, int row, int channel)
{
    const Vec2 centre{column + 0.5, row + 0.5};
    return centre + subpixel_shift(subpixels, centre, channel);
}

/// Width and height of the area that a colour fills, in pixels: the whole pixel, a stripe, or for
/// the order `cells` a square with a third of the pixel's area.
Vec2 subpixel_size(const Subpixels& subpixels);

/// A column and a row.
struct PixelPlace {
    int column, row;
};

/// The pixel whose subpixel of a colour is nearest to a point in pixel coordinates; the pixel may
/// be outside the film.
PixelPlace pixel_of_nearest_subpixel(const Subpixels& subpixels, Vec2 pixel, int channel);

} // namespace integral

#endif
