// SPDX-License-Identifier: AGPL-3.0-or-later
// How near to the sheet and to the eye points are drawn, and how.
#ifndef INTEGRAL_WIREFRAME_DEPTH_LIMITS_H
#define INTEGRAL_WIREFRAME_DEPTH_LIMITS_H

#include "integral/optics/lens_surface.h"
#include "integral/wireframe/wireframe.h"

#include <algorithm>

namespace integral {

/// Values of z, mm.
struct DepthLimits {
    double foremost; ///< in front of it nothing is seen
    double near;     ///< |z| up to which what is next to a lens covers it; 0: never
    double before;   ///< a point in front of -before is before its lens
    double behind;   ///< and beyond this behind it and its curved surface

    bool is_seen(double z) const { return z > foremost; }
    /// Whether all of a line or a face is seen and before its lenses, or all of it behind them.
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
