// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws the calibration page (calibration_layout.h) for one sheet and printer.
#ifndef INTEGRAL_PRINT_CALIBRATION_PAGE_H
#define INTEGRAL_PRINT_CALIBRATION_PAGE_H

#include "integral/print/calibration_layout.h"
#include "integral/print/chart_page.h"

namespace integral {

/// The page as a frame of its sheet, with the command that reads its photograph. The geometry's
/// aperture is for `distance` mm, and its sheet has no offset. Throws as calibration_layout does.
ChartPage calibration_page(FrameMetadata geometry, double distance);

} // namespace integral

#endif
