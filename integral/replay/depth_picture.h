// SPDX-License-Identifier: AGPL-3.0-or-later
// A picture of a scene that shows how sharp each part of it will be.
#ifndef INTEGRAL_REPLAY_DEPTH_PICTURE_H
#define INTEGRAL_REPLAY_DEPTH_PICTURE_H

#include "integral/lightfield/depth_range.h"
#include "integral/lightfield/frame.h"

#include <optional>

namespace integral {

/// What the eye at the aperture's centre sees, in grey, tinted by depth: blue where it is sharp
/// (within `budget`, mm), yellow where it is soft (depth_advice.h), red beyond; black where there
/// is no surface. `colours`: the frame of the same pixels, if it is known; without it only the
/// tints are shown. sRGB of 8 bits, at most 800 pixels on its longer side.
Image depth_picture(const DepthFrame& depths, double budget, const std::optional<Frame>& colours);

} // namespace integral

#endif
