// SPDX-License-Identifier: AGPL-3.0-or-later
// Which places of a pixel's beam are hidden by layers of surfaces. Two ridges, one behind the
// other, may hide the same lower half of a beam, a fence and a branch different parts of it. So
// what is seen of a layer depends on where the nearer ones are.
#ifndef INTEGRAL_LIGHTFIELD_LAYER_COVERS_H
#define INTEGRAL_LIGHTFIELD_LAYER_COVERS_H

#include "integral/lightfield/beam_patch.h"
#include "integral/lightfield/four_floats.h"

#include <algorithm>
#include <vector>

namespace integral {

/// The samples that reach a layer inside the beam, and those of them that end there. Each number is
/// that of four samples side by side: their sum is meant. Places are in terms of half the patch's
/// width at the layer's depth.
struct ReachingSamples {
    FourFloats weight{}, squared_weight{};
    FourFloats x{}, y{}, xx{}, xy{}, yy{}; ///< by weight
    FourFloats ended{}, ended_x{}, ended_y{};
    FourFloats passing{}; ///< the weight of those that go on, seen through the layers before

    void add(FourFloats more, FourFloats end_here, FourFloats at_x, FourFloats at_y)
    {
        const FourFloats more_x = more * at_x, more_y = more * at_y;
        weight += more;
        squared_weight += more * more;
        x += more_x;
        y += more_y;
        xx += more_x * at_x;
        xy += more_x * at_y;
        yy += more_y * at_y;
        ended += end_here;
        ended_x += end_here * at_x;
        ended_y += end_here * at_y;
    }
};

/// The layers before the one that is looked at.
class LayerCovers {
public:
    void clear() { covers_.clear(); }
    bool none() const { return covers_.empty(); }

    /// Adds a layer at a depth (mm). The part of the beam that it hides is taken for a linear
    /// function of the place, which is fitted to the samples that end there and those that go on.
    void add(float depth, const ReachingSamples& samples);

    /// Sets the depth (mm) of the places in the patch at which open() is asked.
    void look_from(const BeamPatch& patch, float depth);

    /// How much of the light from a place in the patch the layers let through. The scale is
    /// arbitrary, only the ratio between places counts. Number: float or FourFloats.
    template <class Number> Number open(Number x, Number y) const
    {
        Number part = Number{} + 1;
        for (const Cover& cover : covers_)
            part *= open_part(cover.at + cover.by_x * cover.scale_x * x +
                              cover.by_y * cover.scale_y * y);
        return part;
    }

private:
    // An outline is sharp, the straight line through the samples on both its sides is not: twice as
    // steep a line, about the place where half is hidden, is nearer to it. A little is let through
    // everywhere, as the line is uncertain.
    template <class Number> static Number open_part(Number covered)
    {
        return within(1.5f - 2 * covered, 0.1f, 1.0f);
    }
    static float within(float x, float low, float high) { return std::clamp(x, low, high); }
    static FourFloats within(FourFloats x, float low, float high)
    {
        return most(least(x, FourFloats{} + high), FourFloats{} + low);
    }
    struct Cover {
        float depth = 0;
        float at = 0, by_x = 0, by_y = 0; ///< the part in the middle, and its slopes
        float scale_x = 1, scale_y = 1;   ///< from the depth of the places asked for
    };
    std::vector<Cover> covers_;
};

} // namespace integral

#endif
