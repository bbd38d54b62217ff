// SPDX-License-Identifier: AGPL-3.0-or-later
// The rays in which a film point's light leaves its lens, by any lens model, and back from a scene
// point.
#ifndef INTEGRAL_OPTICS_BEAM_H
#define INTEGRAL_OPTICS_BEAM_H

#include "integral/optics/lens_mapping.h"

namespace integral {

/// One ray of a film point's light beyond its lens. Sheet frame, mm.
struct BeamRay {
    Vec3 point; ///< where it leaves: on the plane of the poles (z = 0), or on the lens's surface (z
                ///< >= 0)
    Vec3 direction;      ///< unit, towards the viewer (z < 0)
    Vec2 aperture_point; ///< where it meets the aperture plane z = -distance
};

/// The pole ray as a ray of the beam.
inline BeamRay pole_beam(const LensRay& ray)
{
    return {{ray.pole.x, ray.pole.y, 0}, ray.direction, ray.aperture_point};
}

/// The ray of `film_point` through a point of a lens, by the sheet's lens model; whether it passes
/// the aperture is not asked, that is the pole ray's business.
///
/// pinhole, extended_pinhole: the ideal parallel beam, the pole ray moved sideways by the point's
/// offset (the pole ray of a slit at height `slit`, where that is not 0). hybrid, full: the
/// straight line from the film point to the surface z = R - sqrt(R^2 - r^2) at the offset,
/// refracted there by Snell's law. On a lenticular lens the point of that generating line from
/// which the light reaches the slit, e.A = slit. What a neighbouring lens's edge may hide is not
/// asked. Nothing: totally reflected at the surface, sent away from the viewer, or the slit cannot
/// be reached.
std::optional<BeamRay> beam_ray(const SheetOptics& optics, Vec2 film_point, LensIndex lens,
                                const LensPoint& point);

/// Inverse: the film point whose light, through that point of that lens, goes through
/// `scene_point`, anywhere in the sheet frame but at the z of the lens's point and, with a
/// lenticular sheet, in the plane of the slit. Nothing: no light from the film goes there through
/// that point; or beam_ray gives another ray for the film point, whose light has two ways to the
/// slit.
std::optional<Vec2> film_point_imaging(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                                       const LensPoint& point = {});

} // namespace integral

#endif
