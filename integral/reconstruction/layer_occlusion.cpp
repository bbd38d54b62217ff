// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/layer_occlusion.h"

namespace integral {

namespace {

/// Factor that converts a place at place_depth to the mean place at `depth` of the rays through it.
/// Each place is divided by half the footprint's width at its depth.
float scale(const BeamFootprint::Axis& axis, float depth, float place_depth)
{
    // A ray's place is the sum of two independent parts, by its points on the lens and on the
    // pixel. So the mean place at one depth, given that at another, follows from the covariance.
    const float cell = axis.cell(place_depth), pixel = axis.pixel(place_depth),
                covariance = axis.cell(depth) * cell + axis.pixel(depth) * pixel,
                variance = cell * cell + pixel * pixel;
    return covariance / variance * axis.reach(place_depth) / axis.reach(depth);
}

} // namespace

void LayerOcclusion::add(float depth, const ReachingSamples<float>& samples)
{
    if (!(samples.ended.weight > 0))
        return;
    Cover cover;
    cover.depth = depth;
    cover.part = fitted_to(samples.ended, {1, 1});
    covers_.push_back(cover);
}

void LayerOcclusion::look_from(const BeamFootprint& patch, float depth)
{
    for (Cover& cover : covers_) {
        cover.scale_x = scale(patch.axis(0), cover.depth, depth);
        cover.scale_y = scale(patch.axis(1), cover.depth, depth);
    }
}

} // namespace integral
