// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/layer_plane.h"

namespace integral {

LayerPlane LayerPlane::Sums::plane(const float (&reach)[2]) const
{
    const float one = 1 / weight(), x = one * all_[1], y = one * all_[2], depth = one * all_[3],
                level = level_samples * square_of_place * squares_ * one * one;
    const LinearMoments moments{x,
                                y,
                                depth,
                                one * by_x_[1] - x * x + level * reach[0] * reach[0],
                                one * by_x_[2] - x * y,
                                one * by_y_[2] - y * y + level * reach[1] * reach[1],
                                one * by_x_[3] - x * depth,
                                one * by_y_[3] - y * depth};
    LayerPlane plane;
    plane.depth_ = moments.fit();
    return plane;
}

} // namespace integral
