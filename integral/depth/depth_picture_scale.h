// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a depth map in colours, with their scale.
#ifndef INTEGRAL_DEPTH_DEPTH_PICTURE_SCALE_H
#define INTEGRAL_DEPTH_DEPTH_PICTURE_SCALE_H

#include "integral/depth/depth_files.h"

namespace integral {

/// Yellow is near, dark blue far (in steps that colour-blind readers can distinguish), and grey
/// where nothing is known. Equal steps of disparity are equal steps of the colour map. The scale on
/// the right is in millimetres or, if they are not known, in disparities. sRGB of 8 bits.
Image depth_picture_with_scale(const UprightMap& map);

} // namespace integral

#endif
