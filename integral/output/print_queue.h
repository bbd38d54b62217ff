// SPDX-License-Identifier: AGPL-3.0-or-later
// What a queue's driver can do, as the PPD says that its CUPS server hands out (driverless queues
// have one too). IPP's media-col-database would not do: it knows media by their size, and of a
// dye-sublimation printer's several may have the same sheet and other margins (2x6 and 4x6 of a DNP
// DS620). For files that are built with libcups only (HAVE_CUPS).
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

using PrintOptions = std::vector<std::pair<std::string, std::string>>;

/// An open PPD.
class PrintQueue {
public:
    /// Reads the PPD of a queue of the server; throws std::runtime_error with libcups' reason.
    PrintQueue(http_t* server, const std::string& printer);
    ~PrintQueue();
    PrintQueue(const PrintQueue&) = delete;
    PrintQueue& operator=(const PrintQueue&) = delete;

    std::vector<PrintMedium> media() const;

    /// The driver's name of a resolution of its list, to 0.5 dpi; empty if it has none such. `list`
    /// gets the list in words.
    std::string resolution(Vec2 dpi, std::string& list) const;

    /// The options that a job needs beside the user's: RGB, and no shrinking to the borders, where
    /// the driver has such a choice.
    PrintOptions plain_options() const;

    /// The page header which the driver expects with these options. Throws std::runtime_error if it
    /// is not 8-bit RGB.
    cups_page_header2_t page_header(const PrintOptions& options);

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace integral

#endif
