// SPDX-License-Identifier: AGPL-3.0-or-later
// Reconstructs an anti-aliased frame: takes the noise out of each pixel with the help of other
// pixels whose beams meet the same places of the scene.
//
// A pixel sees the scene through a beam: at a depth z it covers a patch that is as wide as a lens
// at the sheet and grows by a pixel's span of slopes. Pixels behind the same lens and behind the
// neighbouring ones have beams that overlap there: the nearer their patches' centres, the more.
// Between pixels with overlapping beams a frame cannot change quickly, so their mean, weighted by
// the overlap, has less noise and hardly another value (axis-aligned and sheared filtering of light
// fields: Egan and others 2011, Mehta and others 2012).
//
// Three steps, each for all pixels before the next:
// 1. set: the mean of the pixel's samples and the variance of that mean, which is corrected later
//    by how far the halves of the samples differ in the pixels around;
// 2. estimate: the pixel's own mean, or one of two overlap-weighted means, narrow and wide: the one
//    with the least squared error by Stein's unbiased risk estimate (1981) over the pixels around;
// 3. reconstructed: an overlap-weighted mean that counts a pixel less the more its first estimate
//    differs, compared with the noise. It keeps outlines, reflections and highlights, which do not
//    move as the overlap says.
#ifndef INTEGRAL_LIGHTFIELD_RECONSTRUCTION_H
#define INTEGRAL_LIGHTFIELD_RECONSTRUCTION_H

#include "integral/lightfield/beam_overlaps.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace integral {

/// The greatest distance in rows of the pixels with which a pixel is compared in one step.
int rows_compared(const LensSheet& sheet, const Film& film);

/// The distance in rows of the refined pixels on which a reconstructed pixel depends.
int rows_reconstructed_from(const LensSheet& sheet, const Film& film);

/// The distance in rows of all samples on which an anti-aliased row of blocks depends. Refinement
/// works on whole blocks of `block_side` x `block_side` pixels.
int rows_antialiased_from(const LensSheet& sheet, const Film& film, int block_side);

/// Different threads may work on different pixels in the same step.
class Reconstruction {
public:
    /// Refers to `camera` and to `first`, whose lenses and depths it uses; both must outlive it.
    /// `least_error`: the standard error of a colour's component from which on a pixel is worked
    /// on. `memory`: bytes(camera.film) bytes, all 0, aligned to 4; null: the object allocates its
    /// own.
    Reconstruction(const IntegralCamera& camera, const FirstSamples& first, double least_error,
                   std::shared_ptr<void> memory = nullptr);

    /// Working memory of one thread.
    using Scratch = BeamOverlaps::Found;

    static constexpr int risk_reach = 2; ///< pixels around over which a risk is averaged

    /// Whether frames of a film can be reconstructed: not those of subpixels, whose channels have
    /// beams of their own.
    static bool possible(const Film& film);

    /// Bytes of memory for a film, stored row by row from the top.
    static constexpr std::size_t bytes_a_pixel = 20;
    static std::size_t bytes(const Film& film);

    /// The mean colour of the pixel's samples, and the squared error expected of it, summed over
    /// the colour's components: by the samples' variance (Refinement::squared_error), and as the
    /// halves of the samples show it (-1: not at all). Colours are clamped to 0 to 8; a pixel
    /// beyond that is left alone.
    void set(int x, int y, const ComparedColour& mean, double variance, double of_halves = -1);

    /// Makes the first estimates of the pixels from (left, top) to (right, bottom), inclusive.
    void estimate(int left, int top, int right, int bottom);

    /// The reconstructed colour; nothing if the pixel is to be left alone: it is empty, or its
    /// error is less than least_error.
    std::optional<ComparedColour> reconstructed(int x, int y, Scratch& scratch) const;

private:
    /// A float in 2 bytes: its upper half, with an error of less than 1 in 128. 0 in zeroed memory.
    class ShortFloat {
    public:
        void operator=(float x)
        {
            std::uint32_t bits;
            std::memcpy(&bits, &x, sizeof bits);
            upper_ = std::uint16_t(bits >> 16);
        }
        operator float() const
        {
            const std::uint32_t bits = std::uint32_t(upper_) << 16;
            float x;
            std::memcpy(&x, &bits, sizeof x);
            return x;
        }

    private:
        std::uint16_t upper_;
    };
    struct Pixel {
        StoredColour mean;
        /// The variance of the mean; below 0: to be left alone; 0 also for an empty pixel.
        ShortFloat variance;
        ShortFloat of_halves; ///< as the halves of the samples show it; below 0: not at all
        StoredColour estimate;
    };
    static_assert(sizeof(Pixel) == bytes_a_pixel);
    /// For one pixel: the two filtered colours and their risks, and the risk of its own mean.
    struct Trial {
        bool any = false;
        std::array<StoredColour, 2> colours{};
        std::array<float, 2> risks{};
        float own_risk = 0;
    };

    std::size_t index(int x, int y) const { return std::size_t(y) * width_ + x; }
    float smooth_variance(int x, int y) const;
    template <class Visit> void for_each_around(int x, int y, int reach, Visit visit) const;

    Trial trial(int x, int y, Scratch& scratch) const;

    const FirstSamples& first_;
    BeamOverlaps overlaps_;
    int width_, height_;
    float least_variance_;
    std::shared_ptr<void> memory_;
    Pixel* pixels_;
};

} // namespace integral

#endif
