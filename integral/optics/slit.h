// SPDX-License-Identifier: AGPL-3.0-or-later
// The slit of a lenticular sheet: where along its axis a cylinder lens passes a film point's light.
#ifndef INTEGRAL_OPTICS_SLIT_H
#define INTEGRAL_OPTICS_SLIT_H

#include "integral/optics/lens_surface.h"

#include <optional>

namespace integral {

/// A cylinder lens has no power along its axis; the ray from a film point is fixed by the slit
/// e.A = eta in the aperture plane at `distance`. Plain geometry, in the sheet frame.
struct Slit {
    Vec2 axis;       ///< a, unit, along the lens axes; signed so that dot(normal, axis) > 0
    Vec2 across;     ///< b, unit, perpendicular to the axes
    Vec2 normal;     ///< e, unit, across the slit: y for a horizontal slit, x for a vertical one, of either sign
    double distance; ///< d, mm
};

/// Newton's error after a step is about change^2/(distance to the end of the interval): below this part of the root it is done.
constexpr double slit_settled = 1e-17;

/// e.A of a slit at `height`, whose sign is that of y (horizontal slit) or x (vertical).
inline double signed_height(const Slit& slit, double height)
{
    return slit.normal.x + slit.normal.y < 0 ? -height : height;
}

/// Offset tau (mm) along the axis from `foot` of the point through which the light leaves. `foot` is the foot of
/// the film point on a line of the lens, parallel to its axis; `h` the signed distance from the film point to that
/// line along `across`; the light is refracted at `plane`, which contains the line. eta = e.A.
///
/// The one root of optics.md section 3's G between the offsets where total reflection starts or the light
/// ceases to go towards the viewer. Nothing if G does not change sign there: the slit cannot be reached. On the
/// axis, that is |h| >= t g / sqrt(m).
std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h, double eta = 0,
                                 const TangentPlane& plane = {});

/// Whether solve_slit has a root, without looking for it.
bool reaches_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h, double eta = 0,
                  const TangentPlane& plane = {});

/// A film point's light through a line of a cylinder lens and through the slit.
struct SlitRay {
    Vec2 point;          ///< where it leaves, at z = height of the tangent plane
    Vec2 offset;         ///< from the film point to there
    Vec3 refracted;      ///< its direction beyond the lens times |(offset, t - height)|; z < 0
    Vec2 aperture_point; ///< where it meets the aperture plane; e.A is eta exactly
};

/// `on_axis`: any point of the lens's axis; the line is plane.v from it along `across`.
/// Nothing where solve_slit gives nothing.
std::optional<SlitRay> slit_ray(const Slit& slit, const Medium& medium, Vec2 film_point, Vec2 on_axis, double eta = 0,
                                const TangentPlane& plane = {});

} // namespace integral

#endif
