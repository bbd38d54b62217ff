// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the code of a calibration page (calibration_layout.h) in its photograph.
#ifndef INTEGRAL_ANALYSIS_PAGE_CODE_H
#define INTEGRAL_ANALYSIS_PAGE_CODE_H

#include "integral/analysis/photo_camera.h"
#include "integral/analysis/photo_plane.h"
#include "integral/print/calibration_layout.h"

namespace integral {

/// Throws std::invalid_argument, with advice, if the dots belong to a page with other options,
/// or if less than the code's length can be seen. `camera`: as find_page finds it.
void check_page_code(const Plane& photo, const PhotoCamera& camera,
                     const std::vector<CodeSquare>& code);

} // namespace integral

#endif
