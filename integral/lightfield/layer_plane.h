// SPDX-License-Identifier: AGPL-3.0-or-later
// How a layer of surfaces lies to a pixel's beam: the plane that best fits the places where samples
// met it.
//
// A floor that is seen nearly edge-on lies at many depths. A sample that looks up passes above it,
// at whatever depth; only a sample that comes down to the floor's plane tells where the floor ends.
#ifndef INTEGRAL_LIGHTFIELD_LAYER_PLANE_H
#define INTEGRAL_LIGHTFIELD_LAYER_PLANE_H

#include "integral/lightfield/eight_floats.h"
#include "integral/lightfield/sample_fit.h"

namespace integral {

/// The depth (mm) as a linear function of the distance (mm) from the beam's central line along both
/// axes.
class LayerPlane {
public:
    LayerPlane() = default;

    /// `depths`: the sums over the samples that met a layer, of their depths (mm) and of their
    /// distances from the central line (mm). `reach`: half the patch's width along both axes at
    /// their mean depth, mm.
    LayerPlane(const LinearSums<float>& depths, const std::array<float, 2>& reach)
        : depth_(fitted_to(depths, reach))
    {
    }

    /// How much the depth at which lines cross the plane depends on their slopes, which are up to
    /// `slopes` to either side of the central line's: above 1, some of them never come down to it.
    float tilt(const std::array<float, 2>& slopes) const
    {
        return std::fabs(depth_.by_x) * slopes[0] + std::fabs(depth_.by_y) * slopes[1];
    }

    /// Where lines cross the plane coming from the viewer's side.
    template <class Floats> struct Crossing {
        Floats depth;   ///< mm, at most 1e5 before or behind the sheet
        Floats towards; ///< above 0 if the line comes from that side
    };
    /// `lines`: their places at depth 0 (x, y: mm), and their slopes (x, y), less those of the
    /// beam's central line.
    template <class Floats> INTEGRAL_INLINE Crossing<Floats> crossing(const Eight (&lines)[4]) const
    {
        const Floats by_x = eight_of<Floats>(depth_.by_x), by_y = eight_of<Floats>(depth_.by_y),
                     little = eight_of<Floats>(1e-3f), far = eight_of<Floats>(1e5f);
        const Floats towards = eight_of<Floats>(1) - by_x * loaded<Floats>(lines[2]) -
                               by_y * loaded<Floats>(lines[3]);
        const Floats depth = (eight_of<Floats>(depth_.at) + by_x * loaded<Floats>(lines[0]) +
                              by_y * loaded<Floats>(lines[1])) /
                             most(towards, little);
        return {most(least(depth, far), eight_of<Floats>(0) - far), towards - little};
    }

private:
    LinearFit depth_; ///< mm, by the distance from the beam's central line
};

} // namespace integral

#endif
