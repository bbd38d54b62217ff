// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/reconstruction.h"

#include "integral/lightfield/cut_pixel.h"
#include "integral/lightfield/sample_layers.h"
#include "integral/lightfield/signal_and_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace integral {

namespace {

// The squared error of what others' samples tell, divided by that of pixels' own means. Found by
// comparing frames of sample scenes of POV-Ray's with converged ones.
constexpr float left_by_others = 0.1f;

/// A tent over the pixels around, of which the variance of independent values' mean follows.
constexpr float tent(int i, int j)
{
    constexpr int width = Reconstruction::reach_around + 1;
    return float((width - std::abs(i)) * (width - std::abs(j)));
}

/// The light of a pixel's layers and its own mean, of which a part counts, with what is to be
/// added. At least half of the lesser of the two is left: where those around are much brighter,
/// what they differ by may be more than this pixel's light.
LinearColour together(const LinearColour& layers, const LinearColour& own, float part,
                      const FourFloats& added)
{
    LinearColour light;
    for (std::size_t k = 0; k < light.size(); ++k) {
        const float lesser = std::min(layers[k], own[k]);
        light[k] = std::max(layers[k] + part * (own[k] - layers[k]) + added[int(k)],
                            lesser - 0.5f * std::fabs(lesser));
    }
    light[3] = std::clamp(light[3], 0.0f, 1.0f);
    return light;
}

LinearColour colour_of(FourFloats light)
{
    LinearColour colour;
    std::memcpy(&colour, &light, sizeof colour);
    return colour;
}

} // namespace

/// By how much a pixel's own mean differs from its layers: smoothed over the pixels around, and the
/// squares of that and of the rest, with what noise lets expect (squares_of).
struct Reconstruction::Difference {
    FourFloats smooth{};
    FourFloats smooth_squares{}, rest_squares{};
    std::uint32_t lens = 0; ///< FirstSamples::number_of
    bool any = false;
};

/// What is known of the error of a pixel's mean. `variance`: below 0: nothing. `of_one`: that of
/// one sample. `halves`: if both are known, the variance, that of the samples' halves, and 1.
struct Reconstruction::Noise {
    FourFloats halves{};
    float variance = -1, of_one = 0;
    float linear_of_one = 0, known_of_one = 0; ///< in linear light, and the same in the encoding;
                                               ///< 0: not known
    std::uint32_t lens = 0; ///< FirstSamples::number_of
};

/// What the pixels around tell of the noise of a pixel's mean.
struct Reconstruction::MeanNoise {
    float variance = 0;
    float most = 0;            ///< the greatest variance around
    float in_linear_light = 0; ///< Pixel::in_linear_light
};

/// A pixel's own mean, less its layers; 0 where there are none.
struct Reconstruction::BesideLayers {
    FourFloats light{};
    float any = 0;          ///< 1: it has layers
    std::uint32_t lens = 0; ///< FirstSamples::number_of
};

/// What the differences of the pixels around tell of that of a pixel.
struct Reconstruction::Surroundings {
    float smooth_part = 0; ///< as how much the smooth difference counts (Wiener's filter)
    FourFloats rest_squares{}; ///< the means of those of pixels of similar noise
    float all_noise = 0;       ///< the mean variance of all rests, in the encoding

    /// The square of the rest less `margin` times that of its noise: in the encoding, and in
    /// linear light.
    float signal(float margin) const
    {
        return std::max(0.0f,
                        rest_squares[squares::square] - margin * rest_squares[squares::noise]);
    }
    float linear_signal(float margin) const
    {
        return std::max(0.0f,
                        rest_squares[squares::linear_square] -
                            margin * linear_noise_in_rest * rest_squares[squares::linear_noise]);
    }
};

/// The mean of a pixel's own samples, and how much of what it shows beside the layers and their
/// smooth difference is more than noise.
struct Reconstruction::Own {
    float signal = 0;  ///< the square that such differences have without noise
    float noise = 0;   ///< the variance of such a difference that comes of the mean's noise
    float of_many = 0; ///< from 0, where few pixels of the block have a signal, to 1, where many do
    LinearColour light{};
    SamplesTaken samples{};

    /// The part of it that counts (Wiener's filter).
    float part() const
    {
        return signal > 0 ? signal / (signal + between(noise_in_rest, of_many) * noise) : 0;
    }

