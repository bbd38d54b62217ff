// SPDX-License-Identifier: AGPL-3.0-or-later
// Gives pixels of uncertain depth the depth of the edges of their surface.
#ifndef INTEGRAL_DEPTH_SPREAD_H
#define INTEGRAL_DEPTH_SPREAD_H

#include "integral/depth/view_set.h"

namespace integral {

/// Where the confidence is low and there is no texture, replaces the disparity by what the edges
/// and the texture around say, over even colours. An edge between two surfaces belongs to the
/// nearer one, so that a plain surface is as far off as the farthest of its edges: the mean counts
/// those most, up to 10 x `reach` pixels away (> 0). Where near edges say about the same, a plane
/// through them replaces it. In views of fewer than
/// 128 pixels either way, as most frames' are, nearly all pixels are near edges, and outliers are
/// many: there it is the mean of all, by their confidence, up to `reach` away. All planes of values
/// are of the middle view; disparities without light may be NaN.
void spread_from_sure_pixels(const ViewSet& views, double reach, int threads,
                             std::vector<float>& disparity, const std::vector<float>& confidence);

} // namespace integral

#endif
