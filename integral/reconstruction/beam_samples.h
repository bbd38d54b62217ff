// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores the samples of a frame's pixels with their rays, so that pixels whose beams meet the same
// places can use each other's samples (reconstruction.h).
#ifndef INTEGRAL_RECONSTRUCTION_BEAM_SAMPLES_H
#define INTEGRAL_RECONSTRUCTION_BEAM_SAMPLES_H

#include "integral/base/eight_floats.h"
#include "integral/frame/linear_colour.h"
#include "integral/reconstruction/light_field_image.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace integral {

/// A ray of the light field (two-plane parametrisation), in a lattice's axes (x across, y along):
/// the point where it crosses the plane of the lenses' poles (mm), and its slope, the displacement
/// per mm of depth away from the viewer.
struct LightFieldRay {
    std::array<float, 2> point{}, slope{};
};
LightFieldRay light_field_ray(const Lattice& lattice, const BeamRay& ray);

/// BeamSamples::furthest_depth of frames, mm.
constexpr float furthest_depth_of_frames = 1e5f;

/// Stored samples, up to most_stored per pixel. Different threads may store samples of different
/// pixels at the same time.
class BeamSamples {
public:
    static constexpr int most_stored = 16;

    /// One sample. WeightedSamples reads it as two times four floats.
    struct Sample {
        float depth = 0; ///< mm from the sheet away from the viewer; within +-furthest_depth()
        LightFieldRay line;
        std::array<std::int16_t, 2> tilt{}; ///< Seen::tilt, divided by tilt_unit()
        StoredLight light;
    };
    /// Surfaces that are further from the sheet count as being there, mm.
    float furthest_depth() const { return furthest_depth_; }

    /// The unit of Sample::tilt.
    float tilt_unit() const { return tilt_unit_; }

    struct Pixel {
        LightFieldRay centre; ///< the ray from the pixel's centre through the lens's pole or to the
                              ///< view's eye
        Sample first;
        const Sample* more = nullptr; ///< the samples after the first
        std::uint16_t number = 0;     ///< 0: the pixel is empty
    };
    /// Bytes per pixel of the memory's two arrays: pixels_, then lenders_.
    static constexpr std::size_t bytes_of_pixels = 64, bytes_of_lenders = 4;

    /// `memory`: room for both arrays, for all of the film's pixels; all 0, aligned to 8. Null: the
    /// object allocates its own.
    explicit BeamSamples(const IntegralCamera& camera, std::shared_ptr<void> memory = nullptr);
    /// The same for a picture of width x height pixels. `most_tilt`: the largest Seen::tilt that
    /// can be stored. `furthest_depth`: mm.
    BeamSamples(int width, int height, double most_tilt, float furthest_depth,
                std::shared_ptr<void> memory = nullptr);

    /// A sample before it is stored.
    struct Seen {
        LightFieldRay line;
        double depth = 0; ///< mm, may be infinite
        LinearColour light{};
        /// Tilt of the surface: the lateral part of its normal, divided by the normal's dot product
        /// with (slope, 1). Along a ray whose slope differs by d from this ray's, the surface's
        /// projected area is 1 + dot(tilt, d) times as large; if this factor is below 0, that ray
        /// meets the surface's other side.
        std::array<float, 2> tilt{};
    };
    /// Sets a pixel's centre, its lens and its first sample.
    void set_first(int x, int y, const LightFieldRay& centre, LensIndex lens, const Seen& seen);

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
            bool is_reusable;
        };
        std::vector<Begun> pixels_;
        std::vector<Sample> samples_;
    };
    /// Stores the gathered samples of a block whose first row is `top`, and empties `gathered`.
    void store(int top, Gathered& gathered);

    /// Frees the further samples of blocks whose first row is above `row`. No other thread may be
    /// using them.
    void forget_above(int row);

    const Pixel& pixel(std::size_t index) const { return pixels_[index]; }
    /// Pointer to the pixels from an index on; the index may be negative.
    const Pixel* pixels_from(std::ptrdiff_t index) const { return pixels_ + index; }
    const Pixel& pixel(int x, int y) const { return pixels_[index(x, y)]; }

    /// Whether a pixel's samples may be used: false if the pixel is empty, or if the light of a
    /// sample was too bright to be stored, or not a number.
    bool is_reusable(std::size_t index) const { return lenders_[index] != no_lens; }

    /// Returns those bits k of `which` (k < 8) for which the pixel at `index` + k is reusable and
    /// behind `lens`.
    unsigned lending(std::ptrdiff_t index, unsigned which, LightFieldImage::StoredLens lens) const
    {
        const std::uint32_t lender = lender_behind(lens);
        if (index >= 0 && index + 8 <= size_) {
            TwiceFourIntegers lenders;
            std::memcpy(&lenders, lenders_ + index, sizeof lenders);
            const FourIntegers requested = FourIntegers{} + std::int32_t(lender);
            return which &
                   bits(TwiceFourIntegers{lenders.low == requested, lenders.high == requested});
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

    /// A pixel's lens as one number. The highest bits are flipped, so that no_lens, the mark of
    /// pixels that are not reusable, can only be mistaken for a lens 32768 steps from the frame's
    /// middle.
    static std::uint32_t lender_behind(LightFieldImage::StoredLens lens)
    {
        return LightFieldImage::number_of(lens) ^ 0x80008000u;
    }
    static constexpr std::uint32_t no_lens = 0;

    int width_;
    std::ptrdiff_t size_; ///< number of the frame's pixels
    float tilt_unit_, furthest_depth_;
    std::shared_ptr<void> memory_;
    Pixel* pixels_;
    std::uint32_t* lenders_; ///< lender_behind of each pixel's lens, or no_lens
    std::mutex mutex_;
    std::multimap<int, std::unique_ptr<Sample[]>> further_; ///< key: the first row of the samples'
                                                            ///< block
};
static_assert(sizeof(BeamSamples::Pixel) == BeamSamples::bytes_of_pixels &&
              sizeof(std::uint32_t) == BeamSamples::bytes_of_lenders);

} // namespace integral

#endif