    /// Adds the light of more samples, of which `number` belonged to the pixel's lens.
    void add(int tried, int number, const LinearColour& sum)
    {
        const float one = 1.0f / (samples.taken + number);
        for (std::size_t k = 0; k < light.size(); ++k)
            light[k] = one * (samples.taken * light[k] + sum[k]);
        noise *= float(squared_error_falls(samples.taken, number));
        samples.tried += tried;
        samples.taken += number;
    }
};

struct Reconstruction::Scratch {
    LendingPixels::Scratch lending;
    SampleLayers layers;
    BlockWindow<Noise> noise;
    BlockWindow<BesideLayers> beside;
    BlockWindow<Difference> differences;
    BlockWindow<Surroundings> surroundings;
};

void Reconstruction::FreeScratch::operator()(Scratch* scratch) const { delete scratch; }

Reconstruction::ScratchPointer Reconstruction::make_scratch()
{
    return ScratchPointer(new Scratch);
}

bool Reconstruction::possible(const IntegralCamera& camera)
{
    return camera.film.subpixels.order == Subpixels::none && !camera.display_prefilter &&
           !camera.pseudoscopic && !camera.projection && camera.pixel_samples == 1 &&
           camera.beam_samples == 1 && !refracts_at_surface(camera.optics.model());
}

Reconstruction::Reconstruction(const IntegralCamera& camera, const FirstSamples& first,
                               const BeamSamples& samples, double least_error,
                               std::shared_ptr<void> memory)
    : camera_(camera),
      first_(first),
      samples_(samples),
      lending_(camera.optics.lattice(), camera.film),
      width_(camera.film.width),
      height_(camera.film.height),
      least_variance_(float(3 * least_error * least_error)),
      linear_noise_in_smooth_(camera.optics.lattice().arrangement() == Arrangement::lenticular
                                  ? linear_noise_in_smooth_lines
                                  : linear_noise_in_smooth),
      memory_(memory ? std::move(memory)
                     : zeroed_memory(bytes_a_pixel * camera.film.width * camera.film.height)),
      pixels_(static_cast<Pixel*>(memory_.get()))
{
}

void Reconstruction::set(int x, int y, const LinearColour& mean, double variance, double of_halves,
                         SamplesTaken samples, double in_linear_light)
{
    Pixel& pixel = pixels_[index(x, y)];
    pixel.mean = StoredLight(mean);
    pixel.variance = StoredLight::holds(mean) && variance >= 0 ? float(variance) : -1;
    pixel.of_halves = of_halves >= 0 ? float(of_halves) : -1;
    pixel.of_samples_in_linear_light = float(in_linear_light);
    pixel.tried = std::uint16_t(std::min(samples.tried, SamplesTaken::most));
    pixel.taken = std::uint16_t(std::min(samples.taken, SamplesTaken::most));
}

/// The ratio of squared errors that is usual in a block.
float Reconstruction::excess_of(const PictureBlock& block) const
{
    Excess excess;
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x)
            if (first_.lens(x, y))
                excess.add(pixels_[index(x, y)].variance, pixels_[index(x, y)].of_halves);
    return excess.ratio(usual_excess);
}

/// The variance of the pixel's mean, by that of the samples of the pixel and those beside it, times
/// how much more the halves of the samples around differ than their variance lets expect. A pixel's
/// own samples are not enough: it may have few because they happened to be alike. `usual`:
/// excess_of() the block.
Reconstruction::MeanNoise Reconstruction::mean_noise(int x, int y, float usual,
                                                     const BlockWindow<Noise>& noise) const
{
    MeanNoise result;
    float sum_of_one = 0, linear = 0, known = 0;
    int number = 0;
    const std::uint32_t lens = noise.at(x, y).lens;
    noise.for_each_around<1>(x, y, [&](int, int, const Noise& other) {
        if (other.lens == lens && other.variance >= 0) {
            sum_of_one += other.of_one;
            linear += other.linear_of_one;
            known += other.known_of_one;
            ++number;
        }
    });
    FourFloats halves{};
    noise.for_each_around<reach_around>(x, y, [&](int, int, const Noise& other) {
        if (other.lens != lens)
            return;
        halves += other.halves;
        result.most = std::max(result.most, other.variance);
    });
    result.in_linear_light = known > 0 ? linear / known : 0;
    result.variance = sum_of_one / number / samples_.pixel(x, y).number *
                      Excess(halves[0], halves[1], halves[2]).ratio(usual);
    return result;
}

