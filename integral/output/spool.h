// SPDX-License-Identifier: AGPL-3.0-or-later
// Pages to a printer of a CUPS server, pixel for pixel, and the job followed until it is printed.
//
// The document is a CUPS raster (application/vnd.cups-raster) of the medium's whole printable area,
// with the page in its middle: what drivers read, so that no filter is left that could scale.
// Measured with CUPS 2.4.2, cups-filters 1.28.17 and Gutenprint 5.3.4, noise at 300 dpi on a DNP
// DS620's 4x6 (printable 1240 x 1844 pixels), other documents keep pixels by luck:
//   PNG, PPM of 1200 x 1800        made 1229 x 1844; print-scaling=none: 1204 x 1806; ppi=300: kept
//   PNG of 1240 x 1844             kept; print-scaling=none: 1239 columns, all pixels moved
//   PDF page, image 1200 x 1800    kept; fit-to-page: all but 0.03 % of the pixels differ
//   PDF page, image 1240 x 1844    moved down by a row, the last one lost, whatever the options
// The raster arrived with every pixel, and Gutenprint's yellow, magenta and cyan planes for the
// DS620 hold the very samples. Its area is the one that CUPS' own filters make for a medium,
// checked with 9 drivers (Canon, Citizen, DNP, HiTi, Kodak, Mitsubishi, Shinko, Sony) and 42 of
// their media. A driverless printer gets a PWG raster that CUPS makes of it, with every pixel too.
#ifndef INTEGRAL_OUTPUT_SPOOL_H
#define INTEGRAL_OUTPUT_SPOOL_H

#include "integral/base/parallel.h"
#include "integral/lightfield/image.h"
#include "integral/optics/vec.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral {

/// What to print, and where. A page's size on paper is its pixels by the printer's own resolution.
struct SpoolJob {
    std::string printer; ///< the queue's name; empty: the server's default
    std::string title = "integral";
    std::vector<Image> pages; ///< 8-bit RGB, of one size, in the encoding that the printer expects
                              ///< (sRGB, or by its profile)
    Vec2 dpi = {300, 300};    ///< the printer's nominal one, to 0.5; a measured feed error is the
                              ///< film's, not given here
    std::string medium; ///< the driver's name of it (w288h432); empty: by the page's size, to 0.5
                        ///< mm
    int copies = 1;     ///< at least 1; sent as that many pages, which every driver prints
    std::vector<std::pair<std::string, std::string>> options; ///< further ones of the driver,
                                                              ///< StpLaminate=Matte; none that
                                                              ///< scales
    double patience = 60; ///< seconds without progress that a printer in trouble (no paper,
                          ///< offline) is given
};

/// Whether this build has libcups.
bool can_spool();

/// The server's printers, its default first. The server is CUPS_SERVER's (libcups' own rule), else
/// the machine's. Throws OutputError.
std::vector<std::string> printers();

/// Sends the pages and waits until they are printed: the job's number on the server. `progress` is
/// called some times a second, of a total of 1000: half when sent, then by sheets; if it returns
/// false the job is cancelled and the result is nothing. Throws OutputError, "PRINTER: what is
/// wrong; what would help": no server, no such printer (with those there are), no such medium or
/// resolution (with the printer's), an option that would scale, a printer that is stopped, rejects
/// jobs, fails or stays in trouble (in its own words; the job is cancelled then, so that it does
/// not print later by surprise). Throws std::invalid_argument where pages or copies are not as
/// above.
std::optional<int> spool(const SpoolJob& job, const Progress& progress = {});

} // namespace integral

#endif
