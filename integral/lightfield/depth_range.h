// SPDX-License-Identifier: AGPL-3.0-or-later
// How deep a scene reaches, against what its sheet and film can show.
#ifndef INTEGRAL_LIGHTFIELD_DEPTH_RANGE_H
#define INTEGRAL_LIGHTFIELD_DEPTH_RANGE_H

#include "integral/lightfield/frame_metadata.h"

#include <optional>
#include <vector>

namespace integral {

/// A depth frame: of each pixel, row by row, how far behind the sheet (negative: in front) the
/// first surface is that its viewer sees, mm; infinite where there is none. `imaged` is 0 where the
/// pixel images nothing, else 1.
struct DepthFrame {
    std::vector<float> depth, imaged;
    FrameMetadata metadata; ///< the frame's
};

/// Depths that imaged pixels show, mm behind the sheet; those of the pixels that show a surface.
struct DepthRange {
    std::size_t pixels = 0;   ///< imaged
    std::size_t surfaces = 0; ///< of these, pixels that show a surface; the following are 0 where
                              ///< there is none
    double nearest = 0, low = 0, median = 0, high = 0,
           farthest = 0;           ///< low and high: a hundredth is nearer, or farther
    double before = 0, behind = 0; ///< parts of `surfaces` nearer, or farther, than the budget
};

/// `budget`: mm on either side of the sheet (depth_budget of sheet_figures.h); nothing: every depth
/// is within.
DepthRange depth_range(const DepthFrame& frame, std::optional<double> budget);

} // namespace integral

#endif
