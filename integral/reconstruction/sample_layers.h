// SPDX-License-Identifier: AGPL-3.0-or-later
// Composes a pixel's light from samples of many pixels: layer by layer, beginning at the viewer.
//
// If there is only one layer, its light is fitted (sample_fit.h); a floor far away and the sky
// behind it count as one layer. Several layers are each seen through the layers before them
// (layer_occlusion.h); the light of the first one is fitted too, and so is the fraction of the beam
// that it covers.
#ifndef INTEGRAL_RECONSTRUCTION_SAMPLE_LAYERS_H
#define INTEGRAL_RECONSTRUCTION_SAMPLE_LAYERS_H

#include "integral/reconstruction/layer_occlusion.h"
#include "integral/reconstruction/layer_plane.h"
#include "integral/reconstruction/sample_fit.h"
#include "integral/reconstruction/weighted_samples.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace integral {

class SampleLayers {
public:
    /// The samples that make up a pixel's light. They must be added before light(), which weights
    /// them.
    WeightedSamples& samples() { return samples_; }

    struct Light {
        LinearColour light{}; ///< of the pixel
        float own_part = 0;   ///< approximate weight of the pixel's own samples
    };
    /// The pixel's light; nothing if no sample met the beam.
    std::optional<Light> light();

private:
    struct Layer {
        float first_step = 0, end_step = 0; ///< its samples' steps: in [first_step, end_step)
        float furthest = -1e9f, weight = 0;
        float depth = 0; ///< weighted mean of the samples' depths, mm
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
    /// Sums over a layer's samples: of the weighted light, and of the weights.
    struct Shown {
        FourFloats light;
        float weight;
    };
    template <class Floats> Shown seen_through_covers(const Layer& layer);
    /// Light that a layer adds, and fraction that it hides, both relative to the light that the
    /// layers before it let through.
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

    WeightedSamples samples_;
    float divergence_ = 0;
    std::vector<Layer> layers_;
    /// Data of eight samples that ended in the beam: their steps, not rounded; their distances from
    /// the beam's central ray along both axes, mm (`ways`); and, for both axes, their
    /// BeamFootprint::Axis::square_above_mean (`squares`).
    struct Placed {
        Eight steps, ways[2], squares[2];
    };
    std::vector<Placed> placed_;
    LayerOcclusion covers_;
};

} // namespace integral

#endif
