// SPDX-License-Identifier: AGPL-3.0-or-later
// The rays by which a film point's light leaves its lens, for every lens model; and the film point
// that images a given scene point.
#ifndef INTEGRAL_OPTICS_BEAM_H
#define INTEGRAL_OPTICS_BEAM_H

#include "integral/optics/lens_mapping.h"

namespace integral {

/// One ray of a film point's light beyond its lens. Sheet frame, mm.
struct BeamRay {
    Vec3 point;     ///< where it leaves: in the plane of the poles (z = 0) or on the lens's surface
    Vec3 direction; ///< unit, towards the viewer (z < 0)
    Vec2 aperture_point; ///< where it meets the aperture plane z = -distance
};

/// The pole ray as a ray of the beam.
inline BeamRay pole_beam(const LensRay& ray)
{
    return {{ray.pole.x, ray.pole.y, 0}, ray.direction, ray.aperture_point};
}

/// The ray of `film_point` through a point of a lens, by the sheet's lens model. It need not pass
/// the aperture: only the pole ray decides whether a film point is imaged.
///
/// pinhole, extended_pinhole: the ideal parallel beam, that is the pole ray moved sideways by the
/// point's offset. Where the point has a slit height, it is the pole ray to that height of the
/// slit. hybrid, full: the straight line from the film point to the surface z = R - sqrt(R^2 - r^2)
/// at the offset, refracted there by Snell's law. The surface of a lenticular lens is a straight
/// line at that offset; the light leaves it at the point from which it reaches the slit, e.A =
/// slit.
///
/// Nothing where the light is totally reflected at the surface, is sent away from the viewer, or
/// cannot reach the slit. That a neighbouring lens's edge may be in the way is neglected.
std::optional<BeamRay> beam_ray(const SheetOptics& optics, Vec2 film_point, LensIndex lens,
                                const LensPoint& point);

/// beam_ray of the first `number` film points through one lens, each through the point of the same
/// number: the same, bit for bit, but behind lenticular lenses worked out side by side.
void beam_rays(const SheetOptics& optics, int number, const RayRun<Vec2>& film_points,
               LensIndex lens, const RayRun<LensPoint>& points,
               RayRun<std::optional<BeamRay>>& rays);

/// Where on z = height of the lens's point the light leaves that goes through `point` of a lens and
/// through `scene_point`: the lens's point itself; on a lenticular lens the one place of the line
/// through it, parallel to the axis, from which a straight line meets both slit and scene point.
Vec2 leaving_point(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                   const LensPoint& point = {});

/// Inverse: the film point whose light passes through `point` of a lens and through `scene_point`.
/// The scene point may be anywhere in the sheet frame but at the z of the lens's point and, with a
/// lenticular sheet, in the plane of the slit. Nothing where no light from the film goes that way,
/// or where a film point's light has two ways to the slit, of which beam_ray takes neither.
std::optional<Vec2> film_point_imaging(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                                       const LensPoint& point = {});

/// The same through the pole of a square or hexagonal lens, whatever the model: a point with z not
/// 0.
inline Vec2 film_point_through_pole(const Medium& medium, Vec2 pole, Vec3 scene_point)
{
    const double sign = scene_point.z > 0 ? -1 : 1; // towards the viewer
    return pole -
           offset_from_direction(medium, {sign * (scene_point.x - pole.x),
                                          sign * (scene_point.y - pole.y), sign * scene_point.z});
}

} // namespace integral

#endif
