// SPDX-License-Identifier: AGPL-3.0-or-later
// What a queue's driver can do, read from the PPD that its CUPS server provides (also for
// driverless queues). IPP's media-col-database is not enough: it tells media apart by size, and a
// dye-sublimation printer may have several media with the same sheet and different margins (2x6 and
// 4x6 of a DNP DS620). To be included only where libcups is (HAVE_CUPS).
#ifndef INTEGRAL_OUTPUT_PRINT_QUEUE_H
#define INTEGRAL_OUTPUT_PRINT_QUEUE_H

#include "integral/optics/vec.h"
#include "integral/output/print_media.h"

#include <cups/raster.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace integral {

/// Names and values of a driver's options.
using DriverOptions = std::vector<std::pair<std::string, std::string>>;

/// An open PPD.
class PrintQueue {
public:
    /// Reads the PPD of one of the server's queues. Throws std::runtime_error with libcups' reason.
    PrintQueue(http_t* server, const std::string& printer);
    ~PrintQueue();
    PrintQueue(const PrintQueue&) = delete;
    PrintQueue& operator=(const PrintQueue&) = delete;

    std::vector<PrintMedium> media() const;

    /// The name by which the driver calls a resolution, to 0.5 dpi; empty if it does not have it.
    /// `list` becomes all its resolutions in words.
    std::string resolution(Vec2 dpi, std::string& list) const;

    /// The options that every job needs, of those that the driver has: RGB, and no shrinking of the
    /// page to fit within borders.
    DriverOptions plain_options() const;

    /// The header that the driver expects before each page, with these options. Throws
    /// std::runtime_error if that is not a header of 8-bit RGB.
    cups_page_header2_t page_header(const DriverOptions& options);

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace integral

#endif
