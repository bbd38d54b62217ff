// SPDX-License-Identifier: AGPL-3.0-or-later
// Estimates the mean light of a pixel's beam by regression: a function of the place (x, y and their
// squares) is fitted to the light of the samples, and averaged over the beam. The fraction of a
// beam that a layer of surfaces covers is estimated likewise. So it hardly matters that the samples
// lie unevenly: by chance, at a lens's border, and because more pixels have samples near the middle
// of a beam than at its rim.
#ifndef INTEGRAL_RECONSTRUCTION_SAMPLE_FIT_H
#define INTEGRAL_RECONSTRUCTION_SAMPLE_FIT_H

#include "integral/base/eight_floats.h"

namespace integral {

// Regressions are damped as if level_samples further samples showed no slope (ridge regression), so
// that a few samples do not cause a slope by chance. The mean square of a place in the footprint is
// about 0.2, the variance of its square 0.06.
constexpr float level_samples = 8, square_of_place = 0.2f, variance_of_square = 0.06f;

/// A linear function of a place (x, y).
struct LinearFit {
    float at = 0; ///< its value where x and y are 0
    float by_x = 0, by_y = 0;
};

/// Sums over samples, for fitting a LinearFit. Number: float, or a type of eight partial sums
/// (eight_floats.h).
template <class Number> struct LinearSums {
    Number weight{}, squared_weight{};
    Number x{}, y{}, xx{}, xy{}, yy{}; ///< weighted
    Number value{}, x_value{}, y_value{};

    /// `more`: the weight. `more_value`: the weight times the value.
    INTEGRAL_INLINE void add(Number more, Number more_value, Number at_x, Number at_y)
    {
        const Number more_x = more * at_x, more_y = more * at_y;
        weight = weight + more;
        squared_weight = squared_weight + more * more;
        x = x + more_x;
        y = y + more_y;
        xx = xx + more_x * at_x;
        xy = xy + more_x * at_y;
        yy = yy + more_y * at_y;
        value = value + more_value;
        x_value = x_value + more_value * at_x;
        y_value = y_value + more_value * at_y;
    }

    INTEGRAL_INLINE LinearSums<float> sums() const
    {
        const FourFloats a = sums_of_eight(weight, squared_weight, x, y),
                         b = sums_of_eight(xx, xy, yy, value),
                         c = sums_of_eight(x_value, y_value, Number{}, Number{});
        return {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3], c[0], c[1]};
    }
};

/// Fits a linear function to the sums. `reach`: half-widths of the ranges of x and y, for the
/// damping. The sum of weights must be above 0.
LinearFit fitted_to(const LinearSums<float>& sums, const std::array<float, 2>& reach);

/// Sums over samples' places, eight at a time. Floats: see eight_floats.h.
template <class Floats> struct PlaceSums {
    Floats weight{}, squared_weight{}, places[4]{};
    Floats products[4][4]{}; ///< [i][k] for k <= i

    /// `more`: the weights. `place`: x and y divided by half the footprint's width, and their
    /// squares minus the mean squares over the beam.
    INTEGRAL_INLINE void add(Floats more, const Floats (&place)[4])
    {
        weight = weight + more;
        squared_weight = squared_weight + more * more;
        for (int i = 0; i < 4; ++i) {
            const Floats weighted = more * place[i];
            places[i] = places[i] + weighted;
            for (int k = 0; k <= i; ++k)
                products[i][k] = products[i][k] + weighted * place[k];
        }
    }
};

/// Sums over two components of the samples' light.
template <class Floats> struct LightPairSums {
    Floats light[2]{}, by_place[4][2]{};

    INTEGRAL_INLINE void add(Floats weight, const Floats (&place)[4], const Floats (&more)[2])
    {
        for (int component = 0; component < 2; ++component) {
            const Floats weighted = weight * more[component];
            light[component] = light[component] + weighted;
            for (int i = 0; i < 4; ++i)
                by_place[i][component] = by_place[i][component] + weighted * place[i];
        }
    }
};

/// Weighted sums over samples of up to four values per sample, such as the components of light, and
/// of the products of these values with the samples' places.
struct ValueSums {
    FourFloats values{};
    std::array<FourFloats, 4> by_place{};

    ValueSums() = default;
    /// `light`: sums for red and green, and for blue and transparency.
    template <class Floats>
    INTEGRAL_INLINE explicit ValueSums(const LightPairSums<Floats> (&light)[2])
    {
        const auto &one = light[0].light, &other = light[1].light;
        values = sums_of_eight(one[0], one[1], other[0], other[1]);
        for (int k = 0; k < 4; ++k) {
            const auto &one_by = light[0].by_place[k], &other_by = light[1].by_place[k];
            by_place[k] = sums_of_eight(one_by[0], one_by[1], other_by[0], other_by[1]);
        }
    }
};

/// Regression of any value over samples at certain places. The sum of the samples' weights must be
/// above 0.
class PlaceRegression {
public:
    template <class Floats> INTEGRAL_INLINE explicit PlaceRegression(const PlaceSums<Floats>& sums)
    {
        const auto& all = sums.places;
        const FourFloats weights = sums_of_eight(sums.weight, sums.squared_weight, Floats{},
                                                 Floats{});
        Matrix products;
        for (int i = 0; i < 4; ++i) {
            const auto& by = sums.products[i];
            const FourFloats row = sums_of_eight(by[0], by[1], by[2], by[3]);
            for (int k = 0; k <= i; ++k)
                products[i][k] = products[k][i] = row[k];
        }
        solve(weights[0], weights[1], sums_of_eight(all[0], all[1], all[2], all[3]), products);
    }

    /// The mean over the beam of the function fitted to the values; this mean may lie outside the
    /// values' range. The sums may leave out samples whose values are 0.
    FourFloats mean_over_beam(const ValueSums& sums) const;
    /// The mean of the samples' values.
    FourFloats mean(const ValueSums& sums) const { return of_weight_ * sums.values; }

private:
    using Matrix = std::array<FourFloats, 4>;
    void solve(float weight, float squared_weight, const FourFloats& places, Matrix& products);

    float of_weight_ = 0; ///< 1 divided by the sum of weights
    FourFloats mean_place_{};
    /// For each of the four numbers of a place: by how much the mean over the beam exceeds the
    /// samples' mean, per unit of covariance between the value and that number.
    FourFloats by_covariance_{};
};

} // namespace integral

#endif
