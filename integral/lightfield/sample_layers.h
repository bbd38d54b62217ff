// SPDX-License-Identifier: AGPL-3.0-or-later
// Composes a pixel's light from samples of many pixels: layer by layer, from the viewer on.
//
// Where there is only one layer, its light is fitted (sample_fit.h); so is that of a floor far away
// together with the sky behind it. Where there are more, each is seen through those before it
// (layer_covers.h); the light of the first one is fitted, too, and so is what part of the beam it
// covers.
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
    /// The samples of which a pixel's light is made; they are to be added before light(), which
    /// weighs them.
    WeighedSamples& samples() { return samples_; }

    struct Light {
        LinearColour light{}; ///< of the pixel
        float own_part = 0;   ///< the part that the pixel's own samples have in it, about
    };
    /// The pixel's light; nothing if no sample met the beam.
    std::optional<Light> light();

private:
    struct Layer {
        float first_step = 0, end_step = 0; ///< its samples' steps: from the first, before the end
        float furthest = -1e9f, weight = 0;
        float depth = 0; ///< the mean by weight, mm
        LayerPlane plane;
    };
    static constexpr int most_steps = 1023;
    using Steps = std::array<std::uint64_t, (most_steps + 1) / 64>; ///< a bit for each step

    template <class Floats> Floats scaled(Floats depth) const;
    template <class Floats> void find_steps(Steps& steps);
    template <class Floats> void find_layers();
    void join_far_layers();
    template <class Floats> Floats weights_in(const Layer* layer, std::size_t eight) const;
    template <class Floats> void place_layers();
    template <class Floats> void find_squares(const Layer* layer);
    template <class Floats> void fitted_places(std::size_t eight, Floats (&places)[4]) const;
    template <class Floats> PlaceSums<Floats> places_of(const Layer* layer) const;
    template <class Floats> ValueSums light_of(const Layer* layer) const;
    template <class Floats> FourFloats least_light(const Layer* layer) const;
    template <class Floats>
    FourFloats fitted_light(const PlaceRegression& regression, const Layer* layer,
                            float covered) const;
    template <class Floats> FourFloats only_layer();
    template <class Floats>
    ReachingSamples<float> reaching(const Layer& layer, float before,
                                    PlaceSums<Floats>* places) const;
    /// Sums over a layer's samples: of their light by weight, and of the weights.
    struct Shown {
        FourFloats light;
        float weight;
    };
    template <class Floats> Shown seen_through_covers(const Layer& layer);
    /// What a layer adds to the light that comes through those before it, and what part of that
    /// it hides.
    struct Part {
        FourFloats light;
        float covered;
    };
    template <class Floats> Part fitted_part(const Layer& layer, float before);
    template <class Floats>
    Part plain_part(const Layer& layer, float before, float behind, bool is_little);
    template <class Floats> FourFloats composed();
    bool is_floor() const;
    template <class Floats> FourFloats light_with();
    FourFloats light_with_avx2();

    WeighedSamples samples_;
    float steepness_ = 0;
    std::vector<Layer> layers_;
    /// Of eight samples that ended in the beam: their steps, not rounded; along both axes, how far
    /// they are from the beam's central line (mm), and the squares of their places in the patch,
    /// less the mean of such squares over the beam.
    struct Placed {
        Eight steps, ways[2], squares[2];
    };
    std::vector<Placed> placed_;
    LayerCovers covers_;
};

} // namespace integral

#endif
