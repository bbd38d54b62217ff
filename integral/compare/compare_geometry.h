// SPDX-License-Identifier: AGPL-3.0-or-later
// Whether two frames are frames of one geometry.
#ifndef INTEGRAL_COMPARE_COMPARE_GEOMETRY_H
#define INTEGRAL_COMPARE_COMPARE_GEOMETRY_H

#include "integral/lightfield/frame_metadata.h"

#include <optional>
#include <string>

namespace integral {

/// The first field of their documents in which two geometries differ, in words ("sheet.pitch_mm
/// is 1.28, its reference's 1.27"); empty if there is none. Numbers may differ by 1e-9 of
/// themselves, as other compilers round. How a frame was rendered is left out (program, scene,
/// seconds, samples, error, mapping), unless it changes how the frame is to be seen: lens model,
/// pseudoscopic, prefilter.
std::string geometry_difference(const std::optional<FrameMetadata>& reference,
                                const std::optional<FrameMetadata>& result);

} // namespace integral

#endif