/// Sets the layers of a pixel from the samples of all pixels that it may use.
void Reconstruction::gather(int x, int y, Scratch& scratch) const
{
    const BeamSamples::Pixel& own = samples_.pixel(x, y);
    const auto cut = first_.lens_around(x, y) ? std::nullopt : cut_pixel(camera_, first_, x, y);
    const SightSlope& centre = cut ? cut->centre : own.centre;
    std::array<float, 2> depths = first_.depths_around(x, y);
    for (int k = 0; k + 1 < own.number; ++k)
        depths = {std::min(depths[0], own.more[k].depth), std::max(depths[1], own.more[k].depth)};
    for (float& depth : depths)
        depth = std::clamp(depth, -BeamSamples::furthest_depth, BeamSamples::furthest_depth);
    const BeamPatch patch(camera_, centre, cut ? cut->size : Vec2{1, 1},
                          std::max(-depths[0], depths[1]));
    WeighedSamples& weighed = scratch.layers.samples();
    const std::ptrdiff_t own_index = index(x, y);
    weighed.begin(patch, centre, samples_);
    if (samples_.lends(own_index))
        weighed.add_own(own);
    lending_.find(x, y, *first_.lens(x, y), patch, depths[0], depths[1], scratch.lending);
    for (const LendingPixels::Found& found : scratch.lending) {
        unsigned which = samples_.lending(found.index, found.which, found.lens);
        if (const std::ptrdiff_t own_place = own_index - found.index;
            own_place >= 0 && own_place < 8)
            which &= ~(1u << own_place);
        weighed.add(samples_.pixels_from(found.index), which, *found.parts);
    }
}

void Reconstruction::estimate(const PictureBlock& pixels, const PictureBlock& block,
                              Scratch& scratch)
{
    const float usual = excess_of(block);
    fill_behind_lenses(
        scratch.noise, pixels, reach_around, first_, [&](int x, int y, Noise& noise) {
            const Pixel& pixel = pixels_[index(x, y)];
            noise.variance = pixel.variance;
            noise.of_one = noise.variance * samples_.pixel(x, y).number;
            if (noise.variance >= 0 && pixel.of_samples_in_linear_light > 0) {
                noise.known_of_one = noise.of_one;
                noise.linear_of_one = noise.of_one * pixel.of_samples_in_linear_light;
            }
            if (noise.variance >= 0 && pixel.of_halves >= 0)
                noise.halves = FourFloats{noise.variance, float(pixel.of_halves), 1, 0};
        });
    for (int y = pixels.top; y <= pixels.bottom; ++y)
        for (int x = pixels.left; x <= pixels.right; ++x) {
            Pixel& pixel = pixels_[index(x, y)];
            pixel.others = 0;
            if (scratch.noise.at(x, y).variance < 0)
                continue;
            const MeanNoise noise = mean_noise(x, y, usual, scratch.noise);
            pixel.in_linear_light = noise.in_linear_light;
            // One sample tells nothing of its own error.
            const bool is_one = samples_.pixel(x, y).number == 1;
            if (std::max(noise.variance, is_one ? noise.most : 0) < least_variance_)
                continue;
            gather(x, y, scratch);
            const auto light = scratch.layers.light();
            if (!light)
                continue;
            pixel.layers = StoredLight(light->light);
            pixel.others = 1 - light->own_part;
            pixel.noise = is_one ? std::max(noise.variance, scratch.layers.samples().variance())
                                 : noise.variance;
        }
}

/// `beside`: of this pixel and those around.
Reconstruction::Difference Reconstruction::difference(int x, int y, const TabulatedCurve& encode,
                                                      const BlockWindow<BesideLayers>& beside) const
{
    Difference result;
    const BesideLayers& rest = beside.at(x, y);
    if (!(rest.any > 0))
        return result;
    result.any = true;
    result.lens = rest.lens;
    float weights = 0, squares = 0;
    beside.for_each_around<reach_around>(x, y, [&](int i, int j, const BesideLayers& other) {
        const float weight = other.lens == rest.lens ? tent(i, j) * other.any : 0;
        result.smooth += weight * other.light;
        weights += weight;
        squares += weight * weight;
    });
    result.smooth /= weights;
    const Pixel& own = pixels_[index(x, y)];
    const FourFloats layers = own.layers.four();
    const LinearColour smooth = colour_of(layers + result.smooth);
    const float all = own.others * own.noise, part = squares / (weights * weights);
    result.smooth_squares = squares_of(squared_difference(encode, smooth, colour_of(layers)),
                                       result.smooth, part * all, own.in_linear_light);
    result.rest_squares = squares_of(
        squared_difference(encode, own.mean.light(), smooth), rest.light - result.smooth,
        (1 + part - 2 * tent(0, 0) / weights) * all, own.in_linear_light);
    return result;
}

