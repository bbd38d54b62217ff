// SPDX-License-Identifier: AGPL-3.0-or-later
// Reconstructs an anti-aliased frame: works out each pixel's light from its own samples and from
// those of other pixels whose beams meet the same places of the scene.
//
// A beam is as wide as a lens, so that many pixels behind the same lens and behind the neighbouring
// ones look at the same place of a surface. A matte place looks alike from all of them. So a sample
// of any of these pixels counts as one of the pixel's own, weighted by the density of the pixel's
// beam at the place that the sample met (light field reconstruction: Lehtinen and others 2011), and
// by less where the pixel sees the surface nearly edge-on.
//
// Where surfaces lie at clearly different depths, they are layers (layered reconstruction:
// Vaidyanathan and others 2015). What part of the beam a layer covers is counted among all samples
// that reach it, whether they end there or pass it; what lies behind is seen through the rest.
//
// Mirrors, highlights and glass do not look alike from everywhere. So what the pixel's own samples
// say is compared with the layers, on two scales: the difference of a pixel, and its mean over the
// pixels around. Each is added to the layers' light as far as it is more than noise (Wiener's
// filter). Where it counts, further samples of the pixel are taken, as long as they are worth it.
#ifndef INTEGRAL_LIGHTFIELD_RECONSTRUCTION_H
#define INTEGRAL_LIGHTFIELD_RECONSTRUCTION_H

#include "integral/lightfield/beam_patch.h"
#include "integral/lightfield/block_window.h"
#include "integral/lightfield/pass_schedule.h"
#include "integral/lightfield/refinement.h"
#include "integral/lightfield/tabulated_curve.h"

#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <vector>

namespace integral {

/// Different threads may work on different pixels in the same step.
class Reconstruction {
public:
    /// Refers to `camera`, to `first` and to `samples`, which must outlive it. `least_error`: the
    /// standard error of a colour's component from which on a pixel is worked on. `memory`:
    /// bytes_a_pixel for each of the film's pixels, all 0, aligned to 2; null: the object allocates
    /// its own.
    Reconstruction(const IntegralCamera& camera, const FirstSamples& first,
                   const BeamSamples& samples, double least_error,
                   std::shared_ptr<void> memory = nullptr);

    /// Pixels around over which differences and errors are averaged.
    static constexpr int reach_around = 2;

    /// Whether frames of a camera can be reconstructed: not those of subpixels, whose channels have
    /// beams of their own, nor where the camera has several rays a pixel, a projection lens, or
    /// other beams than a lens's cell and a pixel's area.
    static bool possible(const IntegralCamera& camera);

    static constexpr std::size_t bytes_a_pixel = 34;

    /// The mean light of the pixel's samples, and the squared error expected of it in the encoding
    /// of comparison, summed over the colour's components: by the samples' variance
    /// (Refinement::squared_error), and as the halves of the samples show it (-1: not at all).
    /// `in_linear_light`: the variance of the samples' linear light, divided by that in the
    /// encoding; 0 if it is not known. A pixel that StoredLight does not hold is left alone.
    void set(int x, int y, const LinearColour& mean, double variance, double of_halves = -1,
             SamplesTaken samples = {}, double in_linear_light = 0);

    /// Working memory of one thread.
    struct Scratch;
    struct FreeScratch {
        void operator()(Scratch* scratch) const;
    };
    using ScratchPointer = std::unique_ptr<Scratch, FreeScratch>;
    static ScratchPointer make_scratch();

    /// Works out the layers of some pixels, for which all samples and errors around have been set.
    /// `block`: the pixels that show how large errors usually are; all of them have been set, too.
    void estimate(const PictureBlock& pixels, const PictureBlock& block, Scratch& scratch);

    /// How further samples are taken of pixels of which others' samples do not tell enough.
    struct Further {
        RefinementRule rule;
        /// Tries `number` samples of pixel (x, y), those from the index `begin` on. Adds the light
        /// of those that belong to the pixel's lens to `sum`, and returns their number.
        std::function<int(int x, int y, int begin, int number, LinearColour& sum)> take;
    };

    /// The light of a reconstructed pixel. Nothing for pixels that are to be left alone: empty
    /// ones, and those whose error is less than least_error.
    using Result = std::optional<LinearColour>;

    /// The reconstructed light of a block's pixels, row by row. Those around have been estimated.
    /// `encode`: linear light to the encoding of comparison. `further`: null if no further samples
    /// can be taken. They count for their own pixel only.
    void reconstruct(const PictureBlock& block, const TabulatedCurve& encode, Scratch& scratch,
                     std::vector<Result>& pixels, const Further* further = nullptr);

    /// About the squared error that is left in a reconstructed pixel, up to a factor: it tells
    /// where to look for errors.
    float error_left(int x, int y) const { return pixels_[index(x, y)].error; }

    /// The variance that independent samples would leave in the light of a reconstructed pixel, in
    /// the encoding of comparison, summed over the colour's components. 0: the pixel is to be left
    /// alone. As samples are spread evenly, it is some three times as much as there is.
    float noise_left(int x, int y) const
    {
        const Pixel& pixel = pixels_[index(x, y)];
        return pixel.others > 0 ? (1 - pixel.others) * pixel.noise : 0;
    }

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
        StoredLight mean;
        /// The variance of the mean; below 0: to be left alone; 0 also for an empty pixel.
        ShortFloat variance;
        ShortFloat of_halves; ///< as the halves of the samples show it; below 0: not at all
        StoredLight layers;
        ShortFloat others; ///< the part of other pixels' samples in the layers; 0: no layers
        ShortFloat noise;  ///< the variance that is expected of the mean, by the pixels around;
                           ///< if it is of one sample, by all samples in the beam, too
        ShortFloat of_samples_in_linear_light; ///< set()'s in_linear_light
        ShortFloat in_linear_light;            ///< the same of the pixels around, by their variance
        std::uint16_t tried, taken; ///< SamplesTaken
        ShortFloat error;           ///< error_left, once the pixel is reconstructed
    };
    static_assert(sizeof(Pixel) == bytes_a_pixel);
    struct Noise;
    struct MeanNoise;
    struct BesideLayers;
    struct Difference;
    struct Surroundings;
    struct Own;

    std::size_t index(int x, int y) const { return std::size_t(y) * width_ + x; }
    float excess_of(const PictureBlock& block) const;
    MeanNoise mean_noise(int x, int y, float usual, const BlockWindow<Noise>& noise) const;
    void gather(int x, int y, Scratch& scratch) const;
    Difference difference(int x, int y, const TabulatedCurve& encode,
                          const BlockWindow<BesideLayers>& beside) const;
    void find_differences(const PictureBlock& block, const TabulatedCurve& encode,
                          Scratch& scratch) const;
    Surroundings surroundings(int x, int y, const BlockWindow<Difference>& differences) const;
    float find_surroundings(const PictureBlock& block, Scratch& scratch) const;
    void take_further(int x, int y, const Further& further, Own& own) const;

    const IntegralCamera& camera_;
    const FirstSamples& first_;
    const BeamSamples& samples_;
    LendingPixels lending_;
    int width_, height_;
    float least_variance_;
    float linear_noise_in_smooth_; ///< see reconstruction.cpp
    std::shared_ptr<void> memory_;
    Pixel* pixels_;
};

} // namespace integral

#endif
