// SPDX-License-Identifier: AGPL-3.0-or-later
// Smooths measured depth within surfaces, and fills what has no texture.
#ifndef INTEGRAL_DEPTH_SURFACE_FILL_H
#define INTEGRAL_DEPTH_SURFACE_FILL_H

#include "integral/depth/view_set.h"

namespace integral {

/// Replaces each disparity by a mean of itself and of planes through its surface, weighted by
/// confidence. The planes are fitted from coarse to fine: over `reach` pixels (> 0), then half of
/// that, and so on; a finer plane counts by the confidence around it. A measurement counts less the
/// more it differs from the coarser planes, and sooner if it is nearer and at an edge: an edge
/// between two surfaces belongs to the nearer one, so the edges around a plain surface may be too
/// near, never too far. All planes of values belong to the middle view; disparities without light
/// may be NaN.
void fill_surfaces(const ViewSet& views, double reach, int threads, std::vector<float>& disparity,
                   const std::vector<float>& confidence);

} // namespace integral

#endif
