// SPDX-License-Identifier: AGPL-3.0-or-later
// First derivatives of a film point's pole ray: how it moves with the film point and along the
// slit. They give the beam of all points of a pixel from the ray of the pixel's centre.
#ifndef INTEGRAL_OPTICS_RAY_GRADIENT_H
#define INTEGRAL_OPTICS_RAY_GRADIENT_H

#include "integral/optics/lens_mapping.h"

namespace integral {

/// Movement of the two points that determine a pole ray: where it leaves the sheet
/// (LensRay::pole), and where it meets the aperture plane (LensRay::aperture_point). mm per mm.
struct RayShift {
    Vec2 pole, aperture;
};

struct RayGradient {
    RayShift x, y; ///< per mm of the film point along the sheet frame's x and y
    RayShift slit; ///< lenticular: per mm of the slit's height (signed_height); else 0
};

/// The derivatives of `ray`, which is the pole ray of `film_point` through one given lens.
RayGradient ray_gradient(const SheetOptics& optics, Vec2 film_point, const LensRay& ray);

} // namespace integral

#endif
