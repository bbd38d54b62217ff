// SPDX-License-Identifier: AGPL-3.0-or-later
// Tells how much a pixel's mean errs: by how much its samples, and the halves of them, differ.
#ifndef INTEGRAL_LIGHTFIELD_SAMPLE_HALVES_H
#define INTEGRAL_LIGHTFIELD_SAMPLE_HALVES_H

#include "integral/lightfield/linear_colour.h"

namespace integral {

/// The samples of one pixel, in the order in which they are taken.
class SampleHalves {
public:
    /// Records the light of a sample that was tried.
    void add(const LinearColour& light);

    /// Records a sample that was tried but belongs to another lens than the pixel's.
    void add_none() { try_one(); }

    /// An estimate of the squared error of the samples' mean, summed over the colour's components
    /// in the encoding of comparison, with one degree of freedom a component: from the difference
    /// of the first half of the samples and the second, as if they were independent. -1 if a half
    /// is empty.
    ///
    /// Light is averaged before it is encoded, as in the pixel: where a few samples meet a
    /// highlight and the others something dark, their mean errs much more than the mean of encoded
    /// samples.
    double squared_error(const TabulatedCurve& encode) const;

    /// The sum over the samples, and over red, green and blue, of squared deviations from their
    /// mean.
    double squared_deviations() const;

private:
    void try_one();

    int tried_ = 0, taken_ = 0, half_taken_ = 0;
    LinearColour sum_{}, half_{}; ///< half: before the last doubling
    LinearColour squares_{};
};

} // namespace integral

#endif
