// SPDX-License-Identifier: AGPL-3.0-or-later
// Gives pixels of uncertain depth the depth of the edges of their surface.
#ifndef INTEGRAL_DEPTH_SPREAD_H
#define INTEGRAL_DEPTH_SPREAD_H

#include "integral/depth/view_set.h"

namespace integral {

/// Replaces the disparity of pixels with low confidence and no texture by a weighted mean of the
/// edges and the texture around, across similar colours. An edge between two surfaces belongs to
/// the nearer one, so a plain surface is as far off as its farthest edges: these have most weight
/// in the mean, up to 10 x `reach` pixels away (> 0). Where close edges have about that disparity
/// too, a plane through them replaces the mean. In views of fewer than 128 pixels either way, as in
/// most frames, nearly all pixels are near edges and outliers are many: there the mean is over all
/// pixels up to `reach` away, weighted by confidence. All planes of values belong to the middle
/// view; disparities without light may be NaN.
void propagate_confident(const ViewSet& views, double reach, int threads,
                         std::vector<float>& disparity, const std::vector<float>& confidence);

} // namespace integral

#endif
