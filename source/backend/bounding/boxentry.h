// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes where a ray enters a bounding box, the most frequent test in tracing.
#ifndef POVRAY_BACKEND_BOXENTRY_H
#define POVRAY_BACKEND_BOXENTRY_H

#include <algorithm>
#include <cmath>

#include "backend/bounding/bbox.h"

namespace pov
{

/// Whether Ray_Enters_Box may be called: no component of the ray's direction is 0 and no length of
/// the box is negative.
inline bool Ray_Enters_Box_Applies(const BBOX& box, const Rayinfo& ray)
{
    return (ray.nonzero[X] & ray.nonzero[Y] & ray.nonzero[Z]) &&
           !(std::signbit(box.Lengths[X]) | std::signbit(box.Lengths[Y]) |
             std::signbit(box.Lengths[Z]));
}

/// Returns whether the ray meets the box, and sets `enters` to the distance along the ray, in lengths of its
/// direction. The results equal Check_And_Enqueue's axis-by-axis comparisons to the last bit, but one
/// unpredictable branch replaces up to ten.
inline bool Ray_Enters_Box(const BBOX& box, const Rayinfo& ray, DBL& enters)
{
    const auto low = [&](int k)
    { return DBL((box.Lower_Left[k] - ray.slab_num[k]) * ray.slab_den[k]); };
    const auto breadth = [&](int k) { return DBL(box.Lengths[k] * ray.slab_den[k]); };
    const DBL x = low(X), y = low(Y), z = low(Z);
    const DBL x1 = x + breadth(X), y1 = y + breadth(Y), z1 = z + breadth(Z);
    enters = std::max(std::max(std::min(x, x1), std::min(y, y1)), std::min(z, z1));
    const DBL leaves = std::min(std::min(std::max(x, x1), std::max(y, y1)), std::max(z, z1));
    return !((enters > leaves) | (leaves < EPSILON));
}

}

#endif
