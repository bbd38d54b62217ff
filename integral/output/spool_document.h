// SPDX-License-Identifier: AGPL-3.0-or-later
// The document of a print job, made for one queue's driver. To be included only where libcups is
// (HAVE_CUPS).
#ifndef INTEGRAL_OUTPUT_SPOOL_DOCUMENT_H
#define INTEGRAL_OUTPUT_SPOOL_DOCUMENT_H

#include "integral/output/cups_raster.h"
#include "integral/output/print_queue.h"
#include "integral/output/spool.h"

#include <string>
#include <vector>

namespace integral {

/// What is to be sent, as CUPS raster.
struct SpoolDocument {
    std::vector<Image> sheets; ///< pages as large as the medium's printable area
    cups_page_header2_t header;
    DriverOptions options; ///< of the job
};

/// Puts each of a job's pages into the middle of the printable area of the medium that it fits.
/// Throws std::runtime_error where the printer has no such resolution or medium, or where a page
/// has colour outside the printable area.
SpoolDocument spool_document(SpoolJob job, http_t* server, const std::string& printer);

} // namespace integral

#endif
