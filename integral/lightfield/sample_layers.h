// SPDX-License-Identifier: AGPL-3.0-or-later
// Composes a pixel's light from samples of many pixels: layer by layer, from the viewer on.
//
// Where there is only one layer, its light is fitted (sample_fit.h). Where there are more, each is
// seen through those before it (layer_covers.h).
#ifndef INTEGRAL_LIGHTFIELD_SAMPLE_LAYERS_H
#define INTEGRAL_LIGHTFIELD_SAMPLE_LAYERS_H

#include "integral/lightfield/layer_covers.h"

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
    };
    /// The pixel's light; nothing if no sample met the beam.
    std::optional<Light> light();

    /// After light(): the variance of the samples that ended in the beam: of the square roots of
    /// their light, summed over red, green and blue.
    float variance() const;

private:
    /// Four samples side by side. `lines` are those of the samples, less the centre's. A
    /// sample's is one vector at first, (point x, y, slope x, y); weigh() turns them, so that a
    /// vector has the same number of all four samples.
    struct Group {
        std::array<FourFloats, 4> lines;
        std::array<FourFloats, 2> tilts; ///< BeamSamples::Seen::tilt
        FourFloats areas;   ///< in which the samples' surfaces are seen from the pixel's direction,
                            ///< in terms of those from the samples' own; below 0: the other side
        FourFloats depths;  ///< mm
        FourFloats shares;  ///< as which the samples count inside the beam
        FourFloats weights; ///< the shares times the beam's density where the samples ended
        std::array<StoredLight, 4> light;
    };
    /// A sample that ended in the beam.
    struct Met {
        FourFloats numbers; ///< its weight, its place in the patch (x, y: -1 to 1), its depth, mm
        float weight() const { return numbers[0]; }
        float depth() const { return numbers[3]; }
        StoredLight light;
        std::uint16_t layer;
    };
    struct Layer {
        float furthest = -1e9f, weight = 0;
        float depth = 0;    ///< the mean by weight, mm
        FourFloats light{}; ///< the sum by weight
    };
    /// Where samples are, in terms of half the patch's width along both axes, and the beam's
    /// density there, in terms of the greatest.
    struct Density {
        FourFloats x, y, value;
    };
    Density density(const Group& group, FourFloats depth) const;
    FourFloats seen_part(Group& group) const;
    FourFloats seen_depths(const Group& group, FourFloats depth) const;
    float scaled(float depth) const;
    void weigh();
    void find_layers();
    void sum_layers();
    FourFloats fitted() const;
    ReachingSamples reaching(const Layer& layer, float before) const;
    void see_through_covers(Layer& layer);
    FourFloats composed();

    BeamPatch patch_;
    /// Numbers of patch_.
    std::array<FourFloats, 2> cells_{}, cell_slopes_{}, pixels_{}, pixel_slopes_{}, lent_slopes_{},
        lent_ways_{};
    FourFloats centre_{};
    float steepness_ = 0;
    std::vector<Group> groups_;
    std::size_t number_ = 0;                  ///< of samples
    std::size_t own_begin_ = 0, own_end_ = 0; ///< the pixel's own
    std::vector<Met> met_;
    std::size_t met_number_ = 0;
    float weight_ = 0;                 ///< of all
    float nearest_ = 0, furthest_ = 0; ///< their depths
    std::vector<Layer> layers_;
    LayerCovers covers_;
};

} // namespace integral

#endif
