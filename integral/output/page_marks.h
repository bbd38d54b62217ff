// SPDX-License-Identifier: AGPL-3.0-or-later
// Marks outside a picture on its page: where to cut, how colours register, where lenses' axes run.
#ifndef INTEGRAL_OUTPUT_PAGE_MARKS_H
#define INTEGRAL_OUTPUT_PAGE_MARKS_H

#include "integral/output/page.h"

namespace integral {

/// How far from the picture its marks reach, mm; 0 if no marks are asked for.
double marks_margin(const PageRequest& request);

/// The lines of all marks that are asked for. Axis marks stand above and below the picture, of 2-D
/// sheets also at its left and right. They show where the axis of every fifth lens runs and its
/// direction, counted from the lens nearest to the sheet's middle, whose mark is longer. Of
/// hexagonal lenses, whose neighbouring rows are shifted, the even rows' lenses are marked. Throws
/// std::invalid_argument where more than 10000 axes would be marked on one side of the middle.
std::vector<PageLine> page_marks(const Page& page, const FrameMetadata& metadata,
                                 const PageRequest& request);

} // namespace integral

#endif
