// SPDX-License-Identifier: AGPL-3.0-or-later
// The slit of a lenticular sheet: where along its axis a cylinder lens passes a film point's light.
#ifndef INTEGRAL_OPTICS_SLIT_H
#define INTEGRAL_OPTICS_SLIT_H

#include "integral/optics/lens_surface.h"

#include <array>
#include <cmath>
#include <optional>

namespace integral {

/// A cylinder lens has no power along its axis; the ray from a film point is fixed by the slit
/// e.A = eta in the aperture plane at `distance`. Plain geometry, in the sheet frame.
struct Slit {
    Vec2 axis;   ///< a, unit, along the lens axes; signed so that dot(normal, axis) > 0
    Vec2 across; ///< b, unit, perpendicular to the axes
    Vec2 normal; ///< e, unit, across the slit: y for a horizontal slit, x for a vertical one, of
                 ///< either sign
    double distance; ///< d, mm
};

/// e.A of a slit at `height`, whose sign is that of y (horizontal slit) or x (vertical).
inline double signed_height(const Slit& slit, double height)
{
    return slit.normal.x + slit.normal.y < 0 ? -height : height;
}

/// Offset tau (mm) along the axis, from `foot` to the point through which the light leaves. `foot`
/// is the foot of the film point on a line of the lens, parallel to its axis; `h` is the signed
/// distance from the film point to that line along `across`. `plane`, at which the light is
/// refracted, contains the line. eta = e.A.
///
/// tau is the one root of G (optics.md section 3) between the two offsets at which total reflection
/// starts or the light ceases to go towards the viewer. Nothing if G does not change sign between
/// them: the slit cannot be reached. For light that leaves at the axis, that is |h| >= t g /
/// sqrt(m).
std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                 double eta = 0, const TangentPlane& plane = {});

/// Whether solve_slit would find a root, at less cost.
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
std::optional<SlitRay> slit_ray(const Slit& slit, const Medium& medium, Vec2 film_point,
                                Vec2 on_axis, double eta = 0, const TangentPlane& plane = {});

/// How many rays are worked out side by side; and a value for each of them.
constexpr int run_length = 8;
template <class T> using RayRun = std::array<T, run_length>;

/// slit_ray of the first `number` film points, each through the axis and with the eta of the same
/// number, with refraction in the plane of the poles: the same results, bit for bit. A single ray
/// is a chain of some fifteen square roots and quotients, each of which waits for the one before.
/// Here every step is taken for all rays before the next, so that the processor works on several
/// chains at once.
void slit_rays(const Slit& slit, const Medium& medium, int number, const RayRun<Vec2>& film_points,
               const RayRun<Vec2>& on_axes, const RayRun<double>& etas,
               RayRun<std::optional<SlitRay>>& rays);

} // namespace integral

#endif
