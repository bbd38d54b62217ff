// SPDX-License-Identifier: AGPL-3.0-or-later
// What would bring more of a scene within the depth budget of its sheet and film, and how much of
// it each change would.
#ifndef INTEGRAL_LIGHTFIELD_DEPTH_ADVICE_H
#define INTEGRAL_LIGHTFIELD_DEPTH_ADVICE_H

#include "integral/lightfield/depth_range.h"
#include "integral/lightfield/scene_fit.h"

#include <optional>
#include <vector>

namespace integral {

/// Soft: farther from the sheet than the budget, but at most this many times as far; beyond: still
/// farther. At the budget the pixels resolve as much as the lenses, at the end of soft half of it.
constexpr double soft_budgets = 2;

/// The parts of a picture that are sharp, soft and beyond. Their sum is 1. What shows no surface
/// counts where its infinity is seen; what parallax over 1 puts beyond the viewer's infinity counts
/// as infinitely far. Of a frame without eye_distances these are parts of its surfaces.
struct DepthShares {
    double sharp = 0, soft = 0, beyond = 0;
};

/// The sheet and the parallax that a frame has; its sheet_distance in scene units.
SceneFit fit_of(const FrameMetadata& metadata);

/// One change: the new value, and the part of the picture that would be sharp then.
struct DepthRemedy {
    double value = 0, sharp = 0;
};

/// The fit to a number of depth budgets, and what it would make of the picture.
struct FitAdvice {
    double budgets = 1;
    SceneFit fit; ///< its sheet_distance in scene units
    DepthShares shares;
};

/// What to do for a depth frame.
struct DepthAdvice {
    DepthShares now;
    std::vector<FitAdvice> fits;     ///< to 1 and to 2 budgets; none without a placement
    std::optional<DepthRemedy> dpi; ///< of a printer; none for panels
};

/// The depths that the scene's eye sees through the sheet, as a frame of so many pixels in a row.
/// The pixels of a frame see the scene from the whole aperture, in which an open floor, for
/// example, is nearer to some than the fit assumes. A frame without eye_distances is returned as it
/// is.
DepthFrame as_scene_eye_sees(const DepthFrame& frame);

/// The advice for a frame that shows surfaces, by eye_distances where it has them. `budget`: mm on
/// either side of the sheet, > 0. The film is the coarsest with which 95% are sharp, or else nearly
/// as much as can be; one that does not make at least a hundredth of the picture sharp that was not
/// is left out.
DepthAdvice depth_advice(const DepthFrame& frame, double budget);

} // namespace integral

#endif
