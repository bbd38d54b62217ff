// SPDX-License-Identifier: AGPL-3.0-or-later
// What would bring more of a scene within the depth budget of its sheet and film, and how much of
// it each change would.
#ifndef INTEGRAL_LIGHTFIELD_DEPTH_ADVICE_H
#define INTEGRAL_LIGHTFIELD_DEPTH_ADVICE_H

#include "integral/lightfield/depth_range.h"

#include <optional>

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

/// What to do for a depth frame. Changes that do not make at least a hundredth of the surfaces
/// sharp that were not are left out.
struct DepthAdvice {
    DepthShares now;
    double sheet_distance = 0;           ///< scene units, as it is
    std::optional<DepthRemedy> sheet;    ///< another sheet_distance, scene units
    std::optional<DepthRemedy> compress; ///< depths about the sheet times this, 0.25 to 0.95
    std::optional<DepthRemedy> dpi;      ///< of a printer; none for panels
};

/// The advice for a frame that shows surfaces. `budget`: mm on either side of the sheet, > 0.
/// Compression and film are the least with which 95% are sharp, or else nearly as much as can be.
DepthAdvice depth_advice(const DepthFrame& frame, double budget);

} // namespace integral

#endif
