// SPDX-License-Identifier: AGPL-3.0-or-later
// Reconstructs an anti-aliased frame: computes each pixel's light from its own samples and from
// samples of other pixels whose beams meet the same places of the scene.
//
// A beam is as wide as a lens, so that many pixels behind the same lens and the lenses around it
// look at the same place of a surface. A matte surface has the same colour from all of them. So
// each pixel uses the samples of these pixels as if they were its own (light field reconstruction:
// Lehtinen and others 2011). A sample's weight is the density of the pixel's beam at the place that
// the sample met; it is reduced if the pixel sees the surface nearly edge-on.
//
// Surfaces at clearly different depths are layers (layered reconstruction: Vaidyanathan and others
// 2015). The fraction of the beam that a layer covers is estimated from all samples that reach the
// layer, whether they end there or go on; what lies behind is seen through the uncovered fraction.
//
// Mirrors, highlights and glass look different from different places. So the mean of a pixel's own
// samples is compared with the light of its layers. The difference is split into its mean over the
// pixels around and the remainder. Each part is added to the layers' light with a weight: the
// fraction of the part that is more than noise (Wiener filter). While the weight of the remainder
// is large, the pixel takes extra samples.
#ifndef INTEGRAL_RECONSTRUCTION_RECONSTRUCTION_H
#define INTEGRAL_RECONSTRUCTION_RECONSTRUCTION_H

#include "integral/base/tabulated_curve.h"
#include "integral/reconstruction/beam_footprint.h"
#include "integral/reconstruction/block_window.h"
#include "integral/reconstruction/pass_schedule.h"
#include "integral/reconstruction/refinement.h"
#include "integral/reconstruction/view_reuse.h"

#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <vector>

namespace integral {

/// Reconstructs a frame in steps: set, estimate, reconstruct. Different threads may work on
/// different pixels in the same step.
class Reconstruction {
public:
    /// Refers to `camera`, to `first` and to `samples`, which must outlive this object. Pixels
    /// whose standard error per colour component is below `least_error` are left unchanged.
    /// `memory`: bytes_a_pixel for each of the film's pixels, all 0, aligned to 2; null: the object
    /// allocates its own.
    Reconstruction(const IntegralCamera& camera, const LightFieldImage& first,
                   const BeamSamples& samples, double least_error,
                   std::shared_ptr<void> memory = nullptr);

    /// The same for a quilt, whose views use each other's samples.
    Reconstruction(const QuiltGeometry& quilt, const LightFieldImage& first,
                   const BeamSamples& samples, double least_error,
                   std::shared_ptr<void> memory = nullptr);

    /// Half-width, in pixels, of the window over which differences and errors are averaged.
    static constexpr int reach_around = 2;

    /// Whether a camera's frames can be reconstructed. Not with a film of subpixels (whose channels
    /// have separate beams; see IntegralStripes), several rays per pixel, a projection lens, a
    /// pseudoscopic camera, or beams other than a lens's cell times a pixel's area
    /// (display_prefilter, lens models full and hybrid).
    static bool possible(const IntegralCamera& camera);

    static constexpr std::size_t bytes_a_pixel = 34;

    /// Sets the mean light of a pixel's samples and two estimates of its squared error, in the
    /// encoding of comparison (ComparedColour), summed over the colour's components: `variance`,
    /// from the samples' variance (Refinement::squared_error), and `of_halves`, from the split
    /// halves (SplitHalfError; -1: not known). `in_linear_light`: the samples' variance in linear
    /// light divided by that in the encoding; 0: not known. Reconstruction leaves a pixel unchanged
    /// if StoredLight cannot hold its light.
    void set(int x, int y, const LinearColour& mean, double variance, double of_halves = -1,
             SamplesTaken samples = {}, double in_linear_light = 0);

    /// Working memory of one thread.
    struct Scratch;
    struct FreeScratch {
        void operator()(Scratch* scratch) const;
    };
    using ScratchPointer = std::unique_ptr<Scratch, FreeScratch>;
    static ScratchPointer make_scratch();

    /// Computes the layers of `pixels`. The samples and errors of these pixels and the pixels
    /// around them must have been set. `block`: the pixels from which the prior of the errors is
    /// estimated (VarianceInflation); they must all have been set.
    void estimate(const PictureBlock& pixels, const PictureBlock& block, Scratch& scratch);

