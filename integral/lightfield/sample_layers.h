// SPDX-License-Identifier: AGPL-3.0-or-later
// Composes a pixel's light from samples of many pixels: layer by layer, from the viewer on.
//
// Where there is only one layer, the light at the middle of the beam's patch is that of a straight
// line through the samples (a regression of their light on their places): so it does not matter
// that they lie unevenly about the middle, as they do by chance and at a lens's border.
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

    /// Adds the samples of a pixel, which must not be empty. `part`: their weight, 0 to 1.
    /// `is_own`: it is the pixel itself.
    void add(const BeamSamples& samples, const BeamSamples::Pixel& pixel, float part, bool is_own);

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
        Four depths;  ///< mm
        Four shares;  ///< as which the samples count inside the beam
        Four weights; ///< the shares times the beam's density where the samples ended
        std::array<StoredLight, 4> light;
    };
    /// A sample that ended in the beam.
    struct Met {
        Four numbers; ///< its weight, its place in the patch (x, y: -1 to 1) and its depth, mm
        StoredLight light;
        std::uint16_t layer;
    };
    struct Layer {
        float furthest = -1e9f, weight = 0, depth = 0; ///< depth: the sum of depths by weight
        Four light{};                                  ///< the sum by weight
    };
    /// Where samples are, in terms of half the patch's width along both axes, and the beam's
    /// density there, in terms of the greatest.
    struct Density {
        Four x, y, value;
    };
    Density density(const Group& group, Four depth) const;
    float scaled(float depth) const;
    void weigh();
    void find_layers();
    void sum_layers();
    Four fitted();
    Four composed() const;
    float passing(const Layer& layer) const;

    std::array<Four, 2> cells_{}, cell_slopes_{}, pixels_{}, pixel_slopes_{}; ///< of BeamPatch
    Four centre_{};
    float steepness_ = 0;
    std::vector<Group> groups_;
    std::size_t number_ = 0;                  ///< of samples
    std::size_t own_begin_ = 0, own_end_ = 0; ///< the pixel's own
    std::vector<Met> met_;
    std::size_t met_number_ = 0;
    float weight_ = 0;                 ///< of all
    float nearest_ = 0, furthest_ = 0; ///< their depths
    Four light_{}, roots_{};           ///< sums by weight: of their light, and of its square roots
    std::vector<Layer> layers_;
};

} // namespace integral

#endif
