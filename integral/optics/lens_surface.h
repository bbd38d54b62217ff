// SPDX-License-Identifier: AGPL-3.0-or-later
// Refraction at a point of a lens's curved surface, film side -> viewer side and back.
//
// The surface is z = R - sqrt(R^2 - v^2), v being the distance from the pole (or from a cylinder's
// axis): its pole is the foremost point, at z = 0, and its edges lie deeper, towards the film.
// Everything is worked out in three perpendicular directions: b, lateral, in which v is counted; a,
// lateral; and z. The surface does not bend along a. On a cylinder a is its axis.
#ifndef INTEGRAL_OPTICS_LENS_SURFACE_H
#define INTEGRAL_OPTICS_LENS_SURFACE_H

#include "integral/optics/refraction.h"

namespace integral {

/// The plane that touches a lens's surface at a point. Its normal, towards the viewer, is
/// (sine, -cosine) in the directions (b, z). By default the plane of the poles.
struct TangentPlane {
    double v = 0;                ///< mm from the pole (axis), along b
    double height = 0;           ///< z of the point, mm; >= 0
    double sine = 0, cosine = 1; ///< v/R, and the root of 1 - (v/R)^2
};

/// Nothing where the surface does not reach: |v| > R (but for rounding).
inline std::optional<TangentPlane> tangent_plane(double radius, double v)
{
    if (v == 0)
        return TangentPlane{};
    const double far = std::fabs(v);
    if (!(far <= radius * (1 + 1e-12)))
        return std::nullopt;
    const double rise = far < radius ? std::sqrt((radius - far) * (radius + far)) : 0;
    return TangentPlane{v, v * (v / (radius + rise)), v / radius, rise / radius};
}

/// The way from a film point to the point of the surface, in directions that lie along and across
/// the tangent plane. Both in mm.
struct Incidence {
    double tangential; ///< along (cosine, sine) in the directions (b, z)
    double normal;     ///< along the normal; > 0 where the film point is on the inner side
};

/// `reach`: the component of that way along b, mm.
inline Incidence incidence(const Medium& medium, const TangentPlane& plane, double reach)
{
    const double depth = medium.t - plane.height;
    return {reach * plane.cosine - depth * plane.sine, reach * plane.sine + depth * plane.cosine};
}

/// L^2 (1 - n^2 sin^2 i), i the angle of incidence and L the length of a way from the film whose
/// component along a is `along`: `clearance` with the normal component in place of the thickness.
inline double clearance(const Medium& medium, Incidence way, double along)
{
    Medium turned = medium;
    turned.t = way.normal;
    return clearance(turned, {way.tangential, along});
}

/// The refracted ray, L times its unit direction, in the directions (b, a, z), for a clearance > 0
/// whose square root is `root`. The components along the plane, n times the way's, are what Snell's
/// law conserves.
inline Vec3 refracted(const Medium& medium, const TangentPlane& plane, Incidence way, double along,
                      double root)
{
    const double tangential = medium.n * way.tangential;
    return {tangential * plane.cosine + root * plane.sine, medium.n * along,
            tangential * plane.sine - root * plane.cosine};
}

/// Inverse: the way (mm, in the directions b and a) from the film to the point whose light leaves
/// it in `direction` (unit, in the directions (b, a, z)). Nothing if that direction is not on the
/// outer side.
inline std::optional<Vec2> way_refracted_into(const Medium& medium, const TangentPlane& plane,
                                              Vec3 direction)
{
    const double normal = direction.x * plane.sine - direction.z * plane.cosine;
    if (!(normal > 0))
        return std::nullopt;
    // n times the inner direction is the outer one plus `bend` times the normal.
    const double bend = medium.m / (std::sqrt(medium.m + normal * normal) + normal);
    const double stretch = (medium.t - plane.height) / (bend * plane.cosine - direction.z);
    return Vec2{stretch * (direction.x + bend * plane.sine), stretch * direction.y};
}

} // namespace integral

#endif
