// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the part of a pixel that is behind its own lens, the lens that images its centre. At the
// border of a lens's picture, pixels lie partly behind the next lens, or where no light arrives.
// Only samples through the own lens count, so that the beam is narrower and its middle shifted.
#ifndef INTEGRAL_RECONSTRUCTION_CLIPPED_PIXEL_H
#define INTEGRAL_RECONSTRUCTION_CLIPPED_PIXEL_H

#include "integral/reconstruction/beam_samples.h"

#include <optional>

namespace integral {

/// The part of a pixel behind the lens of its centre, approximated by a rectangle.
struct ClippedPixel {
    LightFieldRay centre; ///< the ray from the part's middle through the lens's pole
    Vec2 size;            ///< width and height of the part, in pixels: 0.5 to 1
};

/// The part of pixel (x, y), whose centre must be behind a lens; nothing if it is the whole pixel.
/// The part's borders are accurate to 1/16 of a pixel.
std::optional<ClippedPixel> cut_pixel(const IntegralCamera& camera, const LightFieldImage& first,
                                      int x, int y);

} // namespace integral

#endif