    /// Takes extra samples of pixels for which other pixels' samples are not enough.
    struct ExtraSamples {
        RefinementRule rule;
        /// Tries `number` samples of pixel (x, y), from the index `begin` on. Adds the light of the
        /// samples that belong to the pixel's lens to `sum`, and returns their number.
        std::function<int(int x, int y, int begin, int number, LinearColour& sum)> take;
    };

    /// Light of a reconstructed pixel. Nothing for pixels that are left unchanged: empty pixels,
    /// pixels whose light cannot be stored, and pixels whose error is less than least_error.
    using Result = std::optional<LinearColour>;

    /// Computes the reconstructed light of a block's pixels, row by row. The pixels around must
    /// have been estimated. `encode`: converts linear light to the encoding of comparison.
    /// `further`: takes extra samples, which count for their own pixel only; null: none can be
    /// taken.
    void reconstruct(const PictureBlock& block, const TabulatedCurve& encode, Scratch& scratch,
                     std::vector<Result>& pixels, const ExtraSamples* further = nullptr);

    /// Approximate squared error that is left in a reconstructed pixel, up to a factor. It
    /// indicates where to look for errors.
    float error_left(int x, int y) const { return pixels_[index(x, y)].error; }

    /// The variance that independent samples would leave in the light of a reconstructed pixel, in
    /// the encoding of comparison, summed over the colour's components. 0: the pixel is left
    /// unchanged. This value is about three times the actual noise, because samples are stratified.
    float noise_left(int x, int y) const
    {
        const Pixel& pixel = pixels_[index(x, y)];
        return pixel.others > 0 ? (1 - pixel.others) * pixel.noise : 0;
    }

private:
    /// A float in 2 bytes: its upper half, with a relative error of less than 1 in 128. 0 in zeroed
    /// memory.
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
        /// Variance of the mean; below 0: the pixel is left unchanged. 0 also for an empty pixel.
        ShortFloat variance;
        ShortFloat of_halves; ///< variance from the split halves; below 0: not known
        StoredLight layers;
        ShortFloat others; ///< weight of other pixels' samples in the layers; 0: no layers
        ShortFloat noise;  ///< expected variance of the mean, from the pixels around; for a single
                           ///< sample, at least the variance in the beam
        ShortFloat of_samples_in_linear_light; ///< set()'s in_linear_light
        ShortFloat in_linear_light;            ///< its weighted mean over the pixels around
        std::uint16_t tried, taken;            ///< SamplesTaken
        ShortFloat error;                      ///< error_left, once the pixel is reconstructed
    };
    static_assert(sizeof(Pixel) == bytes_a_pixel);
    struct Noise;
    struct MeanNoise;
    struct Residual;
    struct Difference;
    struct Neighbourhood;
    struct PixelEstimate;

    std::size_t index(int x, int y) const { return std::size_t(y) * width_ + x; }
    float inflation_of(const PictureBlock& block) const;
    MeanNoise mean_noise(int x, int y, float prior, const BlockWindow<Noise>& noise) const;
    void gather(int x, int y, Scratch& scratch) const;
    Difference difference(int x, int y, const TabulatedCurve& encode,
                          const BlockWindow<Residual>& beside) const;
    void find_differences(const PictureBlock& block, const TabulatedCurve& encode,
                          Scratch& scratch) const;
    Neighbourhood neighbourhood(int x, int y, const BlockWindow<Difference>& differences) const;
    float find_surroundings(const PictureBlock& block, Scratch& scratch) const;
    void take_extra(int x, int y, const ExtraSamples& further, PixelEstimate& own) const;

    Reconstruction(int width, int height, const LightFieldImage& first, const BeamSamples& samples,
                   double least_error, bool is_lenticular, std::shared_ptr<void> memory);
    void find_in_quilt(int x, int y, Scratch& scratch) const;
    void find_in_frame(int x, int y, Scratch& scratch) const;

    const LightFieldImage& first_;
    const BeamSamples& samples_;
    /// camera_ and lending_ are set for a frame, views_ for a quilt.
    const IntegralCamera* camera_ = nullptr;
    std::optional<ReuseNeighbourhood> lending_;
    std::optional<ViewReuse> views_;
    int width_, height_;
    float least_variance_;
    float linear_noise_in_smooth_; ///< see signal_and_noise.h
    std::shared_ptr<void> memory_;
    Pixel* pixels_;
};

} // namespace integral

#endif
