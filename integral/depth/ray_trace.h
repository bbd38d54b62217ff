// SPDX-License-Identifier: AGPL-3.0-or-later
// Depth by reversed ray tracing (thesis 5.4.3, method A): a point of the scene may lie where rays
// of different lenses' pixels with the same colour meet.
#ifndef INTEGRAL_DEPTH_RAY_TRACE_H
#define INTEGRAL_DEPTH_RAY_TRACE_H

#include "integral/depth/multibaseline.h"

namespace integral {

struct RayTraceSettings {
    DisparityRange range{-2, 2}; ///< searched for points
    int bins = 81;               ///< equal parts of the range, in which meetings are counted; > 0
    double colour = 0.04;        ///< rays whose colours differ by less (distance in R, G, B of full
                                 ///< scale 1) are taken for rays of one point
};

/// Finds the disparity of each pixel of the middle view: the one at which its ray meets the rays of
/// most pixels of other views with the same colour; in a tie, the one nearest to the sheet. The
/// confidence is the share of the views whose rays meet there. Like the thesis's method, it treats
/// each pixel by itself and does not interpolate between pixels. So rays of different points with
/// similar colours meet too; such "ghost" points crowd near the sheet. `threads` and `progress` as
/// in for_each_row. Returns nothing if `progress` stopped the work.
std::optional<DepthMap> ray_trace(const ViewSet& views, const RayTraceSettings& settings,
                                  int threads, const Progress& progress);

} // namespace integral

#endif
