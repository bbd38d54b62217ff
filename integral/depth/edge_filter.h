// SPDX-License-Identifier: AGPL-3.0-or-later
// Smooths planes of values within surfaces, not across their edges, which it detects by the colours
// of a picture.
#ifndef INTEGRAL_DEPTH_EDGE_FILTER_H
#define INTEGRAL_DEPTH_EDGE_FILTER_H

#include "integral/depth/view_set.h"

namespace integral {

struct EdgeFilterSettings {
    int across = 4, down = 4; ///< half-width of the filter, pixels; >= 0
    double colour = 0.12;     ///< difference of colour (distance in R, G, B of full scale 1) at
                              ///< which a neighbour's weight has fallen to 1/e
};

/// A joint bilateral filter of some rows, first down and then across.
class EdgeFilter {
public:
    /// Makes the filter of rows [first, first + rows) of the set's middle view.
    EdgeFilter(const ViewSet& views, int first, int rows, const EdgeFilterSettings& settings);

    /// Filters a plane of width x rows values in place. `other` is another such plane, whose values
    /// are lost.
    void apply(float* plane, float* other) const;

private:
    void weigh(const ViewSet& views, int first, int step_x, int step_y, double spatial,
               std::vector<float>& weights) const;

    int width_, rows_;
    EdgeFilterSettings settings_;
    std::vector<std::vector<float>> across_, down_; ///< weights of the 1st, 2nd ... neighbour on
                                                    ///< the right, or below; 0 outside
    std::vector<float> across_norm_, down_norm_;
};

/// Writes the weighted median of the values around each pixel to rows [first, last) of `to`. A
/// neighbour's weight falls with its difference of colour, and is multiplied by its entry in
/// `weight`. Pixels without weighted neighbours keep their value. `values`, `weight` and `to` are
/// planes of the whole view.
void weighted_median(const ViewSet& views, const std::vector<float>& values,
                     const std::vector<float>& weight, const EdgeFilterSettings& settings,
                     int first, int last, std::vector<float>& to);

} // namespace integral

#endif
