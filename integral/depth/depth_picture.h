// SPDX-License-Identifier: AGPL-3.0-or-later
// A picture of a scene that shows how sharp each part of it will be.
#ifndef INTEGRAL_DEPTH_DEPTH_PICTURE_H
#define INTEGRAL_DEPTH_DEPTH_PICTURE_H

#include "integral/frame/depth_range.h"
#include "integral/frame/frame.h"

#include <optional>

namespace integral {

/// The view from the aperture's centre, in grey, tinted by depth: blue where the print is sharp
/// (within `budget`, mm), yellow where it is soft (depth_advice.h), red beyond; black where there
/// is no surface. `colours`: the frame with the same pixels, if known; without it the picture shows
/// only the tints. sRGB of 8 bits, at most 800 pixels on its longer side.
Image depth_picture(const DepthFrame& depths, double budget, const std::optional<Frame>& colours);

} // namespace integral

#endif
