// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds out whether views stand from right to left: depth measured in them is inverted, and what it
// calls farther then hides what it calls nearer.
#ifndef INTEGRAL_DEPTH_VIEW_ORDER_H
#define INTEGRAL_DEPTH_VIEW_ORDER_H

#include "integral/depth/multibaseline.h"

namespace integral {

/// At the upright edges of a map's surfaces: how many show which side hides the other.
struct HiddenSides {
    int farther = 0; ///< edges at which the farther side is hidden, as it should be
    int nearer = 0;  ///< edges at which the nearer side is
    /// Whether the views' order is likely to be the reverse: most of at least 30 edges say so.
    bool is_reversed() const;
};

/// Compares the middle view with those beside it, of a set and the depth measured in it. A surface
/// beside an edge is hidden from the eyes of one side if its pixels are not found in their views.
HiddenSides hidden_sides(const ViewSet& views, const DepthMap& map);

} // namespace integral

#endif
