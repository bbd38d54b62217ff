// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes pages as a CUPS raster, the form that drivers read. Include it only with libcups
// (HAVE_CUPS).
#ifndef INTEGRAL_PRINT_CUPS_RASTER_H
#define INTEGRAL_PRINT_CUPS_RASTER_H

#include "integral/frame/image.h"

#include <cups/raster.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace integral {

/// Takes the next bytes of a document. Returns whether to go on. Must not throw: it is called
/// through libcups, which is C.
using TakeBytes = std::function<bool(const char* bytes, std::size_t count)>;

/// Writes an application/vnd.cups-raster stream, version 3 (uncompressed): the whole document
/// `copies` times, one copy after another. `pages` are 8-bit RGB and of one size. `like` is the
/// header from the queue's driver (medium, resolution, colour space RGB or sRGB, 8 bits, chunky),
/// whose sizes in pixels and bytes are set here. Returns false if `take` did. Throws
/// std::runtime_error with libcups' reason.
bool write_cups_raster(const std::vector<Image>& pages, int copies, const cups_page_header2_t& like,
                       const TakeBytes& take);

} // namespace integral

#endif
