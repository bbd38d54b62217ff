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
        float furthest = -1e9f, weight = 0;
        float depth = 0; ///< the mean by weight, mm
        LayerPlane plane;
        std::uint32_t begin = 0, end = 0; ///< its samples: from begin to end - 1 in ordered_
        FourFloats light{};               ///< the sum by weight
    };
    static constexpr int most_steps = 1023;
    using Steps = std::array<std::uint64_t, (most_steps + 1) / 64>; ///< a bit for each step

    template <class Floats> Floats scaled(Floats depth) const;
    template <class Floats> void find_steps_with(Steps& steps);
    void find_steps_with_avx2(Steps& steps);
    void find_steps(Steps& steps);
    void find_layers();
    void order_by_layer(const std::uint16_t* layer_of);
    void sum_layers();
    template <class Floats> FitSums fit_with() const;
    FitSums fit_with_avx2() const;
    FourFloats fitted() const;
    template <class Floats>
    ReachingSamples<float> reaching_with(const Layer& layer, float before) const;
    ReachingSamples<float> reaching_with_avx2(const Layer& layer, float before) const;
    ReachingSamples<float> reaching(const Layer& layer, float before) const;
    void see_through_covers(Layer& layer);
    FourFloats composed();

    WeighedSamples samples_;
    float steepness_ = 0;
    std::vector<Layer> layers_;
    std::vector<const WeighedSamples::Met*> ordered_; ///< those that met the beam, layer by layer
    LayerCovers covers_;
};

} // namespace integral

#endif
