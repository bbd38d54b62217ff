// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes the document of a print job for one queue's driver. Include it only with libcups
// (HAVE_CUPS).
#ifndef INTEGRAL_PRINT_SPOOL_DOCUMENT_H
#define INTEGRAL_PRINT_SPOOL_DOCUMENT_H

#include "integral/print/cups_raster.h"
#include "integral/print/print_queue.h"
#include "integral/print/spool.h"

#include <string>
#include <vector>

namespace integral {

/// A job's data, to send as CUPS raster.
struct SpoolDocument {
    std::vector<Image> sheets; ///< pages as large as the medium's printable area
    cups_page_header2_t header;
    DriverOptions options; ///< of the job
};

/// Puts each of a job's pages into the middle of its medium's printable area. Throws
/// std::runtime_error if the printer has no such resolution or medium, or if a page has colour
/// outside the printable area.
SpoolDocument spool_document(SpoolJob job, http_t* server, const std::string& printer);

} // namespace integral

#endif
