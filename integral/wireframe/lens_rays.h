// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes how each lens model spreads a scene point's light on the film (thesis 3.4, figures 3-16
// to 3-20).
#ifndef INTEGRAL_WIREFRAME_LENS_RAYS_H
#define INTEGRAL_WIREFRAME_LENS_RAYS_H

#include "integral/optics/beam.h"

#include <array>
#include <vector>

namespace integral {

/// A picture of the scene through each lens, as sharp as a pinhole's. The frame is the weighted
/// mean, in linear light, of one or more such pictures.
struct SharpPicture {
    double weight = 1;
    /// Weights of the bundle's rays: a scene point is shown at the weighted mean of their film
    /// points.
    std::array<double, 5> share{1, 0, 0, 0, 0};
    LensPoint through; ///< the lens point through which the picture shows faces
};

/// Rays from a scene point through one lens, and the pictures that follow from them.
struct RayBundle {
    std::vector<LensPoint> rays; ///< one to five
    std::vector<SharpPicture> pictures;
};

/// The rays of a lens model. The weights of all pictures add up to 1.
///
/// pinhole, extended_pinhole: one ray, through the pole (figures 3-11, 3-23). full: `samples`
/// points of the lens's cell, with a ray and a picture for each (3-16). hybrid: three (lenticular)
/// or five rays, through the pole and the margins; a scene point's light is spread between the
/// rays' film points by I(v) = cos(atan 4v), from v = 0 at the pole's ray to v = 1 at a marginal
/// ray (3-17 to 3-19), represented by `samples` values of v.
std::vector<RayBundle> bundles_of(const SheetOptics& optics, int samples);

} // namespace integral

#endif
