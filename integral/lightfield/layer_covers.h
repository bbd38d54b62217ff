// SPDX-License-Identifier: AGPL-3.0-or-later
// What part of a pixel's beam is hidden by layers of surfaces, from place to place. Two ridges
// before each other hide the same lower half of a beam, a fence and a branch different parts: so
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
    /// Begins a pixel, without layers.
    void begin(const BeamPatch& patch);

    bool none() const { return covers_.empty(); }

    /// Adds a layer at a depth (mm). What it hides is a straight line through the samples: the part
    /// of them that ended there, by their place.
    void add(float depth, const ReachingSamples& samples);

    /// Sets the depth (mm) of the places at which open() is asked.
    void look_from(float depth);

    /// The part, 0.1 to 1, of the beam's light from a place in the patch that the layers let
    /// through, in terms of that from other places. Number: float or FourFloats.
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
    /// How far off the patch's middle the rays of a beam cross one depth, in terms of how far off
    /// it they meet another: the mean over the rays.
    float scale(int axis, float depth, float other_depth) const;

    struct Cover {
        float depth = 0;
        float at = 0, by_x = 0, by_y = 0; ///< the part in the middle, and its slopes
        float scale_x = 1, scale_y = 1;   ///< from the depth of the places asked for
    };
    BeamPatch patch_;
    std::vector<Cover> covers_;
};

} // namespace integral

#endif
