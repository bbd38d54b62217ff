// SPDX-License-Identifier: AGPL-3.0-or-later
// Depth by multiple-baseline correlation (thesis 5.4.4, after Okutomi and Kanade): one search over
// disparities uses all views, as a point's disparity is the same in all of them.
#ifndef INTEGRAL_DEPTH_MULTIBASELINE_H
#define INTEGRAL_DEPTH_MULTIBASELINE_H

#include "integral/depth/disparity_search.h"

namespace integral {

struct MultibaselineSettings {
    std::optional<DisparityRange> range; ///< to search; nothing: find it
    double step = 0.24; ///< between tried disparities: a point's movement in the farthest view, px
    VoteSettings votes;
    EdgeFilterSettings filter{5, 5, 0.12}, median;
    double reach = 160; ///< pixels over which depth is filled within a surface (fill_surfaces); 0:
                        ///< not
};

/// Searches some rows for disparities from -4 to 4, and returns the range of nearly all confident
/// pixels. If these are fewer than 20, or their range reaches -4 or 4, the range is wider: from
/// infinity's (-16 if infinity's is less or not known) to the nearest surface's (4 to about 16).
DisparityRange find_range(const ViewSet& views, const VoteSettings& votes, int threads);

/// Measures the middle view's depth. `threads` and `progress` as in for_each_row. Returns nothing
/// if `progress` stopped the work.
std::optional<DepthMap> multibaseline(const ViewSet& views, const MultibaselineSettings& settings,
                                      int threads, const Progress& progress);

} // namespace integral

#endif
