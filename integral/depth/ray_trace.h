// SPDX-License-Identifier: AGPL-3.0-or-later
// Depth by reversed ray tracing (thesis 5.4.3, method A): where the rays of lenses' pixels with the
// same colour meet, there may be a point.
#ifndef INTEGRAL_DEPTH_RAY_TRACE_H
#define INTEGRAL_DEPTH_RAY_TRACE_H

#include "integral/depth/multibaseline.h"

namespace integral {

struct RayTraceSettings {
    DisparityRange range{-2, 2}; ///< where points are looked for
    int bins = 81;               ///< equal parts of it, in which meetings are counted; > 0
    double colour = 0.04;        ///< rays whose colours (distance in R, G, B of full scale 1) are
                                 ///< nearer than that are taken for rays of one point
};

/// For each pixel of the middle view, the disparity at which its ray meets most rays of other
/// views' pixels that have its colour; of equal ones the nearest to the sheet. Confidence is the
/// share of the views that meet it there. Like the thesis's, the method takes each pixel by itself
/// and nothing between pixels, so that rays of unlike points of like colour meet too: its "ghost"
/// points crowd near the sheet. `threads` and `progress` as in for_each_row. Nothing: `progress`
/// stopped it.
std::optional<DepthMap> ray_trace(const ViewSet& views, const RayTraceSettings& settings,
                                  int threads, const Progress& progress);

} // namespace integral

#endif
