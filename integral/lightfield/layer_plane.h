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

/// Sums over the samples that met a layer. Their places are distances from the beam's central line
/// along both axes, mm. Number: a type of eight floats (eight_floats.h), of which the sum is meant,
/// or float.
template <class Number> struct LayerSums {
    Number weight{}, squared_weight{};
    Number x{}, y{}, depth{}; ///< by weight
    Number xx{}, xy{}, yy{}, x_depth{}, y_depth{};

    INTEGRAL_INLINE void add(Number more, Number at_x, Number at_y, Number at_depth)
    {
        const Number more_x = more * at_x, more_y = more * at_y;
        weight = weight + more;
        squared_weight = squared_weight + more * more;
        x = x + more_x;
        y = y + more_y;
        depth = depth + more * at_depth;
        xx = xx + more_x * at_x;
        xy = xy + more_x * at_y;
        yy = yy + more_y * at_y;
        x_depth = x_depth + more_x * at_depth;
        y_depth = y_depth + more_y * at_depth;
    }

    INTEGRAL_INLINE LayerSums<float> sums() const
    {
        const FourFloats a = sums_of_eight(weight, squared_weight, x, y),
                         b = sums_of_eight(depth, xx, xy, yy),
                         c = sums_of_eight(x_depth, y_depth, Number{}, Number{});
        return {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3], c[0], c[1]};
    }
};

/// The depth (mm) as a linear function of the distance (mm) from the beam's central line along both
/// axes.
class LayerPlane {
public:
    LayerPlane() = default;

    /// `reach`: half the patch's width along both axes at the samples' mean depth, mm.
    LayerPlane(const LayerSums<float>& sums, const std::array<float, 2>& reach);

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
