// SPDX-License-Identifier: AGPL-3.0-or-later
// Which of a printer's media a page fits, and where on it the page lies: no pixel is scaled, whole
// pixels only.
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
    SizeMm standard;   ///< what the name means everywhere (A4); zeros where it is no such name
};

/// The size that a medium is sold by, read from "w288h432" (points) or from a label like "4x6"
/// (inches) or "100x148mm"; the standard size if neither says, and the driver's sheet where there
/// is none.
SizeMm nominal_size(const PrintMedium& medium);

/// A page on a medium.
struct PagePlace {
    std::size_t medium = 0; ///< index
    bool turned = false;    ///< the page is turned by a quarter, as turned_page does
};

/// The medium whose printable area, nominal size or sheet is the page's to 0.5 mm, in that order of
/// preference, upright before turned. Of several of one sheet the one with most to print on, of one
/// nominal size the one with the shortest name (others cut the sheet into parts). Only `name`,
/// unless it is empty.
std::optional<PagePlace> place_page(const std::vector<PrintMedium>& media, SizeMm page,
                                    const std::string& name = "");

/// The media in words, for messages: "4x6 (101.6 x 152.4 mm, w288h432), ...".
std::string media_in_words(const std::vector<PrintMedium>& media);

/// A page of 8-bit RGB turned clockwise: its left edge becomes the top.
Image turned_page(const Image& page);

/// A page of 8-bit RGB in the middle of a white area of width x height pixels (an odd pixel over:
/// right, below). What is outside is cut off if it is white; nothing if it is not.
std::optional<Image> centred_page(const Image& page, int width, int height);

} // namespace integral

#endif
