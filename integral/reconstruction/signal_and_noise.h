// SPDX-License-Identifier: AGPL-3.0-or-later
// Separates signal from noise in the differences between the means of pixels' own samples and their
// layers' light (reconstruction.h): estimates the noise of the means, and what fraction of a
// difference is more than noise (Wiener's filter).
#ifndef INTEGRAL_RECONSTRUCTION_SIGNAL_AND_NOISE_H
#define INTEGRAL_RECONSTRUCTION_SIGNAL_AND_NOISE_H

#include "integral/base/four_floats.h"

#include <algorithm>

namespace integral {

// The ratio of the split-half error to the error predicted by the samples' variance is averaged
// over the pixels around and prior_weight additional pixels with the block's ratio. The block's
// ratio is averaged over the block's pixels and prior_weight additional pixels with the ratio
// prior_inflation. Tuned on POV-Ray's sample scenes.
constexpr float prior_weight = 8, prior_inflation = 1.5f;

/// Ratio of the split-half error to the error predicted by the sample variance.
class VarianceInflation {
public:
    VarianceInflation() = default;
    /// `expected`, `seen`: sums of the predicted and of the split-half errors over `number` pixels.
    VarianceInflation(float expected, float seen, float number)
        : expected_(expected), seen_(seen), number_(number)
    {
    }
    /// Adds a pixel, unless one of its errors is below 0 (not known).
    void add(float variance, float of_halves)
    {
        if (!(variance >= 0 && of_halves >= 0))
            return;
        expected_ += variance;
        seen_ += of_halves;
        ++number_;
    }
    /// The ratio of squared errors, drawn towards `prior` if few pixels have been added.
    float ratio(float prior) const
    {
        if (!(expected_ > 0))
            return prior;
        const float weight = prior_weight * expected_ / number_;
        return (seen_ + prior * weight) / (expected_ + weight);
    }

private:
    float expected_ = 0, seen_ = 0, number_ = 0;
};

// A pixel's rest is its difference minus the mean of the differences around: partly signal, partly
// noise. The signal's square is estimated as the mean square of the rests around, minus
// margin_of_rest times their noise variance. The weight of a rest follows from this estimate and
// from noise_in_rest times the pixel's own noise variance. The first numbers apply where few of a
// block's pixels show a signal. They are above 1 because single pixels often have more noise than
// expected where samples rarely meet something bright. The second numbers apply where many pixels
// show a signal, as in a room of mirrors: there a large rest is more likely a signal than such
// noise. The numbers change from the first to the second as the block's mean weight of rests grows
// from part_of_few to part_of_many. (That weight is computed with the first numbers, and is the
// lesser of the weights in the encoding and in linear light.) Tuned on POV-Ray's sample scenes.
constexpr float margin_of_rest[] = {2, 1}, noise_in_rest[] = {1.5f, 1};
constexpr float part_of_few = 0.15f, part_of_many = 0.3f;

// In linear light, the ratio of the noise variance of differences to the prediction from the
// samples: for a pixel's rest, in the decision whether many pixels show a signal; and for a smooth
// difference, behind a lenticular sheet (lines) and behind other sheets. (A pixel behind a
// lenticular sheet integrates light over three dimensions, not four, so that its samples are more
// evenly distributed.) Tuned on POV-Ray's sample scenes.
constexpr float linear_noise_in_rest = 0.5f, linear_noise_in_smooth_lines = 0.6f,
                linear_noise_in_smooth = 1.7f;

// The same ratio in the encoding of comparison for a smooth difference in a quilt, whose pixels
// have few samples. Tuned on POV-Ray's sample scenes.
constexpr float noise_in_smooth_of_views = 3;

/// Linear interpolation between two numbers: the first at part = 0, the second at part = 1.
constexpr float between(const float (&numbers)[2], float part)
{
    return numbers[0] + part * (numbers[1] - numbers[0]);
}

/// Indices of a difference's four numbers: its square and its noise variance in the encoding of
/// comparison, and both in linear light. Samples are averaged before they are encoded. So on the
/// dark side of an outline the means of a few samples differ much more in the encoding than the
/// variance of encoded samples predicts. In linear light the prediction holds, but there dark
/// places hardly count.
namespace squares {
enum { square, noise, linear_square, linear_noise };
}

/// Returns a difference's four numbers. `in_encoding`, `variance`: the square and the noise
/// variance in the encoding. `difference`: in linear light. `in_linear_light`: the variance in
/// linear light divided by that in the encoding; 0: not known, the ratio of the squares is used.
inline FourFloats squares_of(float in_encoding, FourFloats difference, float variance,
                             float in_linear_light)
{
    const float linear = sum_of(difference * difference);
    if (!(in_linear_light > 0))
        in_linear_light = in_encoding > 0 ? linear / in_encoding : 0;
    return FourFloats{in_encoding, variance, linear, in_linear_light * variance};
}

/// The fraction of a square that is not noise (Wiener's filter).
inline float part_above(float noise, float square)
{
    return square > noise ? 1 - noise / square : 0;
}

/// Similarity of two pixels' noise, from 0 to 1: the weight of one pixel's difference in the
/// other's statistics. Pixels at outlines, with many samples, are not comparable to pixels with
/// few.
inline float likeness(float noise, float other)
{
    constexpr float little = 1e-9f; // invisible noise
    return (std::min(noise, other) + little) / (std::max(noise, other) + little);
}

} // namespace integral

#endif
