// SPDX-License-Identifier: AGPL-3.0-or-later
// Marks OpenEXR files of depths, whose channel Y repeats the depths for programs that read no Z.
#ifndef INTEGRAL_FRAME_DEPTH_ATTRIBUTE_H
#define INTEGRAL_FRAME_DEPTH_ATTRIBUTE_H

namespace integral {

/// Name of the text attribute with the quantity and unit of channel Y.
constexpr char depth_attribute[] = "depthUnit";

constexpr char depth_in_mm[] = "mm behind the sheet", depth_as_disparity[] = "disparity, pixels";

} // namespace integral

#endif
