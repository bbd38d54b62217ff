// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the limits of depth for drawing near the sheet and near the eye.
#ifndef INTEGRAL_WIREFRAME_DEPTH_LIMITS_H
#define INTEGRAL_WIREFRAME_DEPTH_LIMITS_H

#include "integral/optics/lens_surface.h"
#include "integral/wireframe/wireframe.h"

#include <algorithm>

namespace integral {

/// Values of z, mm.
struct DepthLimits {
    double foremost; ///< things with a smaller z are not seen
    double near;     ///< things with |z| up to this cover the lens that they touch; 0: none
    double before;   ///< a point with z < -before is on the viewer's side of its lens
    double behind;   ///< a point with z > behind is behind its lens and the curved surface

    bool is_seen(double z) const { return z > foremost; }
    /// Whether a thing from z = least to most is seen, wholly before or wholly behind its lenses.
    bool is_far(double least, double most) const
    {
        return (least > behind || most < -before) && is_seen(least);
    }
};

inline DepthLimits depth_limits(const WireframeRequest& request)
{
    const SheetOptics& optics = request.optics;
    const double thickness = optics.sheet().thickness;
    DepthLimits limits;
    limits.foremost = request.pseudoscopic ? 0 : -0.999 * optics.aperture().distance;
    limits.near = optics.model() == LensModel::extended_pinhole ? thickness : 0;
    limits.before = limits.behind = std::max(limits.near, 1e-6 * thickness);
    const auto rim = tangent_plane(surface_radius(optics.sheet()), 0.5 * optics.sheet().pitch);
    if (refracts_at_surface(optics.model()) && rim)
        limits.behind += rim->height;
    return limits;
}

} // namespace integral

#endif
