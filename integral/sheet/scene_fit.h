// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the sheet's position in a scene and the scene's parallax, so that the scene's depth fits
// the sheet's budget (optics.md section 8, "Fit").
#ifndef INTEGRAL_SHEET_SCENE_FIT_H
#define INTEGRAL_SHEET_SCENE_FIT_H

#include <optional>
#include <vector>

namespace integral {

/// Near and far end of nine tenths of a picture's depths: the 5th and the 95th percentile of the
/// distances from the scene's eye plane, in any unit. near > 0; far may be infinite.
struct DepthEnds {
    double near = 0, far = 0;
};

/// The ends of distances (> 0; infinite where there is no surface). Empty if all are infinite, or
/// if there are none.
std::optional<DepthEnds> depth_ends(std::vector<double> distances);

/// Limits of a fit, and the values that are fixed.
struct FitRequest {
    double beta = 0; ///< allowed depth (the budget times the number of budgets) divided by the
                     ///< viewing distance: > 0; at most 0.9 is used
    std::optional<double> sheet_distance, parallax; ///< fixed if given
};

/// A sheet's distance from the scene's eye, in the unit of the depths, and a parallax.
struct SceneFit {
    double sheet_distance = 0, parallax = 1;
};

/// Fits depths to the budget. With neither value fixed, near and far are seen at the limits of the
/// allowed depth; a shallower scene gets parallax 1, with near and far equally far from the sheet
/// (a single depth on it). For a fixed sheet_distance, chooses the greatest parallax up to 1 that
/// keeps near and far within the limits. For a fixed parallax, chooses the sheet_distance at which
/// near and far are seen equally far from the sheet; if there is none, near is put on its limit. A
/// fixed parallax may exceed 1: points seen beyond infinity count as infinitely far.
SceneFit fit_to_budget(const DepthEnds& ends, const FitRequest& request);

/// Depth, divided by the viewing distance, at which a distance from the eye plane is seen: negative
/// before the sheet, infinite at the viewer's infinity and beyond.
double seen_depth(const SceneFit& fit, double distance);

/// The share of the distances that is seen within -beta to beta.
double part_within(const SceneFit& fit, const std::vector<double>& distances, double beta);

} // namespace integral

#endif
