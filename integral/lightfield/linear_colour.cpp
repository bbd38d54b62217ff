// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/linear_colour.h"

#include <algorithm>
#include <cstdlib>

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

bool StoredLight::is_clamped() const
{
    constexpr int root_of_64 = 8;
    return std::any_of(roots_.begin(), roots_.end(),
                       [](int root) { return std::abs(root) > root_of_64 * levels; });
}

} // namespace integral
