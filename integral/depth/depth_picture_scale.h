// SPDX-License-Identifier: AGPL-3.0-or-later
// A depth map as a picture in colours, with the scale that they stand for.
#ifndef INTEGRAL_DEPTH_DEPTH_PICTURE_SCALE_H
#define INTEGRAL_DEPTH_DEPTH_PICTURE_SCALE_H

#include "integral/depth/depth_files.h"

namespace integral {

/// Yellow is near, dark blue far (in steps that colour-blind readers can tell), and grey where
/// nothing is known. Colours are even in disparity; the scale on the right says the millimetres, or
/// if they are not known the disparities. sRGB of 8 bits.
Image depth_picture_with_scale(const UprightMap& map);

} // namespace integral

#endif
