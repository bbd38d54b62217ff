// SPDX-License-Identifier: AGPL-3.0-or-later
// Where a ray enters a bounding box: what a scene's rays ask most often.
#ifndef POVRAY_BACKEND_INTEGRALBOX_H
#define POVRAY_BACKEND_INTEGRALBOX_H

#include <algorithm>
#include <cmath>

#include "backend/bounding/bbox.h"

namespace pov
{

/// Whether the ray's direction has three components, and the box is not turned inside out.
inline bool Integral_May_Enter(const BBOX& box, const Rayinfo& ray)
{
    return (ray.nonzero[X] & ray.nonzero[Y] & ray.nonzero[Z])
        && !(std::signbit(box.Lengths[X]) | std::signbit(box.Lengths[Y]) | std::signbit(box.Lengths[Z]));
}

/// Whether such a ray meets such a box, and how far along it (`enters`, in lengths of its direction). As Check_And_Enqueue finds it, to the
/// last bit, but with a single branch that cannot be foreseen, in place of up to ten: a processor guesses those wrongly half of the time.
inline bool Integral_Enters(const BBOX& box, const Rayinfo& ray, DBL& enters)
{
    const auto low = [&](int k) { return DBL((box.Lower_Left[k] - ray.slab_num[k]) * ray.slab_den[k]); };
    const auto breadth = [&](int k) { return DBL(box.Lengths[k] * ray.slab_den[k]); };
    const DBL x = low(X), y = low(Y), z = low(Z);
    const DBL x1 = x + breadth(X), y1 = y + breadth(Y), z1 = z + breadth(Z);
    enters = std::max(std::max(std::min(x, x1), std::min(y, y1)), std::min(z, z1));
    const DBL leaves = std::min(std::min(std::max(x, x1), std::max(y, y1)), std::max(z, z1));
    return !((enters > leaves) | (leaves < EPSILON));
}

}

#endif
