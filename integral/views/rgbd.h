// SPDX-License-Identifier: AGPL-3.0-or-later
// A picture and its depths side by side (RGBD), from which programs of light-field displays make
// views.
#ifndef INTEGRAL_VIEWS_RGBD_H
#define INTEGRAL_VIEWS_RGBD_H

#include "integral/base/parallel.h"
#include "integral/frame/depth_range.h"
#include "integral/replay/replay.h"

#include <optional>

namespace integral {

/// The picture, and the depths of its white and its black: mm behind the sheet.
struct RgbdPicture {
    Image image;
    double white = 0, black = 0;
};

/// The centre eye's view of a frame and, on its right, the depths as greys: white at the nearest
/// surface, black at the farthest and where there is none. `view`: the size, and the part of the
/// sheet, of both pictures. Equal steps of grey are equal steps of parallax, that is of 1/distance
/// from the eye, as in maps estimated from photographs; programs shift pixels by it to make views.
/// The depths are on the right, as Looking Glass Studio reads them; near is white, as in its
/// maker's RGBDToQuilt (github.com/NullandKale/NullEngine-Bridge: "White is close, black is far").
/// Samples are 8 or 16 bits, sRGB; the greys are stored values. `threads` and `progress` as in
/// replay; returns nothing if `progress` stopped the work. Throws std::invalid_argument if the
/// depths are of a frame of another size, or show no surface.
std::optional<RgbdPicture> rgbd_picture(const Frame& frame, const DepthFrame& depths, View view,
                                        int threads, const Progress& progress);

} // namespace integral

#endif
