// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/sample_fit.h"

namespace integral {

LinearFit fitted_to(const LinearSums<float>& sums, const std::array<float, 2>& reach)
{
    const float one = 1 / sums.weight, x = one * sums.x, y = one * sums.y, value = one * sums.value,
                level = level_samples * square_of_place * sums.squared_weight * one * one,
                xx = one * sums.xx - x * x + level * reach[0] * reach[0],
                xy = one * sums.xy - x * y,
                yy = one * sums.yy - y * y + level * reach[1] * reach[1],
                x_value = one * sums.x_value - x * value, y_value = one * sums.y_value - y * value,
                of_determinant = 1 / (xx * yy - xy * xy);
    LinearFit result;
    result.by_x = of_determinant * (yy * x_value - xy * y_value);
    result.by_y = of_determinant * (xx * y_value - xy * x_value);
    result.at = value - x * result.by_x - y * result.by_y;
    return result;
}

/// Solves the normal equations about the mean place, one row for each of its four numbers. The
/// right side is the offset from the samples' mean place to the beam's, where all four are 0.
void PlaceRegression::solve(float weight, float squared_weight, const FourFloats& places,
                            Matrix& products)
{
    of_weight_ = 1 / weight;
    mean_place_ = of_weight_ * places;
    const float level = level_samples * squared_weight * of_weight_ * of_weight_;
    const FourFloats levels = level * FourFloats{square_of_place, square_of_place,
                                                 variance_of_square, variance_of_square};
    Matrix& rows = products;
    FourFloats right = -mean_place_;
    for (int k = 0; k < 4; ++k) {
        rows[k] = of_weight_ * products[k] - mean_place_[k] * mean_place_;
        rows[k][k] += levels[k];
    }
    for (int k = 0; k < 4; ++k)
        for (int below = k + 1; below < 4; ++below) {
            const float factor = rows[below][k] / rows[k][k];
            rows[below] -= factor * rows[k];
            right[below] -= factor * right[k];
        }
    for (int k = 3; k >= 0; --k) {
        for (int after = k + 1; after < 4; ++after)
            right[k] -= rows[k][after] * right[after];
        right[k] /= rows[k][k];
    }
    by_covariance_ = right;
}

FourFloats PlaceRegression::mean_over_beam(const ValueSums& sums) const
{
    const FourFloats mean = this->mean(sums);
    FourFloats result = mean;
    for (int k = 0; k < 4; ++k)
        result += by_covariance_[k] * (of_weight_ * sums.by_place[k] - mean_place_[k] * mean);
    return result;
}

} // namespace integral
