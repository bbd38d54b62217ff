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

/// The parts of the surfaces in a picture that are sharp, soft and beyond. Their sum is 1.
struct DepthShares {
    double sharp = 0, soft = 0, beyond = 0;
};

/// One change: the new value, and the part of the surfaces that would be sharp then.
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

/// The advice for a frame that shows surfaces. `budget`: mm on either side of the sheet, > 0. The
/// film is the coarsest with which 95% are sharp, or else nearly as much as can be; one that does
/// not make at least a hundredth of the surfaces sharp that were not is left out.
DepthAdvice depth_advice(const DepthFrame& frame, double budget);

} // namespace integral

#endif
