// SPDX-License-Identifier: AGPL-3.0-or-later
// Scores of a depth map against the truth, as the toolkit of the HCI 4D Light Field Benchmark
// defines them (Honauer and others 2016): all in disparity, pixels from one view to the next.
#ifndef INTEGRAL_DEPTH_DEPTH_SCORES_H
#define INTEGRAL_DEPTH_DEPTH_SCORES_H

#include "integral/depth/multibaseline.h"
#include "integral/lightfield/depth_range.h"

namespace integral {

/// Errors beyond which a pixel is bad.
constexpr double bad_limits[] = {0.07, 0.03, 0.01};

/// Figures of some of the pixels; all 0 if there are none.
struct RegionScores {
    std::size_t pixels = 0;
    double bad[3] = {}; ///< per cent of the pixels whose error is beyond bad_limits
    double mse = 0;     ///< 100 x mean squared error
    double lower = 0;   ///< Q25: 100 x the error that a quarter of the pixels do not reach
};

struct DepthScores {
    RegionScores all;
    RegionScores edges;   ///< within 3 pixels of a step of the truth of more than 0.1: the
                          ///< toolkit's discontinuities
    RegionScores planes;  ///< where the truth is flat, two pixels around, and no edge is near
    double bumpiness = 0; ///< the toolkit's of planes: 100 x the mean Frobenius norm of the errors'
                          ///< Hessian matrix, each at most 0.05
    RegionScores texture; ///< where a shift of a pixel changes the colours around (5 x 5 pixels) by
                          ///< more than 0.02 of full scale, and no edge is near
};

/// The depths (mm behind the sheet) of what an eye on the aperture's plane sees at the pixels of a
/// set's views, from a depth frame: NaN where there is no light, infinite where no surface. Throws
/// std::invalid_argument if the depth frame is of another frame.
std::vector<float> depths_seen(const ViewSet& views, const FrameMetadata& frame,
                               const DepthFrame& depths, Vec2 eye);

/// The true disparities of a set's middle view, from the depth frame of the frame that the set was
/// made of: what the nearest film pixel of each lens says. NaN where there is no surface or no
/// light. Throws std::invalid_argument if it is of another frame.
std::vector<float> true_disparities(const ViewSet& views, const FrameMetadata& frame,
                                    const DepthFrame& depths);

/// Compares the pixels that are finite in both maps and at least `border` pixels from the edges.
DepthScores depth_scores(const ViewSet& views, const std::vector<float>& disparity,
                         const std::vector<float>& truth, int border);

} // namespace integral

#endif
