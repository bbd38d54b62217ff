// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/layer_covers.h"

namespace integral {

namespace {

/// Where the rays of a beam that meet a place at one depth cross another depth, both in terms of
/// half the patch's width there: the mean over these rays, in terms of the place.
float scale(const BeamPatch::Axis& axis, float depth, float place_depth)
{
    // A ray's place is that on the lens plus that on the pixel, which are independent: the mean of
    // one place that goes with another follows from their covariance.
    const float cell = axis.cell(place_depth), pixel = axis.pixel(place_depth),
                covariance = axis.cell(depth) * cell + axis.pixel(depth) * pixel,
                variance = cell * cell + pixel * pixel;
    return covariance / variance * axis.reach(place_depth) / axis.reach(depth);
}

} // namespace

void LayerCovers::add(float depth, const ReachingSamples<float>& samples)
{
    if (!(samples.ended.weight > 0))
        return;
    Cover cover;
    cover.depth = depth;
    cover.part = fitted_to(samples.ended, {1, 1});
    covers_.push_back(cover);
}

void LayerCovers::look_from(const BeamPatch& patch, float depth)
{
    for (Cover& cover : covers_) {
        cover.scale_x = scale(patch.axis(0), cover.depth, depth);
        cover.scale_y = scale(patch.axis(1), cover.depth, depth);
    }
}

} // namespace integral
