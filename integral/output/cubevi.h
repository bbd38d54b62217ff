// SPDX-License-Identifier: AGPL-3.0-or-later
// Calibrations of CubeVi's light-field displays (C1), whose software is Cubestage or OpenStageAI.
#ifndef INTEGRAL_OUTPUT_CUBEVI_H
#define INTEGRAL_OUTPUT_CUBEVI_H

#include "integral/output/looking_glass.h"

#include <optional>
#include <string>

namespace integral {

/// The three numbers of a display's calibration, its pixels and their size; by itself a C1's.
///
/// The mapping that CubeVi publishes (the shader of CubeVi-Swizzle-Blender) counts columns and rows
/// of pixels from 1 at the top left: for colour 0 (red), 1 or 2 its phase is
///     mod((x + y * obliquity) * 3 + colour + deviation, line_number) / line_number,
/// and views run against it: phase 0 is the rightmost view.
struct CubeViCalibration {
    double line_number = 19.6401; ///< lineNumber: width of a lens's micro-image, in subpixels; > 0
    double obliquity = 0.10516;   ///< tangent of the slant; positive: the lenses lean to the right
    double deviation = 16.25578;  ///< phase, in subpixels
    int width = 1440, height = 2560; ///< screenW, screenH
    double dpi = 515;                ///< DPI; of 5.7 inches
    double view_cone = 40;           ///< viewCone, degrees
};

/// The same mapping in the form that Looking Glass publishes: equal for every subpixel but for
/// rounding.
LookingGlassCalibration looking_glass_from(const CubeViCalibration& calibration);

/// Reads such a calibration from a document that has lineNumber, obliquity and deviation, alone or
/// within what Cubestage and OpenStageAI wrap around them; nothing of other documents. The names of
/// the other fields are those of a Looking Glass's file; what it lacks is in `assumed`. Throws
/// std::invalid_argument naming the field, and where there are several calibrations or an
/// encrypted one.
std::optional<LookingGlassCalibration> cubevi_from_json(const Json& document);

} // namespace integral

#endif
