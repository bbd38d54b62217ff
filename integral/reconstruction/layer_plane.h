// SPDX-License-Identifier: AGPL-3.0-or-later
// Fits a plane to the points where the samples of a pixel's beam met a layer of surfaces.
//
// A floor that is seen nearly edge-on extends over many depths. A sample whose ray goes upwards
// passes above the floor at every depth; only a sample that comes down to the floor's plane shows
// where the floor ends.
#ifndef INTEGRAL_RECONSTRUCTION_LAYER_PLANE_H
#define INTEGRAL_RECONSTRUCTION_LAYER_PLANE_H

#include "integral/base/eight_floats.h"
#include "integral/reconstruction/sample_fit.h"

namespace integral {

/// A layer's depth (mm) as a linear function of the distances (mm) from the beam's central ray
/// along both axes.
class LayerPlane {
public:
    LayerPlane() = default;

    /// `depths`: sums over the samples that met a layer, with their depths (mm) as values and their
    /// distances from the central ray (mm) as places. `reach`: half the footprint's width along
    /// both axes at the samples' mean depth, mm.
    /// `furthest`: the largest depth on either side of the sheet, mm.
    LayerPlane(const LinearSums<float>& depths, const std::array<float, 2>& reach, float furthest)
        : depth_(fitted_to(depths, reach)), furthest_(furthest)
    {
    }

    /// Effect of a ray's slope on the depth at which the ray crosses the plane. `slopes`: the
    /// largest differences from the central ray's. Above 1: some rays never reach the plane.
    float tilt(const std::array<float, 2>& slopes) const
    {
        return std::fabs(depth_.by_x) * slopes[0] + std::fabs(depth_.by_y) * slopes[1];
    }

    /// Where rays from the viewer's side cross the plane.
    template <class Floats> struct Crossing {
        Floats depth;   ///< mm, within the furthest depth
        Floats towards; ///< above 0 if the ray reaches the plane from the viewer's side
    };
    /// `lines`: the rays' places at depth 0 (x, y: mm) and slopes (x, y), minus the central ray's.
    template <class Floats> INTEGRAL_INLINE Crossing<Floats> crossing(const Eight (&lines)[4]) const
    {
        const Floats by_x = broadcast<Floats>(depth_.by_x), by_y = broadcast<Floats>(depth_.by_y),
                     little = broadcast<Floats>(1e-3f), far = broadcast<Floats>(furthest_);
        const Floats towards = broadcast<Floats>(1) - by_x * load<Floats>(lines[2]) -
                               by_y * load<Floats>(lines[3]);
        const Floats depth = (broadcast<Floats>(depth_.at) + by_x * load<Floats>(lines[0]) +
                              by_y * load<Floats>(lines[1])) /
                             max(towards, little);
        return {max(min(depth, far), broadcast<Floats>(0) - far), towards - little};
    }

private:
    LinearFit depth_; ///< mm, by the distance from the beam's central ray
    float furthest_ = 0;
};

} // namespace integral

#endif
