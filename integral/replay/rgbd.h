// SPDX-License-Identifier: AGPL-3.0-or-later
// A picture and its depths side by side (RGBD), as light-field displays' programs make views of.
#ifndef INTEGRAL_REPLAY_RGBD_H
#define INTEGRAL_REPLAY_RGBD_H

#include "integral/base/parallel.h"
#include "integral/lightfield/depth_range.h"
#include "integral/replay/replay.h"

#include <optional>

namespace integral {

/// The picture, and the depths that its white and its black stand for: mm behind the sheet.
struct RgbdPicture {
    Image image;
    double white = 0, black = 0;
};

/// What the centre eye sees of a frame, and to its right how far off that is (`view`: the size and
/// the part of the sheet of both): grey, white at the nearest surface, black at the farthest and
/// where there is none. Between them equal steps are equal steps of parallax: of 1/distance from
/// the eye, as in the maps that programs estimate from photographs, and which shifts of a picture's
/// pixels make views of. Both are side by side, depth right, as Looking Glass Studio reads them;
/// near is white, as in its maker's RGBDToQuilt (github.com/NullandKale/NullEngine-Bridge: "White
/// is close, black is far"). Samples are 8 or 16 bits, sRGB; the greys are stored values. `threads`
/// and `progress` as in replay; nothing if `progress` stopped the work. Throws
/// std::invalid_argument where the depths are of a frame of another size, or no surface is seen.
std::optional<RgbdPicture> rgbd_picture(const Frame& frame, const DepthFrame& depths, View view,
                                        int threads, const Progress& progress);

} // namespace integral

#endif
