// SPDX-License-Identifier: AGPL-3.0-or-later
// Tells signal from noise in what pixels' own samples show beside the light that others' samples
// give (reconstruction.h): how noisy pixels' means are, and what part of a difference is more than
// noise (Wiener's filter).
#ifndef INTEGRAL_LIGHTFIELD_SIGNAL_AND_NOISE_H
#define INTEGRAL_LIGHTFIELD_SIGNAL_AND_NOISE_H

#include "integral/lightfield/four_floats.h"

#include <algorithm>

namespace integral {

// The squared error that the halves of a pixel's samples show, divided by the one that the variance
// of the samples lets expect, is averaged over the pixels around, where the ratio of the whole
// block counts as this many pixels; and that over the block, where the usual one counts as as many.
// Found by trying on sample scenes of POV-Ray's.
constexpr float enough_halves = 8, usual_excess = 1.5f;

/// By how much more the halves of pixels' samples differ than the variance of the samples lets
/// expect.
class Excess {
public:
    Excess() = default;
    /// The sums over some pixels, and their number.
    Excess(float expected, float seen, float number)
        : expected_(expected), seen_(seen), number_(number)
    {
    }
    /// Either is below 0 where it is not known.
    void add(float variance, float of_halves)
    {
        if (!(variance >= 0 && of_halves >= 0))
            return;
        expected_ += variance;
        seen_ += of_halves;
        ++number_;
    }
    /// The ratio of squared errors; `usual` as far as few halves are known.
    float ratio(float usual) const
    {
        if (!(expected_ > 0))
            return usual;
        const float weight = enough_halves * expected_ / number_;
        return (seen_ + usual * weight) / (expected_ + weight);
    }

private:
    float expected_ = 0, seen_ = 0, number_ = 0;
};

// What is left of a pixel's difference beside the mean of those around is partly signal, partly
// noise. The signal's square is taken to be what the squares around have above margin_of_rest times
// the noise, and noise_in_rest times the pixel's own noise is set against it. Both are above 1
// where few of a block's pixels show a signal (the first number): where samples rarely meet
// something bright, single pixels' noise is often more than is expected. Where many do (the second
// number), as in a room of mirrors, what a pixel shows is more likely a signal than such noise. How
// many do is told by the mean part of pixels' rests that counts by the first numbers, both in the
// encoding and in linear light: from part_of_few to part_of_many of it the second ones take over.
// Found by trying on sample scenes of POV-Ray's.
constexpr float margin_of_rest[] = {2, 1}, noise_in_rest[] = {1.5f, 1};
constexpr float part_of_few = 0.15f, part_of_many = 0.3f;

// The variance that noise gives to differences in linear light, divided by what samples let expect
// there: that of a pixel's rest, when it is decided whether many pixels show a signal; and that of
// a smooth difference, behind a lenticular sheet and behind others. (A pixel behind a lenticular
// sheet has its light from three dimensions, not four, so that samples lie more evenly.) Found by
// trying on sample scenes of POV-Ray's.
constexpr float linear_noise_in_rest = 0.5f, linear_noise_in_smooth_lines = 0.6f,
                linear_noise_in_smooth = 1.7f;

/// The number between two that belongs to a part from 0 to 1 of the way from the first.
constexpr float between(const float (&numbers)[2], float part)
{
    return numbers[0] + part * (numbers[1] - numbers[0]);
}

/// What is known of a difference, as four numbers: its square and the variance that noise gives to
/// it, in the encoding of comparison, and both in linear light. Samples are averaged before they
/// are encoded. So on the dark side of an outline the means of a few samples differ much more in
/// the encoding than the variance of encoded samples lets expect; in linear light they do not, but
/// what is dark hardly counts there.
namespace squares {
enum { square, noise, linear_square, linear_noise };
}

/// `in_encoding`, `variance`: the square and the noise there. `difference`: in linear light.
/// `in_linear_light`: the variance there divided by that in the encoding; 0: it is not known, so
/// that of the squares is taken.
inline FourFloats squares_of(float in_encoding, FourFloats difference, float variance,
                             float in_linear_light)
{
    const float linear = sum_of(difference * difference);
    if (!(in_linear_light > 0))
        in_linear_light = in_encoding > 0 ? linear / in_encoding : 0;
    return FourFloats{in_encoding, variance, linear, in_linear_light * variance};
}

/// The part of a square that is not noise (Wiener's filter).
inline float part_above(float noise, float square)
{
    return square > noise ? 1 - noise / square : 0;
}

/// How much the difference of a pixel tells of that of a pixel with another noise, from 0 to 1:
/// pixels of many samples, at outlines, are not like those of few.
inline float likeness(float noise, float other)
{
    constexpr float little = 1e-9f; // as little noise as nobody sees
    return (std::min(noise, other) + little) / (std::max(noise, other) + little);
}

} // namespace integral

#endif
