// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/linear_colour.h"

#include <algorithm>
#include <cmath>

namespace integral {

float squared_difference(const TabulatedCurve& encode, const LinearColour& a, const LinearColour& b)
{
    float sum = 0;
    for (int k = 0; k < 3; ++k) {
        const float difference = encode(a[k]) - encode(b[k]);
        sum += difference * difference;
    }
    return sum + (a[3] - b[3]) * (a[3] - b[3]);
}

bool StoredLight::holds(const LinearColour& light)
{
    return std::all_of(light.begin(), light.end(),
                       [](float component) { return std::fabs(component) <= 64; });
}

} // namespace integral
