// SPDX-License-Identifier: AGPL-3.0-or-later
// The slit of a lenticular sheet: where along its axis a cylinder lens passes a film point's light.
#ifndef INTEGRAL_OPTICS_SLIT_H
#define INTEGRAL_OPTICS_SLIT_H

#include "integral/optics/refraction.h"

#include <optional>

namespace integral {

/// A cylinder lens has no power along its axis; the ray from a film point is fixed by the slit
/// e.A = 0 in the aperture plane at `distance`. Plain geometry, in the sheet frame.
struct Slit {
    Vec2 axis;       ///< a, unit, along the lens axes; signed so that dot(normal, axis) > 0
    Vec2 across;     ///< b, unit, perpendicular to the axes
    Vec2 normal;     ///< e, unit, across the slit: y for a horizontal slit, x for a vertical one
    double distance; ///< d, mm
};

/// Offset tau (mm) along the axis from `foot`, the foot of the film point on the axis, of the
/// point Q through which the light leaves: the one root of optics.md section 3's G on [-T, T].
/// `h` is the signed distance from the film point to the axis along `across`.
/// Nothing where the slit cannot be reached: |h| >= t g / sqrt(m).
std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h);

} // namespace integral

#endif
