// SPDX-License-Identifier: AGPL-3.0-or-later
// Sets the line of text below a picture, as letters for cairo or as outlines for a PDF.
#ifndef INTEGRAL_PRINT_PAGE_TEXT_H
#define INTEGRAL_PRINT_PAGE_TEXT_H

#include "integral/print/page.h"

#include <cairo.h>

#include <string>

namespace integral {

/// Selects the font of the page's strip on a context whose user space has `scale` units a mm,
/// across and down. Letters that would run over the paper's edge (capitals, or a font with broad
/// letters) are narrowed.
void select_strip_font(cairo_t* cairo, const Page& page, Vec2 scale);

/// The outlines of the page's strip as the operators of a PDF path that is to be filled, in points
/// from the page's bottom left corner; not mirrored. Empty if the page has no strip. Throws
/// std::runtime_error if cairo gives no outlines.
std::string strip_outlines(const Page& page);

} // namespace integral

#endif
