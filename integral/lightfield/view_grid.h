// SPDX-License-Identifier: AGPL-3.0-or-later
// Views of a frame: how many there are, and what a picture of them records.
#ifndef INTEGRAL_LIGHTFIELD_VIEW_GRID_H
#define INTEGRAL_LIGHTFIELD_VIEW_GRID_H

#include "integral/optics/vec.h"

#include <optional>

namespace integral {

/// How many directions across and up. View number row * columns + column: column 0 is seen from the
/// far left, row 0 from below, as in quilts. (The thesis counts by the film's pixels, which lie the
/// other way round.)
struct ViewGrid {
    int columns = 0, rows = 0; ///< > 0; lenticular: rows is 1
    int count() const { return columns * rows; }
};

/// The eyes of perspective views: at the middles of equal parts of a rectangle in front of the
/// sheet, centred on its axis. mm.
struct EyeGrid {
    Vec2 zone;           ///< width and height of the rectangle, >= 0
    double distance = 0; ///< to the sheet, > 0
};

/// What a picture of views says of itself.
struct QuiltRecord {
    ViewGrid grid;
    std::optional<int> view; ///< the one view of them that the picture is; nothing: all, view 0 at
                             ///< the bottom left
    std::optional<EyeGrid> eyes; ///< nothing: parallel views
};

} // namespace integral

#endif
