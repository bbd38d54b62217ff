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

    struct Entry {
        Four line;    ///< of the sample, less the centre's: point (x, y) and slope (x, y)
        float depth;  ///< mm
        float share;  ///< as which the sample counts where it is in the beam
        float weight; ///< share times the beam's density where the sample ended
        StoredLight light;
    };
    struct Layer {
        float nearest, furthest;     ///< depths
        float weight = 0, depth = 0; ///< sums: of the weights, and of the depths by weight
        Four light{}, roots{};       ///< the sums by weight: of the light, and of its square roots
        void add(const Entry& entry);
    };
    float density(Four line, float depth) const;
    float scaled(float depth) const;
    void find_layers();
    float passing(const Layer& layer) const;

    Four centre_{}, widths_{}, width_slopes_{};
    float steepness_ = 0;
    std::vector<Entry> entries_;
    std::size_t number_ = 0; ///< of entries
    Layer all_{};            ///< all samples that ended in the beam
    float own_ = 0;          ///< the weight of the pixel's own
    std::vector<Layer> layers_;
};

} // namespace integral

#endif
