// SPDX-License-Identifier: AGPL-3.0-or-later
// Adds to a PDF what makes it a PDF/X-4, the standard for files that go to a press (ISO 15930-7).
#ifndef INTEGRAL_PRINT_PDFX_H
#define INTEGRAL_PRINT_PDFX_H

#include "integral/io/pdf_file.h"

#include <ctime>
#include <string>

namespace integral {

struct PdfxDocument {
    std::string profile; ///< bytes of the press's ICC profile
    std::string title;
    std::time_t created = 0; ///< seconds since 1970, UTC
};

/// Object texts of a PDF/X-4.
struct PdfxEntries {
    std::string catalog; ///< entries for the document catalog
    std::string about;   ///< the document information dictionary
};

/// Writes the press's profile and the XMP metadata, and returns the entries that refer to them. To
/// be called after the pages: the document's identifier is a digest of all bytes before.
/// Throws std::invalid_argument if `created` is no time that has a date, and what the file throws.
PdfxEntries add_pdfx(PdfFile& pdf, const PdfxDocument& document);

} // namespace integral

#endif
