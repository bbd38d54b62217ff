// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/reconstruction.h"

#include "integral/reconstruction/clipped_pixel.h"
#include "integral/reconstruction/sample_layers.h"
#include "integral/reconstruction/signal_and_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace integral {

namespace {

// Ratio of squared errors: of estimates from other pixels' samples to means of own samples. Tuned
// by comparing frames of POV-Ray's sample scenes with converged ones.
constexpr float left_by_others = 0.1f;

/// Weight of the pixel at offset (i, j): a tent over the pixels around. The variance of the
/// weighted mean of independent values follows from these weights.
constexpr float tent(int i, int j)
{
    constexpr int width = Reconstruction::reach_around + 1;
    return float((width - std::abs(i)) * (width - std::abs(j)));
}

/// Mixes the light of a pixel's layers with the mean of its own samples, whose weight is `part`,
/// and adds `added`. The result is at least half the darker of the two: where the pixels around are
/// much brighter, a negative `added` may exceed this pixel's light.
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

/// A pixel's Residual in two parts: `smooth`, the mean over the pixels around, and the rest, which
/// is the Residual minus `smooth`. For each part: its square and the variance expected from noise
/// (squares_of).
struct Reconstruction::Difference {
    FourFloats smooth{};
    FourFloats smooth_squares{}, rest_squares{};
    std::uint32_t lens = 0; ///< LightFieldImage::number_of
    bool any = false;
};

/// Known errors of a pixel's mean. `variance`: below 0 if not known. `of_one`: variance of one
/// sample. `halves`: the mean's variance, its split-half error, and 1; all 0 unless both are known.
struct Reconstruction::Noise {
    FourFloats halves{};
    float variance = -1, of_one = 0;
    float linear_of_one = 0, known_of_one = 0; ///< of_one in linear light, and of_one in the
                                               ///< encoding; both 0 if the former is not known
    std::uint32_t lens = 0;                    ///< LightFieldImage::number_of
};

/// Noise of a pixel's mean, estimated from the pixels around.
struct Reconstruction::MeanNoise {
    float variance = 0;
    float most = 0;            ///< the greatest variance around
    float in_linear_light = 0; ///< Pixel::in_linear_light
};

/// The mean of a pixel's own samples minus the light of its layers; 0 if it has no layers.
struct Reconstruction::Residual {
    FourFloats light{};
    float any = 0;          ///< 1: the pixel has layers
    std::uint32_t lens = 0; ///< LightFieldImage::number_of
};

/// Statistics of the differences of the pixels around a pixel.
struct Reconstruction::Neighbourhood {
    float smooth_part = 0;     ///< weight of the smooth difference (Wiener's filter)
    FourFloats rest_squares{}; ///< weighted by similarity of noise (likeness)
    float all_noise = 0;       ///< mean noise variance of the rests, in the encoding

    /// Mean square of the rests minus `margin` times their noise variance, at least 0: in the
    /// encoding (signal) and in linear light (linear_signal).
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

/// Mean of a pixel's own samples, and the parts of its rest (Difference): signal and noise.
struct Reconstruction::PixelEstimate {
    float signal = 0;  ///< expected square of the signal in the rest
    float noise = 0;   ///< variance of the rest that is due to noise of the mean
    float of_many = 0; ///< from 0, where few pixels of the block have a signal, to 1, where many do
    LinearColour light{};
    SamplesTaken samples{};

    /// Weight of the rest (Wiener's filter).
    float part() const
    {
        return signal > 0 ? signal / (signal + between(noise_in_rest, of_many) * noise) : 0;
    }

