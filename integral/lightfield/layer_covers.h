// SPDX-License-Identifier: AGPL-3.0-or-later
// Which places of a pixel's beam are hidden by layers of surfaces. Two ridges, one behind the
// other, may hide the same lower half of a beam, a fence and a branch different parts of it. So
// what is seen of a layer depends on where the nearer ones are.
#ifndef INTEGRAL_LIGHTFIELD_LAYER_COVERS_H
#define INTEGRAL_LIGHTFIELD_LAYER_COVERS_H

#include "integral/lightfield/beam_patch.h"
#include "integral/lightfield/eight_floats.h"
#include "integral/lightfield/sample_fit.h"

#include <vector>

namespace integral {

/// The samples that reach a layer inside the beam, and those of them that end there. Places are in
/// terms of half the patch's width at the layer's depth. Number: a type of eight floats
/// (eight_floats.h), of which the sum is meant, or float.
template <class Number> struct ReachingSamples {
    LinearSums<Number> ended; ///< over all of them; the value is 1 for those that end there, else 0
    Number passing{};         ///< the weight of those that go on, seen through the layers before

    INTEGRAL_INLINE ReachingSamples<float> sums() const
    {
        return {ended.sums(), sum_of_eight(passing)};
    }
};

/// The layers before the one that is looked at.
class LayerCovers {
public:
    void clear() { covers_.clear(); }
    bool none() const { return covers_.empty(); }

    /// Adds a layer at a depth (mm). The part of the beam that it hides is taken for a linear
    /// function of the place, which is fitted to the samples that end there and those that go on.
    void add(float depth, const ReachingSamples<float>& samples);

    /// Sets the depth (mm) of the places in the patch at which open() is asked.
    void look_from(const BeamPatch& patch, float depth);

    /// How much of the light from a place in the patch the layers let through, for eight places or
    /// one (Number: as above). The scale is arbitrary, only the ratio between places counts.
    template <class Number> INTEGRAL_INLINE Number open(Number x, Number y) const
    {
        const Number one = eight_of<Number>(1);
        Number part = one;
        for (const Cover& cover : covers_) {
            const Number covered = eight_of<Number>(cover.part.at) +
                                   eight_of<Number>(cover.part.by_x * cover.scale_x) * x +
                                   eight_of<Number>(cover.part.by_y * cover.scale_y) * y,
                         open = eight_of<Number>(half_open) - eight_of<Number>(steepness) * covered;
            part = part * most(least(open, one), eight_of<Number>(little));
        }
        return part;
    }

private:
    // An outline is sharp, the straight line through the samples on both its sides is not: twice as
    // steep a line, about the place where half is hidden, is nearer to it. A little is let through
    // everywhere, as the line is uncertain.
    static constexpr float steepness = 2, half_open = 1.5f, little = 0.1f;
    struct Cover {
        float depth = 0;
        LinearFit part;                 ///< that is covered
        float scale_x = 1, scale_y = 1; ///< from the depth of the places asked for
    };
    std::vector<Cover> covers_;
};

} // namespace integral

#endif
