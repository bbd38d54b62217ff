// SPDX-License-Identifier: AGPL-3.0-or-later
// Subpixels: where in its pixel each colour is lit.
#ifndef INTEGRAL_OPTICS_SUBPIXELS_H
#define INTEGRAL_OPTICS_SUBPIXELS_H

#include "integral/optics/vec.h"

#include <array>

namespace integral {

/// Centres of a pixel's red, green and blue from the pixel's own: in pixels, +x to the right, +y
/// up; -1 to 1.
using PixelCell = std::array<Vec2, 3>;

/// Which of its cells a panel's pixel has, by column and row counted from the top left; the number
/// is then taken modulo the number of cells.
enum class CellPattern {
    same,         ///< cell 0 everywhere
    checkerboard, ///< 0 where column + row is even, else 1
    columns,      ///< column modulo 2
    rows,         ///< row modulo 2
    staggered     ///< row + 2 (column modulo 2), modulo 4
};

/// How a pixel's colours lie: on each other (none), as three upright stripes from left to right
/// (rgb, bgr), as three level stripes from top to bottom (vrgb, vbgr), or each at a place of its
/// own (cells).
struct Subpixels {
    enum Order { none, rgb, bgr, vrgb, vbgr, cells };
    static constexpr int most_cells = 4;

    Order order = none;
    CellPattern pattern = CellPattern::same; ///< of cells
    int number = 0;                          ///< of cells, 1 to most_cells; 0 for the other orders
    std::array<PixelCell, most_cells> cell{};

    Subpixels() = default;
    Subpixels(Order stripes) : order(stripes) {} ///< not `cells`, which need their places

    friend bool operator==(const Subpixels& a, Order b) { return a.order == b; }
    friend bool operator!=(const Subpixels& a, Order b) { return a.order != b; }
};

/// Whether two panels' colours lie alike.
bool same_layout(const Subpixels& a, const Subpixels& b);

/// The layout of a panel of so many columns and rows seen mirrored in x, in y or in both: its
/// columns or rows are counted from the other side, and its colours lie on the other side of their
/// pixel's centre.
Subpixels mirrored(const Subpixels& subpixels, int columns, int rows, bool x, bool y);

/// Which cell the pixel of a column and a row has, 0 to number - 1. They may be negative.
int cell_of(const Subpixels& subpixels, int column, int row);

/// How far from its pixel's centre a colour (0 red, 1 green, 2 blue) is, in pixel coordinates: +x
/// to the right, +y down. `pixel`: any point of the pixel, in pixel coordinates.
Vec2 subpixel_shift(const Subpixels& subpixels, Vec2 pixel, int channel);

/// Pixel coordinates of a colour of the pixel of a column and a row.
inline Vec2 subpixel_centre(const Subpixels& subpixels, int column, int row, int channel)
{
    const Vec2 centre{column + 0.5, row + 0.5};
    return centre + subpixel_shift(subpixels, centre, channel);
}

/// Width and height of a colour's own area, in pixels: of one of several cells a square of a third
/// of the pixel's area.
Vec2 subpixel_size(const Subpixels& subpixels);

/// A column and a row.
struct PixelPlace {
    int column, row;
};

/// The pixel whose subpixel of a colour is nearest to a point in pixel coordinates; it may be
/// outside the film.
PixelPlace pixel_of_nearest_subpixel(const Subpixels& subpixels, Vec2 pixel, int channel);

} // namespace integral

#endif
