// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/layer_plane.h"

namespace integral {

LayerPlane::LayerPlane(const LayerSums<float>& sums, const std::array<float, 2>& reach)
{
    const float one = 1 / sums.weight, x = one * sums.x, y = one * sums.y, depth = one * sums.depth,
                level = level_samples * square_of_place * sums.squared_weight * one * one;
    const LinearMoments moments{x,
                                y,
                                depth,
                                one * sums.xx - x * x + level * reach[0] * reach[0],
                                one * sums.xy - x * y,
                                one * sums.yy - y * y + level * reach[1] * reach[1],
                                one * sums.x_depth - x * depth,
                                one * sums.y_depth - y * depth};
    depth_ = moments.fit();
}

} // namespace integral
