// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/sample_fit.h"

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

FourFloats FitSums::mean_of_beam() const
{
    const float one = 1 / weight, level = level_samples * squared_weight * one * one;
    const FourFloats mean = one * light, mean_place = one * places,
                     levels = level * FourFloats{square_of_place, square_of_place,
                                                 variance_of_square, variance_of_square};
    // The normal equations about the mean place, one row for each of its numbers.
    std::array<FourFloats, 4> rows, right, slopes;
    for (int k = 0; k < 4; ++k) {
        rows[k] = one * products[k] - mean_place[k] * mean_place;
        rows[k][k] += levels[k];
        right[k] = one * light_by_place[k] - mean_place[k] * mean;
    }
    for (int k = 0; k < 4; ++k)
        for (int below = k + 1; below < 4; ++below) {
            const float factor = rows[below][k] / rows[k][k];
            rows[below] -= factor * rows[k];
            right[below] -= factor * right[k];
        }
    FourFloats result = mean;
    for (int k = 3; k >= 0; --k) {
        slopes[k] = right[k];
        for (int after = k + 1; after < 4; ++after)
            slopes[k] -= rows[k][after] * slopes[after];
        slopes[k] /= rows[k][k];
        result -= mean_place[k] * slopes[k];
    }
    return most(result, FourFloats{});
}

} // namespace integral
