// SPDX-License-Identifier: AGPL-3.0-or-later
// Counts the views that agree on a disparity of a pixel of the middle view.
#ifndef INTEGRAL_DEPTH_VOTES_H
#define INTEGRAL_DEPTH_VOTES_H

#include "integral/depth/view_set.h"

namespace integral {

struct VoteSettings {
    double tolerance = 0.2; ///< pixels: a view's colour may differ by as much as a shift of the
                            ///< texture by this changes it ...
    double noise = 0.003;   ///< ... and by this, a distance in R, G, B of full scale 1
    bool halves = true; ///< take the best mean vote of all views and of the left, right, upper and
                        ///< lower half of them: an edge hides a point from some halves alone
    bool cross = false; ///< only views (about) to the left, right, above and below count
};

/// Whether a view with that shift votes if VoteSettings::cross is set: it stands in the middle
/// view's row or column (or half a step off, in grids with no eye in the middle).
bool is_in_cross(Vec2 shift);

/// Pixels [first, last) of a row or a column.
struct PixelRange {
    int first, last;
};

/// Counts votes. A view votes for a disparity of a pixel if its colour, at the place where a point
/// of that disparity appears, is close to the pixel's: its vote falls from 1 for the same colour to
/// 0 for the difference that the settings allow. Views that do not show that place, or have no
/// light there, do not count.
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
    std::vector<float> sharpness_; ///< 1 / allowed squared difference of each pixel
    std::vector<float> ones_;      ///< a row of ones
};

} // namespace integral

#endif
