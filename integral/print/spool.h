// SPDX-License-Identifier: AGPL-3.0-or-later
// Sends pages to a printer of a CUPS server, pixel for pixel, and follows the job until it is
// printed.
//
// The document is a CUPS raster (application/vnd.cups-raster) of the medium's whole printable area,
// with the page in its middle. Drivers read this form, so that no filter before them can scale it.
// Other documents keep their pixels only by luck, as measured with CUPS 2.4.2, cups-filters 1.28.17
// and Gutenprint 5.3.4, for noise at 300 dpi on a DNP DS620's 4x6 (printable 1240 x 1844 pixels):
//   PNG, PPM of 1200 x 1800        made 1229 x 1844; print-scaling=none: 1204 x 1806; ppi=300: kept
//   PNG of 1240 x 1844             kept; print-scaling=none: 1239 columns, all pixels moved
//   PDF page, image 1200 x 1800    kept; fit-to-page: all but 0.03 % of the pixels differ
//   PDF page, image 1240 x 1844    moved down by a row, the last one lost, whatever the options
// The raster arrived with every pixel, and Gutenprint's yellow, magenta and cyan planes for the
// DS620 hold the same samples. The raster has the same area as CUPS' own filters make for a medium;
// this was checked with 9 drivers (Canon, Citizen, DNP, HiTi, Kodak, Mitsubishi, Shinko, Sony) and
// 42 of their media. For a driverless printer, CUPS turns the raster into a PWG raster, which keeps
// every pixel, too.
#ifndef INTEGRAL_PRINT_SPOOL_H
#define INTEGRAL_PRINT_SPOOL_H

#include "integral/base/parallel.h"
#include "integral/frame/image.h"
#include "integral/optics/vec.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral {

/// A print job. A page's size on paper follows from its pixels and the resolution.
struct SpoolJob {
    std::string printer; ///< the queue's name; empty: the server's default
    std::string title = "integral";
    /// 8-bit RGB, of one size, in the encoding that the printer expects: sRGB, or its profile's.
    std::vector<Image> pages;
    /// The printer's nominal resolution, to 0.5 dpi, without a measured feed error.
    Vec2 dpi = {300, 300};
    std::string medium; ///< the driver's name (w288h432); empty: by the page's size, to 0.5 mm
    int copies = 1;     ///< at least 1; each copy is sent as further pages, which every driver
                        ///< prints
    /// Further options of the driver, such as StpLaminate=Matte; options that scale are refused.
    std::vector<std::pair<std::string, std::string>> options;
    /// Seconds that a printer in trouble (no paper, offline) may take without progress.
    double patience = 60;
};

/// Whether this build has libcups.
bool can_spool();

/// The names of the server's printers, its default first. The server is the one in CUPS_SERVER,
/// else this machine's. Throws OutputError.
std::vector<std::string> printers();

/// Sends the pages and waits until they are printed. Returns the job's number on the server. Calls
/// `progress` several times a second with a total of 1000: the first half is for sending, the
/// second for printing, sheet by sheet. If `progress` returns false, the job is cancelled and the
/// result is empty.
///
/// Throws OutputError, "PRINTER: what is wrong; what would help", if there is no server or no such
/// printer, medium or resolution (and names the existing ones); if an option would scale; and if
/// the printer is stopped, rejects jobs, fails or stays in trouble. The job is then cancelled, so
/// that it does not print later by surprise. Throws std::invalid_argument if pages, copies or
/// resolution are not as SpoolJob requires.
std::optional<int> spool(SpoolJob job, const Progress& progress = {});

} // namespace integral

#endif
