// SPDX-License-Identifier: AGPL-3.0-or-later
// Which of a printer's media a page fits, and where on the medium it lies, in whole pixels and not
// scaled.
#ifndef INTEGRAL_OUTPUT_PRINT_MEDIA_H
#define INTEGRAL_OUTPUT_PRINT_MEDIA_H

#include "integral/lightfield/image.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// A rectangle's sides, mm.
struct SizeMm {
    double width = 0, height = 0;
};

/// A medium as a queue's driver describes it. Dye-sublimation drivers print a little more than the
/// sheet that is left after cutting: "4x6" (101.6 x 152.4 mm) of a DNP DS620 has 105.0 x 156.1 mm
/// to print on.
struct PrintMedium {
    std::string name;  ///< the driver's keyword, w288h432
    std::string label; ///< for people, 4x6
    SizeMm sheet;      ///< as the driver counts it, margins and all
    SizeMm printable;  ///< what a raster of the medium covers
    SizeMm standard;   ///< the size of a standard name such as A4; zeros for other names
};

/// The size that a medium is sold by. It is read from a name like "w288h432" (points) or a label
/// like "4x6" (inches) or "100x148mm"; otherwise it is the standard size, or without one the
/// driver's sheet.
SizeMm nominal_size(const PrintMedium& medium);

/// A page on a medium.
struct PagePlace {
    std::size_t medium = 0; ///< index
    bool turned = false;    ///< the page is turned by a quarter, as by turned_page
};

/// Finds the medium that a page fits to 0.5 mm: preferably by its printable area, then by its
/// nominal size, then by its sheet; and upright rather than turned. Of several media with the same
/// sheet it takes the one with the largest printable area; of several with the same nominal size
/// the one with the shortest name (the others cut the sheet into parts). A `name` that is not empty
/// allows that medium only. Empty if none fits.
std::optional<PagePlace> place_page(const std::vector<PrintMedium>& media, SizeMm page,
                                    const std::string& name = "");

/// The media in words, for messages: "4x6 (101.6 x 152.4 mm, w288h432), ...".
std::string media_in_words(const std::vector<PrintMedium>& media);

/// A page of 8-bit RGB turned clockwise by a quarter: its left edge becomes the top.
Image turned_page(const Image& page);

/// A page of 8-bit RGB in the middle of a white area of width x height pixels; an odd pixel is left
/// over at the right or below. A page larger than the area loses its edge if that is white; if it
/// is not, the result is empty.
std::optional<Image> centred_page(const Image& page, int width, int height);

} // namespace integral

#endif
