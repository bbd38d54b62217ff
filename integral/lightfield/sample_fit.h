// SPDX-License-Identifier: AGPL-3.0-or-later
// The mean light of a pixel's beam, by a regression: a function of the place (x, y and their
// squares) is fitted to the light of the samples, and averaged over the beam. So it hardly matters
// that the samples lie unevenly: by chance, at a lens's border, and because more pixels have
// samples near the middle of a beam than at its rim.
#ifndef INTEGRAL_LIGHTFIELD_SAMPLE_FIT_H
#define INTEGRAL_LIGHTFIELD_SAMPLE_FIT_H

#include "integral/lightfield/four_floats.h"

namespace integral {

// Regressions are damped as if this many further samples showed no slope (ridge regression), so
// that few samples do not show one by chance. The mean square of a place in the patch is about 0.2,
// the variance of its square 0.06.
constexpr float level_samples = 8, square_of_place = 0.2f, variance_of_square = 0.06f;

class SampleFit {
public:
    /// `place`: x and y divided by half the patch's width, and their squares less the means of
    /// those over the beam.
    void add(float weight, FourFloats place, FourFloats light)
    {
        const FourFloats weighted = weight * place, weighted_light = weight * light;
        weight_ += weight;
        squares_ += weight * weight;
        places_ += weighted;
        light_ += weighted_light;
        for (int k = 0; k < 4; ++k) {
            products_[k] += place[k] * weighted;
            light_by_place_[k] += place[k] * weighted_light;
        }
    }

    /// The beam's mean light. The sum of weights must be above 0.
    FourFloats mean_of_beam() const;

private:
    float weight_ = 0, squares_ = 0;
    FourFloats places_{}, light_{};
    std::array<FourFloats, 4> products_{}, light_by_place_{};
};

} // namespace integral

#endif
