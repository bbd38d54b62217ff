// SPDX-License-Identifier: AGPL-3.0-or-later
// A page as a picture, pixel by pixel.
#ifndef INTEGRAL_OUTPUT_PAGE_RASTER_H
#define INTEGRAL_OUTPUT_PAGE_RASTER_H

#include "integral/lightfield/image.h"
#include "integral/output/page.h"

namespace integral {

/// The page of a picture of 8 or 16 bits and three channels, in its form: white paper, the picture's own pixels, marks and strip in
/// black, one pixel wide and not smoothed (drawn by cairo). Marks do not touch the picture. Throws std::runtime_error where cairo cannot.
Image rasterized(const Page& page, const Image& picture);

/// The page's part of a picture; turned left to right where the page is.
Image picture_on(const Page& page, const Image& picture);

} // namespace integral

#endif
