// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes pages as a PDF.
#ifndef INTEGRAL_PRINT_PAGE_PDF_H
#define INTEGRAL_PRINT_PAGE_PDF_H

#include "integral/base/file_bytes.h"
#include "integral/frame/image.h"
#include "integral/print/page_raster.h"

#include <ctime>
#include <string>

namespace integral {

/// Writes a PDF 1.6 of all pages of a picture. `form`: 8 or 16 bits; three channels, whose colours
/// `profile` (an ICC file's bytes) defines; one, printed in black ink alone; or four inks (cyan,
/// magenta, yellow, black; if the pages have it, white as a fifth) of the press that `profile`
/// describes: the file is then a PDF/X-4, created at `created`. If `two_tone`, all samples are 0 or
/// 255, and the file stores them in one bit. Each page holds its part of the picture as one image,
/// packed without loss and not to be smoothed, at whole printer pixels from the page's top left
/// corner (to a thousandth of a pixel); marks and strip are lines and text. MediaBox: the paper, in
/// whole printer pixels; BleedBox: the picture; TrimBox: the part that remains after cutting. Of
/// inks, marks are in all of them, and the strip is outlines. Viewers are asked not to scale. Equal
/// pages give equal bytes. Only some rows of the picture are in memory at a time. Throws
/// std::invalid_argument if `created` is no time that has a date, std::runtime_error if cairo
/// cannot draw, and what `picture` and `sink` throw.
void write_pdf(ByteSink& sink, const std::vector<Page>& pages, const Image& form,
               const PictureRows& picture, const std::string& profile, const std::string& title,
               std::time_t created = 0, bool two_tone = false);

} // namespace integral

#endif
