// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the part of a pixel that is behind its own lens. At the border of a lens's picture pixels
// lie partly behind the next lens, or where no light comes from. Only samples behind the lens of
// its centre count for a pixel, so that its beam is narrower, and its middle is elsewhere.
#ifndef INTEGRAL_LIGHTFIELD_CUT_PIXEL_H
#define INTEGRAL_LIGHTFIELD_CUT_PIXEL_H

#include "integral/lightfield/beam_samples.h"

#include <optional>

namespace integral {

/// The part of a pixel behind the lens of its centre, taken for a rectangle.
struct CutPixel {
    SightSlope centre; ///< the line from the part's middle through the lens's pole
    Vec2 size;         ///< of the part, in pixels, right and up: 0.5 to 1
};

/// The part of pixel (x, y), whose centre is behind a lens; nothing if it is the whole pixel. Its
/// ends are known to 1/16 of a pixel.
std::optional<CutPixel> cut_pixel(const IntegralCamera& camera, const FirstSamples& first, int x,
                                  int y);

} // namespace integral

#endif
