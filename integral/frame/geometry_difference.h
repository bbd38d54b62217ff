// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds out whether two frames' pixels have the same lines of sight.
#ifndef INTEGRAL_FRAME_GEOMETRY_DIFFERENCE_H
#define INTEGRAL_FRAME_GEOMETRY_DIFFERENCE_H

#include "integral/base/json_difference.h"
#include "integral/frame/frame_metadata.h"

#include <optional>

namespace integral {

/// The first difference (json_difference) in sheet, film, aperture, render.model or
/// render.pseudoscopic; geometries without a render have the defaults of these two. A value that
/// one geometry lacks is "not given". Numbers below 1 count as equal within 1e-9. Nothing: a pixel
/// of one has the same line of sight in the other.
std::optional<JsonDifference> geometry_difference(const FrameMetadata& first,
                                                  const FrameMetadata& second);

} // namespace integral

#endif
