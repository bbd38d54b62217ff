// SPDX-License-Identifier: AGPL-3.0-or-later
// The lenses' curved surface: its intersection with a line, and refraction there from the film side
// to the viewer's side and back.
//
// A lens's surface is z = R - sqrt(R^2 - v^2), where v is the distance from the pole (or from a
// cylinder's axis): its pole is the foremost point, at z = 0, and its edges lie deeper, towards the
// film. At each of its points there are three perpendicular directions: b, lateral, along which v
// is measured; a, lateral; and z. The surface's normal has no component along a. On a cylinder, a
// is the direction of the axis.
#ifndef INTEGRAL_OPTICS_LENS_SURFACE_H
#define INTEGRAL_OPTICS_LENS_SURFACE_H

#include "integral/optics/lens_model.h"
#include "integral/optics/refraction.h"

namespace integral {

/// The plane that touches a lens's surface at a point. Its normal, towards the viewer, is
/// (sine, -cosine) in the directions (b, z). By default the plane of the poles.
struct TangentPlane {
    double v = 0;                ///< mm from the pole (axis), along b
    double height = 0;           ///< z of the point, mm; >= 0
    double sine = 0, cosine = 1; ///< v/R and sqrt(1 - (v/R)^2)
};

/// The tangent plane at v; empty if there is no surface: |v| > R by more than rounding.
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

/// The vector from a film point to a point of the surface, mm, as components in the plane of b and
/// z.
struct Incidence {
    double tangential; ///< in the tangent plane: along (cosine, sine) in the directions (b, z)
    double normal;     ///< along the normal; > 0 if the film point is on the inner side
};

/// `reach`: component of the vector along b, mm.
inline Incidence incidence(const Medium& medium, const TangentPlane& plane, double reach)
{
    const double depth = medium.t - plane.height;
    return {reach * plane.cosine - depth * plane.sine, reach * plane.sine + depth * plane.cosine};
}

/// L^2 (1 - n^2 sin^2 i), where i is the angle of incidence and L the length of the vector from the
/// film point, whose component along a is `along`. Equals `clearance` of refraction.h with the
/// normal component in place of the thickness.
inline double clearance(const Medium& medium, Incidence way, double along)
{
    Medium turned = medium;
    turned.t = way.normal;
    return clearance(turned, {way.tangential, along});
}

/// The refracted ray, L times its unit direction, in the directions (b, a, z), for a clearance > 0
/// whose square root is `root`. By Snell's law its components in the tangent plane are n times
/// the components of the vector from the film point.
inline Vec3 refracted(const Medium& medium, const TangentPlane& plane, Incidence way, double along,
                      double root)
{
    const double tangential = medium.n * way.tangential;
    return {tangential * plane.cosine + root * plane.sine, medium.n * along,
            tangential * plane.sine - root * plane.cosine};
}

/// Inverse: the lateral vector (mm, in the directions b and a) from the film point whose light
/// leaves in `direction` (unit, in the directions (b, a, z)) to the point of the surface. Empty if
/// that direction is not on the outer side.
inline std::optional<Vec2> way_refracted_into(const Medium& medium, const TangentPlane& plane,
                                              Vec3 direction)
{
    const double normal = direction.x * plane.sine - direction.z * plane.cosine;
    if (!(normal > 0))
        return std::nullopt;
    // n times the inner direction is the outer direction plus `bend` times the normal.
    const double bend = medium.m / (std::sqrt(medium.m + normal * normal) + normal);
    const double stretch = (medium.t - plane.height) / (bend * plane.cosine - direction.z);
    return Vec2{stretch * (direction.x + bend * plane.sine), stretch * direction.y};
}

/// An intersection of a line with a lens's surface.
struct SurfacePoint {
    double depth; ///< z, mm
    Vec2 offset;  ///< mm from the pole; lenticular: from the axis, perpendicular to it
};

/// The surface of a whole sheet: the foremost parts of all its lenses' balls (lenticular:
/// cylinders). Immutable.
class SheetSurface {
public:
    explicit SheetSurface(const LensSheet& sheet);

    /// The first point where the line through `point`, in the plane of the poles, enters a lens.
    /// `slope`: mm to the side per mm of depth. Empty if it enters no lens.
    std::optional<SurfacePoint> first_intersection(Vec2 point, Vec2 slope) const;

    /// The film point that is seen along such a line, which is refracted where it enters a lens.
    /// The film is `film_gap` mm behind the lenses' focus. Empty if no light comes that way.
    std::optional<Vec2> film_point_seen(Vec2 point, Vec2 slope, double film_gap) const;

private:
    std::optional<SurfacePoint> intersection(LensIndex lens, Vec2 point, Vec2 slope) const;

    Lattice lattice_;
    Medium medium_;
    double radius_;  ///< R, mm
    double reach_;   ///< radius of a lens's cell, mm
    double deepest_; ///< z of the cells' corners, mm; 0 if the surface does not extend to them
};

} // namespace integral

#endif
