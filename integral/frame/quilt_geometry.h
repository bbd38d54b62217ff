// SPDX-License-Identifier: AGPL-3.0-or-later
// Where the views of a quilt stand in its picture, and their eyes before the sheet.
#ifndef INTEGRAL_FRAME_QUILT_GEOMETRY_H
#define INTEGRAL_FRAME_QUILT_GEOMETRY_H

#include "integral/frame/view_grid.h"

namespace integral {

/// Geometry that the views of a quilt share. Lengths in mm, on the sheet if not stated otherwise.
struct QuiltGeometry {
    int width, height;           ///< of the picture, pixels
    int tile_width, tile_height; ///< pixels; what is left over is at the right and at the top
    ViewGrid tiles;
    Vec2 pixel;      ///< width and height of a pixel
    Vec2 by_column;  ///< from a view's eye to the eye of the view in the next tile to the right
    Vec2 by_row;     ///< the same for the next tile above
    double distance; ///< from the sheet to the eyes
};

} // namespace integral

#endif
