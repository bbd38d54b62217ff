// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses where the sheet stands in a scene, and how much parallax the scene gets, so that the
// scene's depth fits the sheet's budget (optics.md section 8, "Fit").
#ifndef INTEGRAL_LIGHTFIELD_SCENE_FIT_H
#define INTEGRAL_LIGHTFIELD_SCENE_FIT_H

#include <optional>
#include <vector>

namespace integral {

/// The near and the far end of nine tenths of a picture's depths: the 5th and the 95th percentile
/// of the distances from the scene's eye plane, in any unit. near > 0; far may be infinite.
struct DepthEnds {
    double near = 0, far = 0;
};

/// The ends of some distances (> 0; infinite where there is no surface). Nothing if all are
/// infinite, or if there are none.
std::optional<DepthEnds> depth_ends(std::vector<double> distances);

/// What is to be chosen, and what is given.
struct FitRequest {
    double beta = 0; ///< allowed depth (the budget times the number of budgets) by the viewing
                     ///< distance: > 0; at most 0.9 is used
    std::optional<double> sheet_distance, parallax; ///< given ones are kept
};

/// A sheet's distance from the scene's eye, in the unit of the depths, and a parallax.
struct SceneFit {
    double sheet_distance = 0, parallax = 1;
};

/// The fit of depths. With neither given, the ends are seen at the ends of the allowed depth, or,
/// where the scene is shallower than that, with parallax 1 and equally far from the sheet. With
/// sheet_distance given, the greatest parallax up to 1 that keeps both ends within; with parallax
/// given, the sheet from which both ends are seen equally far, or else that which keeps the near
/// end within. A given parallax may be more than 1: what is then seen beyond infinity counts as
/// infinitely far. A single depth is put on the sheet, with parallax 1.
SceneFit fit_to_budget(const DepthEnds& ends, const FitRequest& request);

/// The depth, by the viewing distance, at which a distance from the eye plane is seen: negative
/// before the sheet. Infinite at the viewer's infinity and beyond.
double seen_depth(const SceneFit& fit, double distance);

/// The part of some distances that is seen within -beta to beta.
double part_within(const SceneFit& fit, const std::vector<double>& distances, double beta);

} // namespace integral

#endif
