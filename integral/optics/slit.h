// SPDX-License-Identifier: AGPL-3.0-or-later
// The slit of a lenticular sheet: where along its axis a cylinder lens passes a film point's light.
#ifndef INTEGRAL_OPTICS_SLIT_H
#define INTEGRAL_OPTICS_SLIT_H

#include "integral/optics/lens_surface.h"

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

/// Newton's error after a step is about change^2/(distance to the end of the interval): below this
/// part of the root it is done.
constexpr double slit_settled = 1e-17;

/// The slit's equation for light that is refracted in the plane of the poles: with S = sqrt(E - m
/// tau^2), E the clearance at tau = 0, p = g tau + h e.b and D the slit's distance
///     H(tau) = alpha + g tau + n D p/S,   H' = g + n D (g E + m h (e.b) tau)/S^3.
/// Written so that a compiler can take several side by side.
struct PoleEquation {
    double alpha;    ///< e.foot - eta
    double g;        ///< e.a
    double lateral;  ///< h e.b
    double nd;       ///< n D
    double m, clear; ///< of the medium; E
    double end;      ///< the greatest |tau|, sqrt(E/m)

    static double end_of(double root_clear, double root_m) { return root_clear * (1 / root_m); }

    /// The root to third order in tau, where E is little less than t^2, and what is left of the
    /// slit's distance is taken by a series.
    double start(double root_clear, double t) const
    {
        const double inverse_t2 = 1 / (t * t), inverse_reach = 1 / (t + nd), inverse_g = 1 / g;
        const double narrower = (t - root_clear) * inverse_reach,
                     paraxial = inverse_g * inverse_reach * (1 + narrower + narrower * narrower);
        const double taken = 1 - clear * inverse_t2,
                     bend = (0.5 * m * inverse_t2) * (1 + taken + taken * taken);
        const double first = -(alpha * root_clear + nd * lateral) * paraxial;
        return first - nd * (g * first + lateral) * paraxial * (bend * first * first);
    }
    double root(double tau) const { return std::sqrt(m * ((end - tau) * (end + tau))); } ///< S
    /// Newton's step, H/H'.
    double step(double tau) const
    {
        const double s2 = m * ((end - tau) * (end + tau)), s = std::sqrt(s2);
        return ((alpha + g * tau) * s + nd * (g * tau + lateral)) * s2 /
               (g * s * s2 + nd * (g * clear + m * lateral * tau));
    }
    /// Whether `change` was the last step that is needed, which led to tau.
    bool settled(double change, double tau) const
    {
        return change * change <= slit_settled * std::fabs(tau) * (end - std::fabs(tau));
    }
};

/// e.A of a slit at `height`, whose sign is that of y (horizontal slit) or x (vertical).
inline double signed_height(const Slit& slit, double height)
{
    return slit.normal.x + slit.normal.y < 0 ? -height : height;
}

/// Offset tau (mm) along the axis from `foot` of the point through which the light leaves. `foot`
/// is the foot of the film point on a line of the lens, parallel to its axis; `h` the signed
/// distance from the film point to that line along `across`; the light is refracted at `plane`,
/// which contains the line. eta = e.A.
///
/// The one root of optics.md section 3's G between the offsets where total reflection starts or the
/// light ceases to go towards the viewer. Nothing if G does not change sign there: the slit cannot
/// be reached. On the axis, that is |h| >= t g / sqrt(m).
std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                 double eta = 0, const TangentPlane& plane = {});

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
std::optional<SlitRay> slit_ray(const Slit& slit, const Medium& medium, Vec2 film_point,
                                Vec2 on_axis, double eta = 0, const TangentPlane& plane = {});

} // namespace integral

#endif
