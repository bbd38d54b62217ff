// SPDX-License-Identifier: AGPL-3.0-or-later
// Pages as a PDF.
#ifndef INTEGRAL_OUTPUT_PAGE_PDF_H
#define INTEGRAL_OUTPUT_PAGE_PDF_H

#include "integral/base/file_bytes.h"
#include "integral/lightfield/image.h"
#include "integral/output/page_raster.h"

#include <string>

namespace integral {

/// Writes a PDF 1.6 of all pages of a picture (`form`: 8 or 16 bits, three channels) whose colours
/// `profile` (an ICC file's bytes) describes. Each page holds its part of the picture as one image,
/// packed without loss and not to be smoothed, at whole printer pixels from the page's top left
/// corner (to a thousandth of one); marks and strip are lines and text. MediaBox: the paper, in
/// whole printer pixels; BleedBox: the picture; TrimBox: what is left after cutting. Viewers are
/// asked not to scale. The same bytes for the same pages. Some rows of the picture are in memory at
/// a time. Throws what `picture` and `sink` throw.
void write_pdf(ByteSink& sink, const std::vector<Page>& pages, const Image& form,
               const PictureRows& picture, const std::string& profile, const std::string& title);

} // namespace integral

#endif
