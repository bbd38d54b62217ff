// SPDX-License-Identifier: AGPL-3.0-or-later
// Marks around a picture on a page: where to cut, how colours register, where the lenses' axes run.
// They are drawn outside the picture.
#ifndef INTEGRAL_OUTPUT_PAGE_MARKS_H
#define INTEGRAL_OUTPUT_PAGE_MARKS_H

#include "integral/output/page.h"

namespace integral {

/// How far from the picture marks reach, mm; 0 where none are asked for.
double marks_margin(const PageRequest& request);

/// The lines of all marks that are asked for. Axis marks: above and below the picture (2-D sheets:
/// left and right, too) the axis of every fifth lens, counted from the one nearest to the sheet's
/// middle, whose mark is longer, in the direction in which it runs; of hexagonal lenses the rows'
/// poles of even rows. Throws std::invalid_argument where more than 10000 axes would be marked on a
/// side.
std::vector<PageLine> page_marks(const Page& page, const FrameMetadata& metadata,
                                 const PageRequest& request);

} // namespace integral

#endif
