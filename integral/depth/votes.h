// SPDX-License-Identifier: AGPL-3.0-or-later
// How many views agree that a pixel of the middle one has a disparity.
#ifndef INTEGRAL_DEPTH_VOTES_H
#define INTEGRAL_DEPTH_VOTES_H

#include "integral/depth/view_set.h"

namespace integral {

struct VoteSettings {
    double tolerance = 0.2; ///< pixels: a view's colour may differ by what the texture changes
                            ///< over so much of a shift ...
    double noise = 0.006;   ///< ... and by that, as a distance in R, G, B of full scale 1
    bool halves = true; ///< of the views to the left, right, above and below, count the half that
                        ///< agrees best, as an edge hides a point from the others
    bool cross = false; ///< only views (about) to the left, right, above and below vote
};

/// Whether a view of that shift is in the cross of those: its eye less than one step from the
/// middle's row or column (half a step, in grids with no eye in the middle).
bool is_in_cross(Vec2 shift);

/// Pixels [first, last) of a row or a column.
struct PixelRange {
    int first, last;
};

/// Counts votes. A view votes for a disparity of a pixel if it has, where the point would then be,
/// nearly the pixel's colour: its vote falls from 1 for the same colour to 0 for one that differs
/// by what the settings allow. Views that do not show that place, or have no light there, do not
/// count.
class Votes {
public:
    /// The views must outlive this.
    Votes(const ViewSet& views, const VoteSettings& settings);

    /// The mean vote of each pixel of rows [first, first + rows) for a disparity: width x rows
    /// values from 0 to 1. May be called by several threads.
    void count(double disparity, int first, int rows, float* mean) const;

private:
    struct Sums;
    void vote(const DepthView& view, double disparity, int y, const PixelRange& columns,
              Sums& sums) const;
    void add_view(const DepthView& view, double disparity, int y, Sums& sums) const;
    void finish_row(const Sums& sums, float* mean) const;

    const ViewSet& views_;
    VoteSettings settings_;
    int views_used_ = 0, views_in_half_[4] = {};
    std::vector<float> sharpness_; ///< 1 / squared difference that is allowed, of each pixel
    std::vector<float> ones_;      ///< a row of them
};

} // namespace integral

#endif
