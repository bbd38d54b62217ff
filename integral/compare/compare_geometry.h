// SPDX-License-Identifier: AGPL-3.0-or-later
// Tells whether two frames have the same geometry.
#ifndef INTEGRAL_COMPARE_COMPARE_GEOMETRY_H
#define INTEGRAL_COMPARE_COMPARE_GEOMETRY_H

#include "integral/lightfield/frame_metadata.h"

#include <optional>
#include <string>

namespace integral {

/// The first field in which the documents of two geometries differ, in words ("sheet.pitch_mm is
/// 1.28, its reference's 1.27"); empty if they agree. Numbers may differ by a relative 1e-9,
/// because compilers round differently. Fields of how a frame was rendered (program, scene,
/// seconds, samples, error, mapping) do not count, except those that change how it is to be seen:
/// lens model, pseudoscopic, prefilter.
std::string geometry_difference(const std::optional<FrameMetadata>& reference,
                                const std::optional<FrameMetadata>& result);

} // namespace integral

#endif
