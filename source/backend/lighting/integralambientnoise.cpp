// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/lighting/integralambientnoise.h"

#include <algorithm>
#include <cmath>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

void IntegralAmbientNoise::Begin()
{
    weights = squared_weights = new_squared_weights = 0;
    sums = squares = {};
}

void IntegralAmbientNoise::Add(const RGBColour& light, double weight, bool pretraced, double)
{
    const double squared_weight = weight * weight;
    weights += weight;
    squared_weights += squared_weight;
    if (pretraced)
        return;
    new_squared_weights += squared_weight;
    for (int channel = 0; channel < 3; channel++)
    {
        sums[channel] += squared_weight * light[channel];
        squares[channel] += squared_weight * light[channel] * light[channel];
    }
}

void IntegralAmbientNoise::End(RGBColour& mean)
{
    // The mean is as noisy as a mean of `number` points of equal weights. The noise of a single
    // point cannot be estimated.
    const double number = weights * weights / squared_weights;
    constexpr double least_number = 1.001;
    if (!(number > least_number))
        return;
    for (int channel = 0; channel < 3; channel++)
    {
        const double centre = mean[channel],
                     scatter = squares[channel] - 2 * centre * sums[channel] +
                               centre * centre * new_squared_weights,
                     variance = scatter / (weights * weights) * number / (number - 1);
        if (variance > 0)
            mean[channel] = std::max(std::min(centre, 0.0),
                                     centre + direction * std::sqrt(variance));
    }
}

}
