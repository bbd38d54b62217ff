// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds out whether views stand from right to left. In such views measured depth is inverted:
// surfaces that are measured as farther hide nearer ones.
#ifndef INTEGRAL_DEPTH_VIEW_ORDER_H
#define INTEGRAL_DEPTH_VIEW_ORDER_H

#include "integral/depth/multibaseline.h"

namespace integral {

/// Counts of the upright edges of a map's surfaces, by the side that is hidden.
struct HiddenSides {
    int farther = 0; ///< edges at which the farther side is hidden, as it should be
    int nearer = 0;  ///< edges at which the nearer side is hidden
    /// Whether the views' order is probably reversed: `nearer` is most of at least 30 edges, by
    /// more than 2 to 1.
    bool is_reversed() const;
};

/// Counts, in the views to the left and right of the middle one, which side of each edge is hidden,
/// at the depth measured in the set. A surface at an edge is hidden from the eyes of one side if
/// its pixels are not found in their views. Surfaces at the ends of the range that was searched do
/// not count: they may be beyond it.
HiddenSides hidden_sides(const ViewSet& views, const DepthMap& map);

} // namespace integral

#endif
