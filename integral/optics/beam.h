// SPDX-License-Identifier: AGPL-3.0-or-later
// The rays of a film point's light where it leaves its lens, for every lens model; and the film
// point that images a given scene point.
#ifndef INTEGRAL_OPTICS_BEAM_H
#define INTEGRAL_OPTICS_BEAM_H

#include "integral/optics/lens_mapping.h"

namespace integral {

/// One ray of a film point's light beyond its lens. Sheet frame, mm.
struct BeamRay {
    Vec3 point;     ///< exit from the lens: on the plane of the poles (z = 0) or the lens's surface
    Vec3 direction; ///< unit, towards the viewer (z < 0)
    Vec2 aperture_point; ///< intersection with the aperture plane z = -distance
};

/// The pole ray as a ray of the beam.
inline BeamRay pole_beam(const LensRay& ray)
{
    return {{ray.pole.x, ray.pole.y, 0}, ray.direction, ray.aperture_point};
}

/// The ray of `film_point` through a point of a lens, by the sheet's lens model. This ray need not
/// pass the aperture: only the pole ray decides whether a film point is imaged.
///
/// pinhole, extended_pinhole: the ideal parallel beam, that is the pole ray shifted sideways by the
/// point's offset. If point.slit is not 0, the ray to that height of the slit is shifted instead.
/// hybrid, full: the straight line from the film point to the surface z = R - sqrt(R^2 - r^2) at
/// the offset, refracted there by Snell's law. At one offset, a lenticular lens's surface is a
/// straight line; the light leaves the lens at that point of the line from which it reaches the
/// slit, e.A = slit.
///
/// Empty if the light is totally reflected at the surface, leaves away from the viewer, or cannot
/// reach the slit. The possibility that a neighbouring lens's edge is in the way is neglected.
std::optional<BeamRay> beam_ray(const SheetOptics& optics, Vec2 film_point, LensIndex lens,
                                const LensPoint& point);

/// Calls beam_ray for one lens and k = 0 to number - 1: for film_points[k] through points[k].
/// Results are the same bit for bit, but rays through lenticular lenses are computed side by side.
void beam_rays(const SheetOptics& optics, int number, const RayRun<Vec2>& film_points,
               LensIndex lens, const RayRun<LensPoint>& points,
               RayRun<std::optional<BeamRay>>& rays);

/// The point where light through `point` of a lens and through `scene_point` leaves the lens, in
/// the plane z = height of `point`: `point` itself or, on a lenticular lens, the only place on a
/// line through `point` parallel to the axis from which a straight line meets both slit and scene
/// point.
Vec2 leaving_point(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                   const LensPoint& point = {});

/// Inverse of beam_ray: the film point whose light passes through `point` of a lens and through
/// `scene_point`. The scene point may be anywhere in the sheet frame except at the z of the lens's
/// point and, for a lenticular sheet, in the plane of the slit. Empty if no light from the film
/// goes that way, or if a film point's light has two ways to the slit, where beam_ray gives no ray.
std::optional<Vec2> film_point_imaging(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                                       const LensPoint& point = {});

/// film_point_imaging through the pole of a square or hexagonal lens, for any model. The z of
/// `scene_point` must not be 0.
inline Vec2 film_point_through_pole(const Medium& medium, Vec2 pole, Vec3 scene_point)
{
    const double sign = scene_point.z > 0 ? -1 : 1; // towards the viewer
    return pole -
           offset_from_direction(medium, {sign * (scene_point.x - pole.x),
                                          sign * (scene_point.y - pole.y), sign * scene_point.z});
}

} // namespace integral

#endif
