// SPDX-License-Identifier: AGPL-3.0-or-later
// Gives pixels of uncertain depth the depth of sure pixels of the same surface.
#ifndef INTEGRAL_DEPTH_SPREAD_H
#define INTEGRAL_DEPTH_SPREAD_H

#include "integral/depth/view_set.h"

namespace integral {

/// Where the confidence is low and there is no texture, replaces the disparity by a mean over the
/// surroundings that sure pixels count most in. The mean reaches about `reach` pixels (> 0) over
/// even colours, and stops at edges of colour: the recursive domain transform of Gastal and
/// Oliveira (2011). All planes are of the middle view; disparities without light may be NaN.
void spread_from_sure_pixels(const ViewSet& views, double reach, int threads,
                             std::vector<float>& disparity, const std::vector<float>& confidence);

} // namespace integral

#endif
