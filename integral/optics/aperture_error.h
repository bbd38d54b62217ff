// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks a capture aperture against its sheet, wherever geometry is read.
#ifndef INTEGRAL_OPTICS_APERTURE_ERROR_H
#define INTEGRAL_OPTICS_APERTURE_ERROR_H

#include "integral/optics/lens_sheet.h"

#include <string>

namespace integral {

/// The reason why an aperture of this width and height (mm) would image nothing; empty if it images
/// something. Part of find_errors (camera_parameters.h).
std::string aperture_error(const LensSheet& sheet, Vec2 extent);

} // namespace integral

#endif
