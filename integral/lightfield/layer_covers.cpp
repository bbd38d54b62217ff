// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/layer_covers.h"

#include "integral/lightfield/sample_fit.h"

namespace integral {

void LayerCovers::begin(const BeamPatch& patch)
{
    patch_ = patch;
    covers_.clear();
}

void LayerCovers::add(float depth, const ReachingSamples& samples)
{
    const float sum = sum_of(samples.weight);
    if (!(sum > 0))
        return;
    const float one = 1 / sum, x = one * sum_of(samples.x), y = one * sum_of(samples.y),
                part = one * sum_of(samples.ended),
                level = one * one * sum_of(samples.squared_weight) * level_samples *
                        square_of_place,
                xx = one * sum_of(samples.xx) - x * x + level,
                yy = one * sum_of(samples.yy) - y * y + level,
                xy = one * sum_of(samples.xy) - x * y, of_determinant = 1 / (xx * yy - xy * xy),
                to_x = one * sum_of(samples.ended_x) - x * part,
                to_y = one * sum_of(samples.ended_y) - y * part;
    Cover cover;
    cover.depth = depth;
    cover.by_x = of_determinant * (yy * to_x - xy * to_y);
    cover.by_y = of_determinant * (xx * to_y - xy * to_x);
    cover.at = part - x * cover.by_x - y * cover.by_y;
    covers_.push_back(cover);
}

void LayerCovers::look_from(float depth)
{
    for (Cover& cover : covers_) {
        cover.scale_x = scale(0, cover.depth, depth);
        cover.scale_y = scale(1, cover.depth, depth);
    }
}

float LayerCovers::scale(int which, float depth, float other_depth) const
{
    // A ray's place is that on the lens plus that on the pixel, which are independent: the mean of
    // one place that goes with another follows from their covariance.
    const BeamPatch::Axis& axis = patch_.axis(which);
    const auto cell = [&](float z) { return axis.cell_at_sheet + axis.cell_slope * std::fabs(z); };
    const auto pixel = [&](float z) { return axis.pixel_at_sheet + axis.pixel_slope * z; };
    const float from_cell = cell(other_depth), from_pixel = pixel(other_depth),
                covariance = cell(depth) * from_cell + pixel(depth) * from_pixel,
                variance = from_cell * from_cell + from_pixel * from_pixel;
    return covariance / variance * patch_.reach(which, other_depth) / patch_.reach(which, depth);
}

} // namespace integral
