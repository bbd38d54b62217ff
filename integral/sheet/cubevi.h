// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads calibrations of CubeVi's light-field displays (C1), whose software is Cubestage or
// OpenStageAI.
#ifndef INTEGRAL_SHEET_CUBEVI_H
#define INTEGRAL_SHEET_CUBEVI_H

#include "integral/sheet/looking_glass.h"

#include <optional>
#include <string>

namespace integral {

/// Calibration, resolution and pixel size of a display. Defaults: CubeVi C1.
///
/// The mapping that CubeVi publishes (the shader of CubeVi-Swizzle-Blender) counts columns and rows
/// of pixels from 1 at the top left: for colour 0 (red), 1 or 2 its phase is
///     mod((x + y * obliquity) * 3 + colour + deviation, line_number) / line_number,
/// and views are numbered in the opposite direction: phase 0 is the rightmost view.
struct CubeViCalibration {
    double line_number = 19.6401; ///< lineNumber: width of a lens's micro-image, in subpixels; > 0
    double obliquity = 0.10516;   ///< tangent of the slant; positive: the lenses lean to the right
    double deviation = 16.25578;  ///< phase, in subpixels
    int width = 1440, height = 2560; ///< screenW, screenH
    double dpi = 515;                ///< DPI; the display has 5.7 inches
    double view_cone = 40;           ///< viewCone, degrees
};

/// Converts to the mapping that Looking Glass publishes: equal for every subpixel except for
/// rounding.
LookingGlassCalibration looking_glass_from(const CubeViCalibration& calibration);

/// Reads a CubeVi calibration: an object with lineNumber, obliquity and deviation, alone or within
/// the wrappers of Cubestage and OpenStageAI. Returns nothing for other documents. The other fields
/// have the names of a Looking Glass's file; missing ones are listed in `assumed`. Throws
/// std::invalid_argument naming the field, and if there are several calibrations or an encrypted
/// one.
std::optional<LookingGlassCalibration> cubevi_from_json(const Json& document);

} // namespace integral

#endif
