// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores what the samples of a frame's pixels saw, and along which lines, so that pixels whose
// beams meet the same places can use each other's samples (reconstruction.h).
#ifndef INTEGRAL_LIGHTFIELD_BEAM_SAMPLES_H
#define INTEGRAL_LIGHTFIELD_BEAM_SAMPLES_H

#include "integral/lightfield/first_samples.h"
#include "integral/lightfield/linear_colour.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace integral {

/// A line of sight, along a lattice's axes (x across, y along): where it crosses the plane of the
/// poles (mm), and how far it moves for each mm away from the viewer.
struct SightSlope {
    std::array<float, 2> point{}, slope{};
};
SightSlope sight_slope(const Lattice& lattice, const BeamRay& ray);

/// Stored samples, up to most_stored of a pixel. Different threads may store samples of different
/// pixels at the same time.
class BeamSamples {
public:
    static constexpr int most_stored = 16;

    /// One sample. point, slope: relative to the line from its pixel's centre through the lens's
    /// pole.
    struct Sample {
        float depth = 0; ///< mm from the sheet away from the viewer, at most furthest_depth
        std::array<std::int16_t, 2> point{}, slope{}, tilt{};
        StoredLight light;
    };
    static constexpr float furthest_depth = 1e5f;

    /// The units of a camera's samples: of Sample::point (mm), slope and tilt.
    struct Units {
        float point = 0, slope = 0, tilt = 0;
    };
    static Units units(const IntegralCamera& camera);
    const Units& units() const { return units_; }

    struct Pixel {
        SightSlope centre;
        Sample first;
        const Sample* more = nullptr; ///< those after the first
        std::uint16_t number = 0;     ///< 0: the pixel is empty
        FirstSamples::StoredLens lens{};
        /// Whether other pixels may use the samples: if not, the pixel is empty, or the light of
        /// one was too bright to be stored, or not a number.
        bool lends = false;
    };
    static constexpr std::size_t bytes_a_pixel = 56;

    /// `memory`: bytes_a_pixel for each of the film's pixels, all 0, aligned to 8; null: the object
    /// allocates its own.
    explicit BeamSamples(const IntegralCamera& camera, std::shared_ptr<void> memory = nullptr);

    /// A sample before it is stored.
    struct Seen {
        SightSlope line;
        double depth = 0; ///< mm, may be infinite
        LinearColour light{};
        /// How the surface lies: from a line whose slope differs by d, the area in which it is seen
        /// is 1 + dot(tilt, d) times as large. Below 0, that line sees its other side. This is the
        /// lateral part of the surface's normal, divided by the normal's product with (slope, 1).
        std::array<float, 2> tilt{};
    };
    /// Sets a pixel's centre, its lens and its first sample.
    void set_first(int x, int y, const SightSlope& centre, LensIndex lens, const Seen& seen);

    /// Further samples of the pixels of one block, gathered by one thread.
    class Gathered {
    public:
        void begin(int x, int y) { pixels_.push_back({x, y, samples_.size(), true}); }
        void add(const BeamSamples& store, const Seen& seen);

    private:
        friend class BeamSamples;
        struct Begun {
            int x, y;
            std::size_t at;
            bool lends;
        };
        std::vector<Begun> pixels_;
        std::vector<Sample> samples_;
    };
    /// Stores what was gathered, of a block whose first row is `top`, and empties it.
    void store(int top, Gathered& gathered);

    /// Frees the further samples of blocks whose first row is above `row`. No other thread may be
    /// using them.
    void forget_above(int row);

    const Pixel& pixel(std::size_t index) const { return pixels_[index]; }
    const Pixel& pixel(int x, int y) const { return pixels_[std::size_t(y) * width_ + x]; }

    /// Of some of eight pixels, those at `index` + k for which bit k of `which` is set: the bits of
    /// those that are behind a lens and lend their samples. Without branches, which the processor
    /// could not predict.
    unsigned lending(std::size_t index, unsigned which, FirstSamples::StoredLens lens) const
    {
        unsigned found = 0;
        for (unsigned left = which; left != 0; left &= left - 1) {
            const int k = __builtin_ctz(left);
            const Pixel& pixel = pixels_[index + k];
            const unsigned is_behind = unsigned(pixel.lens[0] == lens[0]) &
                                       unsigned(pixel.lens[1] == lens[1]);
            found |= (is_behind & unsigned(pixel.lends)) << k;
        }
        return found;
    }


private:
    Sample stored(const SightSlope& centre, const Seen& seen) const;

    int width_;
    Units units_;
    std::shared_ptr<void> memory_;
    Pixel* pixels_;
    std::mutex mutex_;
    std::multimap<int, std::unique_ptr<Sample[]>> further_; ///< by the first row of their block
};
static_assert(sizeof(BeamSamples::Pixel) == BeamSamples::bytes_a_pixel);

} // namespace integral

#endif
