// SPDX-License-Identifier: AGPL-3.0-or-later
// Where a ray enters a bounding box: the question that a scene's rays ask most often.
#ifndef POVRAY_BACKEND_BOXENTRY_H
#define POVRAY_BACKEND_BOXENTRY_H

#include <algorithm>
#include <cmath>

#include "backend/bounding/bbox.h"

namespace pov
{

/// Whether Ray_Enters_Box applies: the ray's direction has no component of 0, and the box no
/// negative length.
inline bool Ray_Enters_Box_Applies(const BBOX& box, const Rayinfo& ray)
{
    return (ray.nonzero[X] & ray.nonzero[Y] & ray.nonzero[Z]) &&
           !(std::signbit(box.Lengths[X]) | std::signbit(box.Lengths[Y]) |
             std::signbit(box.Lengths[Z]));
}

/// Whether the ray meets the box, and how far along it (`enters`, in lengths of its direction). The
/// same numbers, to the last bit, as Check_And_Enqueue's comparisons axis by axis, with one
/// unpredictable branch in place of up to ten: a processor guesses those wrongly half of the time.
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
