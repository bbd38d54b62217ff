// SPDX-License-Identifier: AGPL-3.0-or-later
// Corrects a depth map where it shows a reflection instead of the reflecting surface.
#ifndef INTEGRAL_DEPTH_REFLECTIONS_H
#define INTEGRAL_DEPTH_REFLECTIONS_H

#include "integral/depth/disparity_search.h"

namespace integral {

/// Corrects the depth of polished surfaces. Between a surface's marks the only texture is the
/// reflection, which is faint and lies far behind. A second search, at half the resolution and with
/// the views to the left, right, above and below, tolerates faint differences: only strong edges
/// count. Their depth replaces the map's in wide areas where the map is farther and unsure, unless
/// the map has that depth nearly everywhere around. `step` as in Labels. Leaves views smaller than
/// 128 pixels either way unchanged.
void flatten_reflections(const ViewSet& views, double step, int threads, DepthMap& map);

} // namespace integral

#endif
