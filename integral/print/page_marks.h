// SPDX-License-Identifier: AGPL-3.0-or-later
// Places marks outside a picture on its page: for cutting, for the register of colours, and for
// lenses' axes.
#ifndef INTEGRAL_PRINT_PAGE_MARKS_H
#define INTEGRAL_PRINT_PAGE_MARKS_H

#include "integral/print/page.h"

namespace integral {

/// Distance from the picture to the far ends of its marks, mm; 0 if no marks are requested.
double marks_margin(const PageRequest& request);

/// Lines of all requested marks. Crop marks stand at each frame, shorter where another is near and
/// none in a gap narrower than 4 mm; the other marks at the whole picture. Axis marks stand at the
/// two edges towards which the axes of lenticular lenses run, and at all four edges for 2-D sheets.
/// They show place and direction of the axis of every fifth lens, counted from the lens nearest to
/// the sheet's middle, whose mark is longer; of hexagonal rows, which are shifted, every tenth is
/// marked. Throws std::invalid_argument if more than 10000 axes would be marked on one side of the
/// middle.
std::vector<PageLine> page_marks(const Page& page, const FrameMetadata& metadata,
                                 const PageRequest& request);

} // namespace integral

#endif
