// SPDX-License-Identifier: AGPL-3.0-or-later
// Pages as a CUPS raster, the form in which a driver reads them. For files that are built with
// libcups only (HAVE_CUPS).
#ifndef INTEGRAL_OUTPUT_CUPS_RASTER_H
#define INTEGRAL_OUTPUT_CUPS_RASTER_H

#include "integral/lightfield/image.h"

#include <cups/raster.h>

#include <string>
#include <vector>

namespace integral {

/// An application/vnd.cups-raster stream of version 3 (uncompressed), every page `copies` times,
/// the copies of the whole document one after another. Pages: 8-bit RGB, of one size. `like`: the
/// queue's own header (medium, resolution, colour space RGB or sRGB, 8 bits, chunky); the sizes in
/// pixels and bytes are set here. Throws std::runtime_error with libcups' reason.
std::string cups_raster(const std::vector<Image>& pages, int copies,
                        const cups_page_header2_t& like);

} // namespace integral

#endif
