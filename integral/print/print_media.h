// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the medium of a printer that a page fits, and places the page on it, in whole pixels and
// not scaled.
#ifndef INTEGRAL_PRINT_PRINT_MEDIA_H
#define INTEGRAL_PRINT_PRINT_MEDIA_H

#include "integral/frame/image.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// A rectangle's sides, mm.
struct SizeMm {
    double width = 0, height = 0;
};

/// A medium as a queue's driver describes it. Dye-sublimation drivers print a little more than the
/// sheet that remains after cutting: "4x6" (101.6 x 152.4 mm) of a DNP DS620 has 105.0 x 156.1 mm
/// to print on.
struct PrintMedium {
    std::string name;  ///< the driver's keyword, w288h432
    std::string label; ///< for people, 4x6
    SizeMm sheet;      ///< as the driver counts it, with margins
    SizeMm printable;  ///< the area of a raster of the medium
    SizeMm standard;   ///< the size of a standard name such as A4; zeros for other names
};

/// The size by which a medium is sold. It is read from a name like "w288h432" (points) or a label
/// like "4x6" (inches) or "100x148mm"; otherwise it is the standard size or, if there is none, the
/// driver's sheet.
SizeMm nominal_size(const PrintMedium& medium);

/// A page on a medium.
struct PagePlace {
    std::size_t medium = 0; ///< index
    bool turned = false;    ///< the page is turned by a quarter, as by turned_page
};

/// Finds the medium that a page fits to 0.5 mm: preferably by its printable area, then by its
/// nominal size, then by its sheet; and upright rather than turned. Among several media that fit by
/// their sheets, takes the one with the largest printable area; among those that fit by nominal
/// size, the shortest name (longer names cut the sheet into parts). If `name` is not empty, only
/// the medium of that name is considered. Empty if no medium fits.
std::optional<PagePlace> place_page(const std::vector<PrintMedium>& media, SizeMm page,
                                    const std::string& name = "");

/// The media in words, for messages: "4x6 (101.6 x 152.4 mm, w288h432), ...".
std::string media_in_words(const std::vector<PrintMedium>& media);

/// Turns a page of 8-bit RGB clockwise by a quarter: its left edge becomes the top.
Image turned_page(const Image& page);

/// Puts a page of 8-bit RGB in the middle of a white area of width x height pixels; if the margins
/// cannot be equal, the right or bottom one is a pixel wider. A page larger than the area loses its
/// edge if that is white; otherwise the result is empty.
std::optional<Image> centred_page(const Image& page, int width, int height);

} // namespace integral

#endif
