// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares the range of depths in a scene with the depth that its sheet and film can resolve.
#ifndef INTEGRAL_FRAME_DEPTH_RANGE_H
#define INTEGRAL_FRAME_DEPTH_RANGE_H

#include "integral/frame/frame_metadata.h"

#include <optional>
#include <vector>

namespace integral {

/// A depth frame, one value per pixel, row by row. `depth`: distance behind the sheet of the first
/// surface that the pixel shows, mm (negative: in front), infinite if it shows no surface.
/// `imaged`: 1 for a pixel that a lens images, else 0.
struct DepthFrame {
    std::vector<float> depth, imaged;
    FrameMetadata metadata; ///< of the colour frame
    /// Surfaces visible from the scene's own eye (Parallax), at places spread evenly over the
    /// picture: distances (scene units, > 0) from the plane of this eye, infinite where there is no
    /// surface. Integral_Fit uses them. Empty: not known.
    std::vector<float> eye_distances = {};
};

/// Statistics of the depths in a frame, mm behind the sheet.
struct DepthRange {
    std::size_t pixels = 0;   ///< number of imaged pixels
    std::size_t surfaces = 0; ///< number of imaged pixels that show a surface. If this is 0, all
                              ///< fields below are 0.
    double nearest = 0, twentieth = 0, median = 0, last_twentieth = 0,
           farthest = 0;           ///< twentieths: the 5th and the 95th percentile
    double before = 0, behind = 0; ///< fractions of `surfaces` in front of the budget, or behind it
};

/// The statistics of a depth frame. `budget`: mm on either side of the sheet (depth_budget of
/// sheet_figures.h); without one, `before` and `behind` are 0.
DepthRange depth_range(const DepthFrame& frame, std::optional<double> budget);

} // namespace integral

#endif
