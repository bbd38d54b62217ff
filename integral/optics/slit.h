// SPDX-License-Identifier: AGPL-3.0-or-later
// The slit in a lenticular sheet's aperture. It determines the point on a cylinder lens's axis
// where a film point's light leaves the lens.
#ifndef INTEGRAL_OPTICS_SLIT_H
#define INTEGRAL_OPTICS_SLIT_H

#include "integral/optics/lens_surface.h"

#include <array>
#include <cmath>
#include <optional>

namespace integral {

/// A cylinder lens has no power along its axis; a film point's ray is fixed by the slit: it meets
/// the aperture plane, at `distance`, at a point A with e.A = eta. All vectors are in the sheet
/// frame.
struct Slit {
    Vec2 axis;   ///< a, unit, along the lens axes; signed so that dot(normal, axis) > 0
    Vec2 across; ///< b, unit, perpendicular to the axes
    Vec2 normal; ///< e, unit, across the slit: y for a horizontal slit, x for a vertical one, of
                 ///< either sign
    double distance; ///< d, mm
};

/// e.A for the points A of the slit at `height`, mm: their y if the slit is horizontal, their x if
/// it is vertical.
inline double signed_height(const Slit& slit, double height)
{
    return slit.normal.x + slit.normal.y < 0 ? -height : height;
}

/// Offset tau (mm) along the axis, from `foot` to the point through which the light leaves. `foot`
/// is the foot of the perpendicular from the film point to a line of the lens, parallel to the
/// axis; `h` is the signed distance from the film point to that line along `across`. `plane`, at
/// which the light is refracted, contains the line. eta = e.A.
///
/// tau is the one root of G (optics.md section 3) between the two offsets at which total reflection
/// starts or the light ceases to go towards the viewer. Empty if G does not change sign between
/// them: the slit cannot be reached. For light that leaves at the axis, this is so if |h| >= t g /
/// sqrt(m).
std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                 double eta = 0, const TangentPlane& plane = {});

/// Whether solve_slit would find a root, at less cost.
bool reaches_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h, double eta = 0,
                  const TangentPlane& plane = {});

/// A film point's light through a line of a cylinder lens and through the slit.
struct SlitRay {
    Vec2 point;          ///< exit, at z = height of the tangent plane
    Vec2 offset;         ///< from the film point to the exit
    Vec3 refracted;      ///< direction beyond the lens times |(offset, t - height)|; z < 0
    Vec2 aperture_point; ///< intersection with the aperture plane; e.A is eta exactly
};

/// `on_axis`: any point of the lens's axis; the line is plane.v (mm) from the axis along `across`.
/// Empty if solve_slit is.
std::optional<SlitRay> slit_ray(const Slit& slit, const Medium& medium, Vec2 film_point,
                                Vec2 on_axis, double eta = 0, const TangentPlane& plane = {});

/// Number of rays that are computed side by side; RayRun holds a value for each of them.
constexpr int run_length = 8;
template <class T> using RayRun = std::array<T, run_length>;

/// Computes slit_ray for the first `number` film points, each through its own axis and with its own
/// eta, with refraction in the plane of the poles. Results are bit for bit the same. A single ray
/// is a chain of some fifteen square roots and quotients, and each waits for the one before. Here
/// every step is done for all rays before the next step, so that several chains are computed at
/// once.
void slit_rays(const Slit& slit, const Medium& medium, int number, const RayRun<Vec2>& film_points,
               const RayRun<Vec2>& on_axes, const RayRun<double>& etas,
               RayRun<std::optional<SlitRay>>& rays);

} // namespace integral

#endif
