// SPDX-License-Identifier: AGPL-3.0-or-later
// Determines which places of a pixel's beam are hidden by layers of surfaces. Two ridges, one
// behind the other, may hide the same lower half of a beam; a fence and a branch may hide different
// parts of it. So the visible part of a layer depends on where the nearer layers are.
#ifndef INTEGRAL_RECONSTRUCTION_LAYER_OCCLUSION_H
#define INTEGRAL_RECONSTRUCTION_LAYER_OCCLUSION_H

#include "integral/base/eight_floats.h"
#include "integral/reconstruction/beam_footprint.h"
#include "integral/reconstruction/sample_fit.h"

#include <vector>

namespace integral {

/// Sums over the samples that reach a layer inside the beam. Places are divided by half the
/// footprint's width at the layer's depth. Number: float, or a type of eight partial sums
/// (eight_floats.h).
template <class Number> struct ReachingSamples {
    LinearSums<Number> ended; ///< over these samples; value: 1 if a sample ends there, else 0
    Number passing{};         ///< weight of those that go on, times transmittance() where they
                              ///< cross

    INTEGRAL_INLINE ReachingSamples<float> sums() const
    {
        return {ended.sums(), sum_of_eight(passing)};
    }
};

/// The layers nearer to the viewer than the current one, which may hide it.
class LayerOcclusion {
public:
    void clear() { covers_.clear(); }
    bool none() const { return covers_.empty(); }

    /// Adds a layer at a depth (mm). The hidden fraction of the beam is modelled as a linear
    /// function of the place, fitted to the samples that end there and the samples that go on.
    void add(float depth, const ReachingSamples<float>& samples);

    /// Sets the depth (mm) of the places that transmittance() takes.
    void look_from(const BeamFootprint& patch, float depth);

    /// Fraction of the light from a place in the footprint that the layers let through, for eight
    /// places or one (Number: as in ReachingSamples). The scale is arbitrary; only the ratio
    /// between places counts.
    template <class Number> INTEGRAL_INLINE Number transmittance(Number x, Number y) const
    {
        const Number one = broadcast<Number>(1);
        Number part = one;
        for (const Cover& cover : covers_) {
            const Number covered = broadcast<Number>(cover.part.at) +
                                   broadcast<Number>(cover.part.by_x * cover.scale_x) * x +
                                   broadcast<Number>(cover.part.by_y * cover.scale_y) * y,
                         open = broadcast<Number>(half_open) -
                                broadcast<Number>(steepness) * covered;
            part = part * max(min(open, one), broadcast<Number>(little));
        }
        return part;
    }

private:
    // At its outline a layer ends in a sharp step, but the linear function fitted to the samples is
    // a ramp. A ramp twice as steep, with the same place of half transmittance, is nearer to the
    // step. Since the fit is uncertain, at least the fraction `little` is let through everywhere.
    static constexpr float steepness = 2, half_open = 1.5f, little = 0.1f;
    struct Cover {
        float depth = 0;
        LinearFit part;                 ///< covered fraction, by place
        float scale_x = 1, scale_y = 1; ///< to convert places that are at look_from()'s depth
    };
    std::vector<Cover> covers_;
};

} // namespace integral

#endif
