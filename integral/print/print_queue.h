// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the features of a queue's driver from the PPD that its CUPS server provides (also for
// driverless queues). IPP's media-col-database is not enough: it distinguishes media by size, and a
// dye-sublimation printer may have several media with the same sheet and different margins (2x6 and
// 4x6 of a DNP DS620). Include it only with libcups (HAVE_CUPS).
#ifndef INTEGRAL_PRINT_PRINT_QUEUE_H
#define INTEGRAL_PRINT_PRINT_QUEUE_H

#include "integral/optics/vec.h"
#include "integral/print/print_media.h"

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

    /// The driver's name for a resolution, to 0.5 dpi; empty if it lacks that resolution. Sets
    /// `list` to all the driver's resolutions in words.
    std::string resolution(Vec2 dpi, std::string& list) const;

    /// The options that every job needs, if the driver has them: RGB, and no shrinking of the page
    /// to fit within borders.
    DriverOptions plain_options() const;

    /// The header that the driver expects before each page, with these options. Throws
    /// std::runtime_error if it is not a header of 8-bit RGB.
    cups_page_header2_t page_header(const DriverOptions& options);

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace integral

#endif
