// SPDX-License-Identifier: AGPL-3.0-or-later
// Composes a pixel's light from samples of many pixels: layer by layer, from the viewer on.
//
// Where there is only one layer, its light is fitted (sample_fit.h). Where there are more, each is
// seen through those before it (layer_covers.h).
#ifndef INTEGRAL_LIGHTFIELD_SAMPLE_LAYERS_H
#define INTEGRAL_LIGHTFIELD_SAMPLE_LAYERS_H

#include "integral/lightfield/layer_covers.h"
#include "integral/lightfield/layer_plane.h"
#include "integral/lightfield/sample_fit.h"
#include "integral/lightfield/weighed_samples.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace integral {

class SampleLayers {
public:
    /// The samples of which a pixel's light is made; they are to be added before light().
    WeighedSamples& samples() { return samples_; }

    struct Light {
        LinearColour light{}; ///< of the pixel
        float own_part = 0;   ///< the part that the pixel's own samples have in it, about
    };
    /// The pixel's light; nothing if no sample met the beam.
    std::optional<Light> light();

    /// After light(): the variance of the samples that ended in the beam: of the square roots of
    /// their light, summed over red, green and blue.
    float variance() const;

private:
    struct Layer {
        float first_step = 0, end_step = 0; ///< its samples' steps: from the first, before the end
        float furthest = -1e9f, weight = 0;
        float depth = 0; ///< the mean by weight, mm
        LayerPlane plane;
        FourFloats light{}; ///< the sum by weight
    };
    static constexpr int most_steps = 1023;
    using Steps = std::array<std::uint64_t, (most_steps + 1) / 64>; ///< a bit for each step

    template <class Floats> Floats scaled(Floats depth) const;
    template <class Floats> void find_steps(Steps& steps);
    template <class Floats> void find_layers();
    template <class Floats> Floats weights_in(const Layer& layer, std::size_t eight) const;
    template <class Floats> void sum_layers();
    template <class Floats> FourFloats fitted() const;
    template <class Floats> ReachingSamples<float> reaching(const Layer& layer, float before) const;
    template <class Floats> void see_through_covers(Layer& layer);
    template <class Floats> FourFloats composed();
    template <class Floats> FourFloats light_with();
    FourFloats light_with_avx2();
    template <class Floats> float variance_with() const;
    float variance_with_avx2() const;

    WeighedSamples samples_;
    float steepness_ = 0;
    std::vector<Layer> layers_;
    /// Of eight samples that ended in the beam: their steps, not rounded, and how far they are from
    /// the beam's central line along both axes, mm.
    struct Placed {
        Eight steps, ways[2];
    };
    std::vector<Placed> placed_;
    LayerCovers covers_;
};

} // namespace integral

#endif
