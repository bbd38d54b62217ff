// SPDX-License-Identifier: AGPL-3.0-or-later
// The mean light of a pixel's beam, by a regression: a function of the place (x, y and their
// squares) is fitted to the light of the samples, and averaged over the beam. So it hardly matters
// that the samples lie unevenly: by chance, at a lens's border, and because more pixels have
// samples near the middle of a beam than at its rim.
#ifndef INTEGRAL_LIGHTFIELD_SAMPLE_FIT_H
#define INTEGRAL_LIGHTFIELD_SAMPLE_FIT_H

#include "integral/lightfield/eight_floats.h"

namespace integral {

// Regressions are damped as if this many further samples showed no slope (ridge regression), so
// that few samples do not show one by chance. The mean square of a place in the patch is about 0.2,
// the variance of its square 0.06.
constexpr float level_samples = 8, square_of_place = 0.2f, variance_of_square = 0.06f;

/// A linear function of a place (x, y).
struct LinearFit {
    float at = 0; ///< its value where x and y are 0
    float by_x = 0, by_y = 0;
};

/// What of some samples' places and values such a function is fitted to. All are means by weight.
struct LinearMoments {
    float x, y, value;
    float xx, xy, yy, x_value, y_value; ///< the products, less those of the means; xx and yy damped

    LinearFit fit() const;
};

/// The sums over samples of which a fit is made.
struct FitSums {
    float weight, squared_weight;
    FourFloats places, light; ///< by weight
    std::array<FourFloats, 4> products, light_by_place;

    /// The beam's mean light. The sum of weights must be above 0.
    FourFloats mean_of_beam() const;
};

/// Sums up samples, two at a time. Floats: see eight_floats.h; each half is about one sample.
template <class Floats> class SampleFit {
public:
    /// `weight`: four times the same. `place`: x and y divided by half the patch's width, and their
    /// squares less the means of those over the beam.
    INTEGRAL_INLINE void add(Floats weight, Floats place, Floats light)
    {
        const Floats weighted = weight * place, weighted_light = weight * light;
        weight_ = weight_ + weight;
        squares_ = squares_ + weight * weight;
        places_ = places_ + weighted;
        light_ = light_ + weighted_light;
        add_by<0>(place, weighted, weighted_light);
        add_by<1>(place, weighted, weighted_light);
        add_by<2>(place, weighted, weighted_light);
        add_by<3>(place, weighted, weighted_light);
    }

    INTEGRAL_INLINE FitSums sums() const
    {
        FitSums sums{
            of_both(weight_)[0], of_both(squares_)[0], of_both(places_), of_both(light_), {}, {}};
        for (int k = 0; k < 4; ++k) {
            sums.products[k] = of_both(products_[k]);
            sums.light_by_place[k] = of_both(light_by_place_[k]);
        }
        return sums;
    }

private:
    template <int k>
    INTEGRAL_INLINE void add_by(Floats place, Floats weighted, Floats weighted_light)
    {
        const Floats by = repeated<k>(place);
        products_[k] = products_[k] + by * weighted;
        light_by_place_[k] = light_by_place_[k] + by * weighted_light;
    }
    static INTEGRAL_INLINE FourFloats of_both(Floats x) { return low_half(x) + high_half(x); }

    Floats weight_{}, squares_{}, places_{}, light_{};
    Floats products_[4]{}, light_by_place_[4]{};
};

} // namespace integral

#endif
