// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores what the samples of a frame's pixels saw, and along which lines, so that pixels whose
// beams meet the same places can use each other's samples (reconstruction.h).
#ifndef INTEGRAL_LIGHTFIELD_BEAM_SAMPLES_H
#define INTEGRAL_LIGHTFIELD_BEAM_SAMPLES_H

#include "integral/lightfield/eight_floats.h"
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

    /// One sample. WeighedSamples reads it as two times four floats.
    struct Sample {
        float depth = 0; ///< mm from the sheet away from the viewer, at most furthest_depth
        SightSlope line;
        std::array<std::int16_t, 2> tilt{}; ///< Seen::tilt, divided by tilt_unit()
        StoredLight light;
    };
    static constexpr float furthest_depth = 1e5f;

    /// The unit of a camera's Sample::tilt.
    float tilt_unit() const { return tilt_unit_; }

    struct Pixel {
        SightSlope centre; ///< the line from its centre through the lens's pole
        Sample first;
        const Sample* more = nullptr; ///< those after the first
        std::uint16_t number = 0;     ///< 0: the pixel is empty
    };
    /// The bytes a pixel of the two parts of the memory: the second part follows the first.
    static constexpr std::size_t bytes_of_pixels = 64, bytes_of_lenders = 4;

    /// `memory`: both parts, for each of the film's pixels, all 0, aligned to 8; null: the object
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
    /// The pixels from an index on, which may be one before the first.
    const Pixel* pixels_from(std::ptrdiff_t index) const { return pixels_ + index; }
    const Pixel& pixel(int x, int y) const { return pixels_[index(x, y)]; }

    /// Whether samples of a pixel may be used: not if the pixel is empty, or if the light of one
    /// sample was too bright to be stored, or not a number.
    bool lends(std::size_t index) const { return lenders_[index] != nobody; }

    /// Of some of eight pixels, those at `index` + k for which bit k of `which` is set: the bits of
    /// those that are behind a lens and lend their samples.
    unsigned lending(std::ptrdiff_t index, unsigned which, FirstSamples::StoredLens lens) const
    {
        const std::uint32_t lender = lender_behind(lens);
        if (index >= 0 && index + 8 <= size_) {
            TwiceFourIntegers lenders;
            std::memcpy(&lenders, lenders_ + index, sizeof lenders);
            const FourIntegers wanted = FourIntegers{} + std::int32_t(lender);
            return which & bits(TwiceFourIntegers{lenders.low == wanted, lenders.high == wanted});
        }
        unsigned found = 0;
        for (unsigned left = which; left != 0; left &= left - 1) {
            const int k = __builtin_ctz(left);
            found |= unsigned(lenders_[index + k] == lender) << k;
        }
        return found;
    }

private:
    Sample stored(const Seen& seen) const;
    std::size_t index(int x, int y) const { return std::size_t(y) * width_ + x; }

    /// A pixel's lens in one number. That of a pixel that lends nothing is the number of a lens
    /// that is 32768 steps away from those in the frame's middle.
    static std::uint32_t lender_behind(FirstSamples::StoredLens lens)
    {
        return FirstSamples::number_of(lens) ^ 0x80008000u;
    }
    static constexpr std::uint32_t nobody = 0;

    int width_;
    std::ptrdiff_t size_; ///< of the frame, pixels
    float tilt_unit_;
    std::shared_ptr<void> memory_;
    Pixel* pixels_;
    std::uint32_t* lenders_; ///< lender_behind of each pixel's lens, or nobody
    std::mutex mutex_;
    std::multimap<int, std::unique_ptr<Sample[]>> further_; ///< by the first row of their block
};
static_assert(sizeof(BeamSamples::Pixel) == BeamSamples::bytes_of_pixels &&
              sizeof(std::uint32_t) == BeamSamples::bytes_of_lenders);

} // namespace integral

#endif
