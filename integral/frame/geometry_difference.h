// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds out whether two frames' pixels have the same lines of sight.
#ifndef INTEGRAL_FRAME_GEOMETRY_DIFFERENCE_H
#define INTEGRAL_FRAME_GEOMETRY_DIFFERENCE_H

#include "integral/frame/frame_metadata.h"

#include <optional>
#include <string>

namespace integral {

/// A field of two documents that differs: its path, such as "sheet.pitch_mm", and both values as
/// JSON.
struct GeometryDifference {
    std::string field, first, second;
};

/// The first field of sheet, film or aperture in which two geometries differ, or render.model or
/// render.pseudoscopic (of geometries without a render: the defaults). Numbers count as equal if
/// they differ by at most 1e-9 of the larger magnitude, or 1e-9 if both are below 1. Nothing: a
/// pixel of one has the same line of sight in the other.
std::optional<GeometryDifference> geometry_difference(const FrameMetadata& first,
                                                      const FrameMetadata& second);

} // namespace integral

#endif
