// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds where a map shows what mirrors in a surface, in place of the surface.
#ifndef INTEGRAL_DEPTH_REFLECTIONS_H
#define INTEGRAL_DEPTH_REFLECTIONS_H

#include "integral/depth/disparity_search.h"

namespace integral {

/// Gives a polished surface its own depth. Between its marks it has no texture but that of what it
/// mirrors, which is faint and lies far behind. So a second search, with half the resolution and
/// the views to the left, right, above and below, tolerates faint differences: there only strong
/// edges count. Where a wide area lies behind the depth of such edges, is not sure, and no surface
/// beside it has the edges' depth, the map takes that. `step` as Labels' wanted one. Views smaller
/// than 128 pixels either way are left alone.
void put_reflections_on_their_surface(const ViewSet& views, double step, int threads,
                                      DepthMap& map);

} // namespace integral

#endif
