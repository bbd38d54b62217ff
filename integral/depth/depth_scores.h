// SPDX-License-Identifier: AGPL-3.0-or-later
// Scores of a depth map against the truth, as the toolkit of the HCI 4D Light Field Benchmark
// defines them (Honauer and others 2016): all in disparity, pixels from one view to the next.
#ifndef INTEGRAL_DEPTH_DEPTH_SCORES_H
#define INTEGRAL_DEPTH_DEPTH_SCORES_H

#include "integral/depth/multibaseline.h"
#include "integral/frame/depth_range.h"

namespace integral {

/// Errors (disparity) beyond which a pixel is bad.
constexpr double bad_limits[] = {0.07, 0.03, 0.01};

/// Scores of the pixels of one region; all 0 if it has no pixels.
struct RegionScores {
    std::size_t pixels = 0;
    double bad[3] = {}; ///< per cent of the pixels whose error is beyond bad_limits
    double mse = 0;     ///< 100 x mean squared error
    double lower = 0;   ///< Q25: 100 x the lower quartile of the absolute errors
};

struct DepthScores {
    RegionScores all;
    RegionScores edges;   ///< pixels within 3 pixels of a step of more than 0.1 in the truth: the
                          ///< toolkit's discontinuities
    RegionScores planes;  ///< not edges; the truth around (5 x 5 pixels) is flat
    double bumpiness = 0; ///< the toolkit's figure for planes: 100 x the mean Frobenius norm of the
                          ///< Hessian matrix of the errors, each norm at most 0.05
    RegionScores texture; ///< not edges; a shift by a pixel changes the colours around (5 x 5
                          ///< pixels) by more than 0.02 of full scale (rms)
};

/// Depths (mm behind the sheet) that an eye on the aperture's plane sees at the pixels of a set's
/// views: NaN where there is no light, infinite where there is no surface. Throws
/// std::invalid_argument if the depth frame's film and the frame's differ in size.
std::vector<float> depths_seen(const ViewSet& views, const FrameMetadata& frame,
                               const DepthFrame& depths, Vec2 eye);

/// The true disparities of a set's middle view, from the depth frame of its frame: each is that of
/// the film pixel that the middle eye sees there. NaN where there is no surface or light. Throws as
/// depths_seen.
std::vector<float> true_disparities(const ViewSet& views, const FrameMetadata& frame,
                                    const DepthFrame& depths);

/// The true disparities of a set's middle view from a quilt of depths (Integral_Quilt with
/// Integral_Depth_Image), which contains them. Throws std::invalid_argument if its views have
/// another size or its middle eye another place, or the set's scale is not known.
std::vector<float> true_disparities(const ViewSet& views, const DepthFrame& quilt);

/// Compares pixels that are finite in both maps and at least `border` pixels from the maps' sides.
DepthScores depth_scores(const ViewSet& views, const std::vector<float>& disparity,
                         const std::vector<float>& truth, int border);

} // namespace integral

#endif
