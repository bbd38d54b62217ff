// SPDX-License-Identifier: AGPL-3.0-or-later
// Estimates the error of a pixel's mean from the difference between two halves of the pixel's
// samples.
#ifndef INTEGRAL_RECONSTRUCTION_SPLIT_HALF_ERROR_H
#define INTEGRAL_RECONSTRUCTION_SPLIT_HALF_ERROR_H

#include "integral/frame/linear_colour.h"

namespace integral {

/// The samples of one pixel, in the order in which they are taken.
class SplitHalfError {
public:
    /// Records the light of a sample that was tried.
    void add(const LinearColour& light);

    /// Records a sample that was tried but belongs to another lens than the pixel's.
    void add_none() { try_one(); }

    /// An estimate of the squared error of the samples' mean, summed over the colour's components
    /// in the encoding of comparison. It comes from the difference between the first and the second
    /// half of the samples, as if the halves were independent, and has one degree of freedom per
    /// component. -1 if a half is empty.
    ///
    /// Light is averaged before it is encoded, as in the pixel: where a few samples meet a
    /// highlight and the others something dark, the encoded mean has a much larger error than the
    /// mean of encoded samples.
    double squared_error(const TabulatedCurve& encode) const;

    /// The sum over the samples, and over red, green and blue, of squared deviations from their
    /// mean.
    double squared_deviations() const;

private:
    void try_one();

    int tried_ = 0, taken_ = 0, half_taken_ = 0;
    LinearColour sum_{}, half_{}; ///< half_: sum_ before the number of samples last doubled
    LinearColour squares_{};
};

} // namespace integral

#endif
