// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds, for each pixel, the disparity on which most views agree.
#ifndef INTEGRAL_DEPTH_DISPARITY_SEARCH_H
#define INTEGRAL_DEPTH_DISPARITY_SEARCH_H

#include "integral/depth/edge_filter.h"
#include "integral/depth/votes.h"

namespace integral {

/// Disparities from least to greatest.
struct DisparityRange {
    double least = 0, greatest = 0;
};

/// The depth of the middle view of a set, row by row.
struct DepthMap {
    int width = 0, height = 0;
    std::vector<float> disparity;  ///< NaN for a pixel without light
    std::vector<float> confidence; ///< 0 to 1: the best disparity's vote minus the average vote
    DisparityRange range;          ///< searched
};

/// A map of the set's size, all 0.
DepthMap blank_map(const ViewSet& views);

/// The disparities to try, at least three.
struct Labels {
    Labels(DisparityRange range, double wanted_step);
    double at(double label) const { return first + label * step; }
    double first;
    int count;
    double step;
};

/// Tries all labels, smooths their mean votes within areas of similar colour, and takes the best.
class Search {
public:
    /// The views and the votes must outlive this.
    Search(const ViewSet& views, const Votes& votes, const EdgeFilterSettings& filter,
           const Labels& labels);

    /// Writes rows [first, last) of the map.
    void rows(int first, int last, DepthMap& map) const;

    /// Writes all rows. `threads`, `progress` and the result as in for_each_row.
    bool all_rows(int threads, DepthMap& map, const Progress& progress) const;

private:
    const ViewSet& views_;
    const Votes& votes_;
    EdgeFilterSettings filter_;
    Labels labels_;
};

} // namespace integral

#endif
