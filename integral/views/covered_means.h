// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a picture smaller, so that detail which lenses cannot show does not alias.
#ifndef INTEGRAL_VIEWS_COVERED_MEANS_H
#define INTEGRAL_VIEWS_COVERED_MEANS_H

#include "integral/frame/image.h"

namespace integral {

/// Number of pixels, 1 to `pixels`, along a side `length` mm long, for pixels at least `step` mm
/// wide.
int pixels_of_step(int pixels, double length, double step);

/// The picture as width x height floats of linear light with alpha, premultiplied: each new pixel
/// is the mean of the old ones that it covers. `width` and `height` are at most the picture's.
/// `threads`: 0: one per core.
Image covered_means(const Image& picture, int width, int height, int threads);

} // namespace integral

#endif
