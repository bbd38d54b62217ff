// SPDX-License-Identifier: AGPL-3.0-or-later
// Reduces pictures that have more pixels than their use needs.
#ifndef INTEGRAL_DEPTH_AVERAGED_H
#define INTEGRAL_DEPTH_AVERAGED_H

#include "integral/frame/image.h"

namespace integral {

/// The whole factor by which a picture may be reduced and still has `width` pixels across; at
/// least 1.
int reduction(const Image& picture, int width);

/// The picture with means of factor x factor pixels, in linear light. Pixels that fill no such
/// square, at the right and below, are left out. `factor` must not exceed the picture's sides.
Image averaged(const Image& picture, int factor, int threads);

} // namespace integral

#endif
