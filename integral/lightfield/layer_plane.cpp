// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/layer_plane.h"

#include "integral/lightfield/sample_fit.h"

namespace integral {

LayerPlane LayerPlane::Sums::plane(const float (&reach)[2]) const
{
    const float one = 1 / weight(), x = one * all_[1], y = one * all_[2], depth = one * all_[3],
                level = level_samples * square_of_place * squares_ * one * one,
                xx = one * by_x_[1] - x * x + level * reach[0] * reach[0],
                yy = one * by_y_[2] - y * y + level * reach[1] * reach[1],
                xy = one * by_x_[2] - x * y, to_x = one * by_x_[3] - x * depth,
                to_y = one * by_y_[3] - y * depth, of_determinant = 1 / (xx * yy - xy * xy);
    LayerPlane plane;
    plane.by_x_ = of_determinant * (yy * to_x - xy * to_y);
    plane.by_y_ = of_determinant * (xx * to_y - xy * to_x);
    plane.at_centre_ = depth - plane.by_x_ * x - plane.by_y_ * y;
    return plane;
}

} // namespace integral