    /// Adds `tried` samples; `number` of them belonged to the pixel's lens, and `sum` is the sum of
    /// their light.
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
    ReuseNeighbourhood::Scratch lending;
    std::vector<float> depths;
    SampleLayers layers;
    BlockWindow<Noise> noise;
    BlockWindow<Residual> beside;
    BlockWindow<Difference> differences;
    BlockWindow<Neighbourhood> neighbourhood;
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

Reconstruction::Reconstruction(const IntegralCamera& camera, const LightFieldImage& first,
                               const BeamSamples& samples, double least_error,
                               std::shared_ptr<void> memory)
    : Reconstruction(camera.film.width, camera.film.height, first, samples, least_error,
                     camera.optics.lattice().arrangement() == Arrangement::lenticular,
                     std::move(memory))
{
    camera_ = &camera;
    lending_.emplace(camera.optics.lattice(), camera.film);
}

Reconstruction::Reconstruction(const QuiltGeometry& quilt, const LightFieldImage& first,
                               const BeamSamples& samples, double least_error,
                               std::shared_ptr<void> memory)
    : Reconstruction(quilt.width, quilt.height, first, samples, least_error, true,
                     std::move(memory))
{
    views_.emplace(quilt);
}

Reconstruction::Reconstruction(int width, int height, const LightFieldImage& first,
                               const BeamSamples& samples, double least_error, bool is_lenticular,
                               std::shared_ptr<void> memory)
    : first_(first),
      samples_(samples),
      width_(width),
      height_(height),
      least_variance_(float(3 * least_error * least_error)),
      linear_noise_in_smooth_(is_lenticular ? linear_noise_in_smooth_lines
                                            : linear_noise_in_smooth),
      memory_(memory ? std::move(memory)
                     : zeroed_memory(bytes_a_pixel * std::size_t(width) * std::size_t(height))),
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

/// Variance inflation of a block (VarianceInflation::ratio).
float Reconstruction::inflation_of(const PictureBlock& block) const
{
    VarianceInflation inflation;
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x)
            if (first_.lens(x, y))
                inflation.add(pixels_[index(x, y)].variance, pixels_[index(x, y)].of_halves);
    return inflation.ratio(prior_inflation);
}

/// Noise of a pixel's mean: the mean variance of one sample of the pixel and its eight neighbours,
/// divided by the pixel's number of samples, times the variance inflation over the pixels around.
/// The pixel's own variance is not enough: a pixel may have few samples because they happened to be
/// equal. `prior`: inflation_of() the block.
Reconstruction::MeanNoise Reconstruction::mean_noise(int x, int y, float prior,
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
                      VarianceInflation(halves[0], halves[1], halves[2]).ratio(prior);
    return result;
}

/// Begins the samples of pixel (x, y) of a quilt, and finds the pixels whose samples it may use.
void Reconstruction::find_in_quilt(int x, int y, Scratch& scratch) const
{
    const BeamSamples::Pixel& own = samples_.pixel(x, y);
    const auto tile = *first_.lens(x, y);
    std::vector<float>& depths = scratch.depths;
    depths.assign(1, float(first_.depth(x, y)));
    first_.for_each_neighbour(x, y,
                              [&](int i, int j) { depths.push_back(float(first_.depth(i, j))); });
    for (int k = 0; k + 1 < own.number; ++k)
        depths.push_back(own.more[k].depth);
    for (float& depth : depths)
        depth = std::clamp(depth, -samples_.furthest_depth(), samples_.furthest_depth());
    std::sort(depths.begin(), depths.end());
    scratch.layers.samples().begin(views_->footprint(), own.centre, samples_);
    views_->find(x, y, {tile[0], tile[1]}, depths, scratch.lending);
}

/// The same for a pixel of a frame.
void Reconstruction::find_in_frame(int x, int y, Scratch& scratch) const
{
    const BeamSamples::Pixel& own = samples_.pixel(x, y);
    const auto cut = first_.lens_around(x, y) ? std::nullopt : cut_pixel(*camera_, first_, x, y);
    const LightFieldRay& centre = cut ? cut->centre : own.centre;
    std::array<float, 2> depths = first_.depths_around(x, y);
    for (int k = 0; k + 1 < own.number; ++k)
        depths = {std::min(depths[0], own.more[k].depth), std::max(depths[1], own.more[k].depth)};
    for (float& depth : depths)
        depth = std::clamp(depth, -samples_.furthest_depth(), samples_.furthest_depth());
    const BeamFootprint patch(*camera_, centre, cut ? cut->size : Vec2{1, 1},
                              std::max(-depths[0], depths[1]));
    scratch.layers.samples().begin(patch, centre, samples_);
    lending_->find(x, y, *first_.lens(x, y), patch, depths[0], depths[1], scratch.lending);
}

/// Gathers in scratch.layers all samples that a pixel may use, its own and other pixels'.
void Reconstruction::gather(int x, int y, Scratch& scratch) const
{
    if (views_)
        find_in_quilt(x, y, scratch);
    else
        find_in_frame(x, y, scratch);
    WeightedSamples& weighed = scratch.layers.samples();
    const std::ptrdiff_t own_index = index(x, y);
    if (samples_.is_reusable(own_index))
        weighed.add_own(samples_.pixel(own_index));
    for (const ReuseNeighbourhood::Found& found : scratch.lending) {
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
    const float prior = inflation_of(block);
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
            const MeanNoise noise = mean_noise(x, y, prior, scratch.noise);
            pixel.in_linear_light = noise.in_linear_light;
            // One sample gives no estimate of its own error.
            const bool is_one = samples_.pixel(x, y).number == 1;
            if (std::max(noise.variance, is_one ? noise.most : 0) < least_variance_)
                continue;
            gather(x, y, scratch);
            const auto light = scratch.layers.light();
            if (!light)
                continue;
            pixel.layers = StoredLight(light->light);
            pixel.others = 1 - light->own_part;
            pixel.noise = is_one && !views_
                              ? std::max(noise.variance, scratch.layers.samples().variance())
                              : noise.variance;
        }
}

/// Computes a pixel's Difference from the residuals of this pixel and the pixels around.
Reconstruction::Difference Reconstruction::difference(int x, int y, const TabulatedCurve& encode,
                                                      const BlockWindow<Residual>& beside) const
{
    Difference result;
    const Residual& rest = beside.at(x, y);
    if (!(rest.any > 0))
        return result;
    result.any = true;
    result.lens = rest.lens;
    float weights = 0, squares = 0;
    beside.for_each_around<reach_around>(x, y, [&](int i, int j, const Residual& other) {
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

/// Takes extra samples of a pixel as long as further_samples() asks for more.
void Reconstruction::take_extra(int x, int y, const ExtraSamples& further, PixelEstimate& own) const
{
    while (const int number = further_samples(further.rule, own.samples, own.noise, own.part(),
                                              own.of_many)) {
        LinearColour sum{};
        const int taken = further.take(x, y, own.samples.tried, number, sum);
        own.add(number, taken, sum);
    }
}

/// Computes the differences of a block's pixels and of the pixels around.
void Reconstruction::find_differences(const PictureBlock& block, const TabulatedCurve& encode,
                                      Scratch& scratch) const
{
    fill_behind_lenses(scratch.beside, block, 2 * reach_around, first_,
                       [&](int x, int y, Residual& beside) {
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

/// Statistics of the differences around a pixel; the pixel itself must have a difference.
Reconstruction::Neighbourhood Reconstruction::neighbourhood(
    int x, int y, const BlockWindow<Difference>& differences) const
{
    const Difference& own = differences.at(x, y);
    Neighbourhood result;
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
    const float noise = (views_ ? noise_in_smooth_of_views : 1) * smooth[squares::noise];
    result.smooth_part = 0.5f * (part_above(noise, smooth[squares::square]) +
                                 part_above(linear_noise_in_smooth_ * smooth[squares::linear_noise],
                                            smooth[squares::linear_square]));
    result.rest_squares /= weight;
    result.all_noise /= number;
    return result;
}

/// Finds the neighbourhoods of a block's pixels that have differences. Returns how many of the
/// block's pixels show a signal in their rest, on a scale from 0 (few) to 1 (many).
float Reconstruction::find_surroundings(const PictureBlock& block, Scratch& scratch) const
{
    scratch.neighbourhood.begin(block, 0);
    float parts = 0;
    int number = 0;
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x)
            if (const Difference& difference = scratch.differences.at(x, y); difference.any) {
                Neighbourhood& around = scratch.neighbourhood.at(x, y);
                around = neighbourhood(x, y, scratch.differences);
                // The lesser of the weights in the encoding and in linear light counts: in the
                // encoding, the noise of few samples at an outline looks like a signal.
                const FourFloats& rest = difference.rest_squares;
                parts += std::min(
                    PixelEstimate{around.signal(margin_of_rest[0]), rest[squares::noise]}.part(),
                    PixelEstimate{around.linear_signal(margin_of_rest[0]),
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
                                 const ExtraSamples* further)
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
            const Neighbourhood& around = scratch.neighbourhood.at(x, y);
            PixelEstimate own{around.signal(between(margin_of_rest, of_many)),
                              difference.rest_squares[squares::noise],
                              of_many,
                              pixel.mean.light(),
                              {pixel.tried, pixel.taken}};
            if (further)
                take_extra(x, y, *further, own);
            const float part = own.part();
            pixels.back() = together(pixel.layers.light(), own.light, part,
                                     (around.smooth_part - part) * difference.smooth);
            pixel.error = part * part * own.noise + left_by_others * around.all_noise;
        }
}

} // namespace integral
