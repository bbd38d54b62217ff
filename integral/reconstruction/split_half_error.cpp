// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/split_half_error.h"

#include <algorithm>

namespace integral {

void SplitHalfError::try_one()
{
    if ((tried_ & (tried_ - 1)) == 0) { // the first 2^k samples are evenly distributed
        half_ = sum_;
        half_taken_ = taken_;
    }
    ++tried_;
}

void SplitHalfError::add(const LinearColour& light)
{
    try_one();
    ++taken_;
    for (std::size_t k = 0; k < light.size(); ++k) {
        sum_[k] += light[k];
        squares_[k] += light[k] * light[k];
    }
}

double SplitHalfError::squared_deviations() const
{
    double sum = 0;
    for (int k = 0; taken_ > 0 && k < 3; ++k)
        sum += std::max(0.0, double(squares_[k]) - double(sum_[k]) * sum_[k] / taken_);
    return sum;
}

double SplitHalfError::squared_error(const TabulatedCurve& encode) const
{
    const int rest = taken_ - half_taken_;
    if (half_taken_ == 0 || rest == 0)
        return -1;
    LinearColour first, second;
    for (std::size_t k = 0; k < sum_.size(); ++k) {
        first[k] = half_[k] / half_taken_;
        second[k] = (sum_[k] - half_[k]) / rest;
    }
    return double(squared_difference(encode, first, second)) * half_taken_ * rest /
           (double(taken_) * taken_);
}

} // namespace integral
