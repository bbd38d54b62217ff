// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds out whether two frames have the same geometry.
#ifndef INTEGRAL_COMPARE_COMPARE_GEOMETRY_H
#define INTEGRAL_COMPARE_COMPARE_GEOMETRY_H

#include "integral/frame/frame_metadata.h"

#include <optional>
#include <string>

namespace integral {

/// The first field in which the documents of two geometries differ, in words ("sheet.pitch_mm is
/// 1.28, its reference's 1.27"); empty if they agree. Numbers may differ by a relative 1e-9,
/// because compilers round differently. Fields about rendering (program, scene, seconds, samples,
/// error, mapping) do not count, except for lens model, pseudoscopic and prefilter, which affect
/// how the frame is to be viewed.
std::string geometry_difference_text(const std::optional<FrameMetadata>& reference,
                                     const std::optional<FrameMetadata>& result);

} // namespace integral

#endif
