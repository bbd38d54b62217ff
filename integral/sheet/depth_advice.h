// SPDX-License-Identifier: AGPL-3.0-or-later
// Advises on changes that bring more of a scene within the depth budget of its sheet and film, with
// the gain of each.
#ifndef INTEGRAL_SHEET_DEPTH_ADVICE_H
#define INTEGRAL_SHEET_DEPTH_ADVICE_H

#include "integral/frame/depth_range.h"
#include "integral/sheet/scene_fit.h"

#include <optional>
#include <vector>

namespace integral {

/// Limit of the soft depths, in depth budgets. Depths up to one budget from the sheet are called
/// sharp, from there to this limit soft, farther ones beyond. The pixels resolve as much as the
/// lenses at one budget, and half as much at the limit.
constexpr double soft_budgets = 2;

/// Shares of a picture that are sharp, soft and beyond; their sum is 1. A pixel without a surface
/// counts at the depth where infinitely far points are seen. Surfaces that a parallax over 1 puts
/// beyond the viewer's infinity (eyes would diverge) count as infinitely far. In a frame without
/// eye_distances, only pixels that show a surface count.
struct DepthShares {
    double sharp = 0, soft = 0, beyond = 0;
};

/// A frame's sheet position and parallax; sheet_distance in scene units.
SceneFit fit_of(const FrameMetadata& metadata);

/// One change: the new value, and the resulting sharp share of the picture.
struct DepthRemedy {
    double value = 0, sharp = 0;
};

/// The fit to a number of depth budgets, with the resulting shares.
struct FitAdvice {
    double budgets = 1;
    SceneFit fit; ///< sheet_distance in scene units
    DepthShares shares;
};

/// Advice for a depth frame.
struct DepthAdvice {
    DepthShares now;
    std::vector<FitAdvice> fits;    ///< to 1 and to 2 budgets; none without a placement
    std::optional<DepthRemedy> dpi; ///< of a printer; none for panels
};

/// The depths that the scene's eye sees through the sheet, as a frame with all its pixels in one
/// row. The pixels of `frame` itself see the scene from points all over the aperture. An open
/// floor, for example, is nearer to some of these than the fit assumes. Returns a frame without
/// eye_distances unchanged.
DepthFrame as_scene_eye_sees(const DepthFrame& frame);

/// Advice for a frame that shows surfaces, from its eye_distances if it has them. `budget`: mm on
/// either side of the sheet, > 0. The dpi is the lowest common printer resolution, finer than the
/// film's, at which the sharp share reaches a target: 95%, or the present share plus 9/10 of what
/// the highest resolution gains, if that is less. Empty if that resolution gains less than 0.01.
DepthAdvice depth_advice(const DepthFrame& frame, double budget);

} // namespace integral

#endif
