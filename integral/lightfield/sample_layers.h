// SPDX-License-Identifier: AGPL-3.0-or-later
// Composes a pixel's light from samples of many pixels: layer by layer, from the viewer on.
#ifndef INTEGRAL_LIGHTFIELD_SAMPLE_LAYERS_H
#define INTEGRAL_LIGHTFIELD_SAMPLE_LAYERS_H

#include "integral/lightfield/beam_patch.h"

#include <optional>
#include <vector>

namespace integral {

class SampleLayers {
public:
    /// Begins a pixel. `centre`: the line from its centre through the lens's pole.
    void begin(const BeamPatch& patch, const SightSlope& centre);

    /// Adds the samples of a pixel, which must not be empty. `is_own`: it is the pixel itself.
    void add(const BeamSamples& samples, const BeamSamples::Pixel& pixel, bool is_own);

    struct Light {
        LinearColour light{}; ///< of the pixel
        float own_part = 0;   ///< the part that the pixel's own samples have in it, about
        float variance = 0;   ///< of the samples in the beam: of the square roots of their light,
                              ///< summed over red, green and blue
    };
    /// The pixel's light; nothing if no sample met the beam.
    std::optional<Light> light();

private:
    /// Four numbers side by side in a vector register (of GCC and Clang).
    typedef float Four __attribute__((vector_size(16)));

    /// Four samples side by side. `lines` are those of the samples, less the centre's. A sample's
    /// is one vector at first, (point x, y, slope x, y); weigh() turns them, so that a vector has
    /// the same number of all four samples.
    struct Group {
        std::array<Four, 4> lines;
        alignas(16) std::array<float, 4> depths; ///< mm
        alignas(16) std::array<float, 4> shares; ///< as which the samples count inside the beam
        alignas(16) std::array<float, 4> weights; ///< the shares times the beam's density where
                                                  ///< the samples ended
        std::array<StoredLight, 4> light;
        std::array<std::uint16_t, 4> layers;
    };
    struct Layer {
        float furthest = -1e9f, weight = 0, depth = 0; ///< depth: the sum of depths by weight
        Four light{};                                  ///< the sum by weight
    };
    Four density(const Group& group, Four depth) const;
    Four scaled(Four depth) const;
    void weigh();
    void find_layers();
    void sum_light();
    float passing(const Layer& layer) const;

    std::array<Four, 2> cells_{}, cell_slopes_{}, pixels_{}, pixel_slopes_{}; ///< of BeamPatch
    Four centre_{};
    float steepness_ = 0;
    std::vector<Group> groups_;
    std::size_t number_ = 0;                ///< of samples
    std::size_t own_begin_ = 0, own_end_ = 0; ///< the pixel's own
    float nearest_ = 0, furthest_ = 0;      ///< the depths of the samples that ended in the beam
    float weight_ = 0;                      ///< of all of them
    Four roots_{};                          ///< the sum by weight of the light's square roots
    std::vector<Layer> layers_;
};

} // namespace integral

#endif
