// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a picture smaller, so that detail which lenses cannot show does not alias.
#ifndef INTEGRAL_VIEWS_COVERED_MEANS_H
#define INTEGRAL_VIEWS_COVERED_MEANS_H

#include "integral/frame/image.h"

#include <algorithm>

namespace integral {

/// Adds a colour times its weight.
inline void add(Colour& sum, float weight, Colour c)
{
    sum = {sum.r + weight * c.r, sum.g + weight * c.g, sum.b + weight * c.b, sum.a + weight * c.a};
}

/// Alpha clamped to 0..1; NaN becomes 0.
inline float share_of(float alpha) { return alpha > 0 ? std::min(alpha, 1.0f) : 0; }

/// Number of pixels, 1 to `pixels`, along a side `length` mm long, for pixels at least `step` mm
/// wide.
int pixels_of_step(int pixels, double length, double step);

/// The picture as width x height floats of linear light with alpha, premultiplied: each new pixel
/// is the mean of the old ones that it covers. Colours that are not finite count as 0, alpha is
/// clamped to 0..1. `width` and `height` are at most the picture's.
/// `threads`: 0: one per core.
Image covered_means(const Image& picture, int width, int height, int threads);

} // namespace integral

#endif