/// Takes further samples of a pixel as long as one more is worth it.
void Reconstruction::take_further(int x, int y, const Further& further, Own& own) const
{
    while (const int number = further_samples(further.rule, own.samples, own.noise, own.part(),
                                              own.of_many)) {
        LinearColour sum{};
        const int taken = further.take(x, y, own.samples.tried, number, sum);
        own.add(number, taken, sum);
    }
}

/// Works out the differences of a block's pixels and of those around.
void Reconstruction::find_differences(const PictureBlock& block, const TabulatedCurve& encode,
                                      Scratch& scratch) const
{
    fill_behind_lenses(scratch.beside, block, 2 * reach_around, first_,
                       [&](int x, int y, BesideLayers& beside) {
                           const Pixel& pixel = pixels_[index(x, y)];
                           beside.any = pixel.others > 0;
                           if (pixel.others > 0)
                               beside.light = pixel.mean.four() - pixel.layers.four();
                       });
    fill_behind_lenses(scratch.differences, block, reach_around, first_,
                       [&](int x, int y, Difference& result) {
                           result = difference(x, y, encode, scratch.beside);
                       });
}

/// What the differences around a pixel tell, if it has one itself.
Reconstruction::Surroundings Reconstruction::surroundings(
    int x, int y, const BlockWindow<Difference>& differences) const
{
    const Difference& own = differences.at(x, y);
    Surroundings result;
    FourFloats smooth{};
    float weight = 0;
    int number = 0;
    differences.for_each_around<reach_around>(x, y, [&](int, int, const Difference& other) {
        if (!other.any || other.lens != own.lens)
            return;
        smooth += other.smooth_squares;
        const float like = likeness(own.rest_squares[squares::noise],
                                    other.rest_squares[squares::noise]);
        result.rest_squares += like * other.rest_squares;
        weight += like;
        result.all_noise += other.rest_squares[squares::noise];
        ++number;
    });
    result.smooth_part = 0.5f * (part_above(smooth[squares::noise], smooth[squares::square]) +
                                 part_above(linear_noise_in_smooth_ * smooth[squares::linear_noise],
                                            smooth[squares::linear_square]));
    result.rest_squares /= weight;
    result.all_noise /= number;
    return result;
}

/// Finds the surroundings of a block's pixels that have differences. Returns how many of the
/// block's pixels show a signal of their own: from 0, few, to 1, many.
float Reconstruction::find_surroundings(const PictureBlock& block, Scratch& scratch) const
{
    scratch.surroundings.begin(block, 0);
    float parts = 0;
    int number = 0;
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x)
            if (const Difference& difference = scratch.differences.at(x, y); difference.any) {
                Surroundings& around = scratch.surroundings.at(x, y);
                around = surroundings(x, y, scratch.differences);
                // Both must say so: few samples at an outline look like a signal in the encoding.
                const FourFloats& rest = difference.rest_squares;
                parts += std::min(
                    Own{around.signal(margin_of_rest[0]), rest[squares::noise]}.part(),
                    Own{around.linear_signal(margin_of_rest[0]),
                        linear_noise_in_rest * rest[squares::linear_noise]}
                        .part());
                ++number;
            }
    return std::clamp((parts / float(std::max(1, number)) - part_of_few) /
                          (part_of_many - part_of_few),
                      0.0f, 1.0f);
}

void Reconstruction::reconstruct(const PictureBlock& block, const TabulatedCurve& encode,
                                 Scratch& scratch, std::vector<Result>& pixels,
                                 const Further* further)
{
    find_differences(block, encode, scratch);
    const float of_many = find_surroundings(block, scratch);
    pixels.clear();
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x) {
            Pixel& pixel = pixels_[index(x, y)];
            pixel.error = std::max<float>(0, pixel.variance);
            pixels.emplace_back();
            const Difference& difference = scratch.differences.at(x, y);
            if (!difference.any)
                continue;
            const Surroundings& around = scratch.surroundings.at(x, y);
            Own own{around.signal(between(margin_of_rest, of_many)),
                    difference.rest_squares[squares::noise],
                    of_many,
                    pixel.mean.light(),
                    {pixel.tried, pixel.taken}};
            if (further)
                take_further(x, y, *further, own);
            const float part = own.part();
            pixels.back() = together(pixel.layers.light(), own.light, part,
                                     (around.smooth_part - part) * difference.smooth);
            pixel.error = part * part * own.noise + left_by_others * around.all_noise;
        }
}

} // namespace integral
