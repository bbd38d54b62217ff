// SPDX-License-Identifier: AGPL-3.0-or-later
// The document of a print job, made for one queue's driver. To be included only where libcups is
// (HAVE_CUPS).
#ifndef INTEGRAL_OUTPUT_SPOOL_DOCUMENT_H
#define INTEGRAL_OUTPUT_SPOOL_DOCUMENT_H

#include "integral/output/print_queue.h"
#include "integral/output/spool.h"

#include <string>

namespace integral {

/// A document, and the options that its job needs.
struct SpoolDocument {
    std::string bytes;
    DriverOptions options;
};

/// Makes the CUPS raster of a job's pages: each in the middle of the printable area of the medium
/// that it fits. Throws std::runtime_error where the printer has no such resolution or medium, or
/// where the page has colour outside the printable area.
SpoolDocument spool_document(const SpoolJob& job, http_t* server, const std::string& printer);

} // namespace integral

#endif
