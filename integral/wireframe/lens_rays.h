// SPDX-License-Identifier: AGPL-3.0-or-later
// How each lens model spreads a scene point's light on the film (thesis 3.4, figures 3-16 to 3-20).
#ifndef INTEGRAL_WIREFRAME_LENS_RAYS_H
#define INTEGRAL_WIREFRAME_LENS_RAYS_H

#include "integral/optics/beam.h"

#include <array>
#include <vector>

namespace integral {

/// A picture of the scene through each lens, as sharp as a pinhole's. The frame is the weighted
/// mean, in linear light, of one or more of them.
struct SharpPicture {
    double weight = 1;
    /// Where it shows a scene point, as a weighted mean of the film points of the bundle's rays.
    std::array<double, 5> share{1, 0, 0, 0, 0};
    LensPoint through; ///< the point of the lens through which it shows faces
};

/// Rays from a scene point through one lens, and the pictures that follow from them.
struct RayBundle {
    std::vector<LensPoint> rays; ///< one to five
    std::vector<SharpPicture> pictures;
};

/// The rays of a lens model. The weights of all pictures add up to 1.
///
/// pinhole, extended_pinhole: one ray, through the pole (figures 3-11, 3-23). full: `samples`
/// points of the lens's cell, a ray and a picture for each (3-16). hybrid: rays through the pole
/// and the margins, three (lenticular) or five; a point's light is spread between where they meet
/// the film by I(v) = cos(atan 4v), v from 0 at the pole's to 1 at a marginal ray's (3-17 to 3-19),
/// which `samples` values of v stand for.
std::vector<RayBundle> bundles_of(const SheetOptics& optics, int samples);

} // namespace integral

#endif
