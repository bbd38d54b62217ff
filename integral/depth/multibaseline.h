// SPDX-License-Identifier: AGPL-3.0-or-later
// Depth by multiple-baseline correlation (thesis 5.4.4, after Okutomi and Kanade): one search for
// all views, in disparity, which is the same for all of them.
#ifndef INTEGRAL_DEPTH_MULTIBASELINE_H
#define INTEGRAL_DEPTH_MULTIBASELINE_H

#include "integral/depth/disparity_search.h"

namespace integral {

struct MultibaselineSettings {
    std::optional<DisparityRange> range; ///< to search; nothing: find it
    double step = 0.16; ///< between disparities that are tried: pixels of the farthest view
    VoteSettings votes;
    EdgeFilterSettings filter, median;
    double reach = 40; ///< pixels within a surface over which sure pixels tell unsure ones; 0: none
};

/// The range in which most of the pixels are that can be told: from sparse rows, between -4 and 4
/// pixels, or that where few can be told. Where it reaches an end of that, the range is up to 16
/// pixels in front, and behind to where nothing has an end (at most 16).
DisparityRange find_range(const ViewSet& views, const VoteSettings& votes, int threads);

/// Measures the middle view's depth. `threads` and `progress` as in for_each_row. Nothing:
/// `progress` stopped it.
std::optional<DepthMap> multibaseline(const ViewSet& views, const MultibaselineSettings& settings,
                                      int threads, const Progress& progress);

} // namespace integral

#endif
