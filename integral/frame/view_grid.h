// SPDX-License-Identifier: AGPL-3.0-or-later
// The number of a frame's views, and the record about the views in a picture that consists of them.
#ifndef INTEGRAL_FRAME_VIEW_GRID_H
#define INTEGRAL_FRAME_VIEW_GRID_H

#include "integral/optics/aperture.h"

#include <optional>

namespace integral {

/// The views of a frame, or the tiles of a quilt, across and up: both > 0. A view has the number
/// row * columns + column; column 0 is the leftmost viewpoint, row 0 the lowest, as in quilts. (The
/// thesis numbers views by the film's pixels, which have the opposite order.)
struct ViewGrid {
    int columns = 0, rows = 0;
    int count() const { return columns * rows; }
};

/// Numbers of view directions, across and up, in a quilt of `tiles`. Behind lenticular lenses the
/// views differ in one direction only: 8 x 6 tiles are 48 views from left to right or, if the
/// lenses lie across, from bottom to top. The views fill the tiles row by row, from the bottom left
/// to the top right.
inline ViewGrid directions_of(ViewGrid tiles, const LensSheet& sheet)
{
    if (sheet.arrangement != Arrangement::lenticular)
        return tiles;
    return lenses_lie_across(sheet) ? ViewGrid{1, tiles.count()} : ViewGrid{tiles.count(), 1};
}

/// The eyes of perspective views: at the centres of equal parts of a rectangle in front of the
/// sheet, centred on its axis. Lengths in mm.
struct EyeGrid {
    Vec2 zone;           ///< width and height of the rectangle, >= 0
    double distance = 0; ///< to the sheet, > 0
};

/// Metadata of a picture of views.
struct QuiltRecord {
    ViewGrid grid;           ///< columns and rows of a quilt of all views
    std::optional<int> view; ///< the number of the only view in the picture; if absent, the picture
                             ///< has all views, with view 0 at the bottom left
    std::optional<EyeGrid> eyes; ///< absent for parallel views
};

} // namespace integral

#endif
