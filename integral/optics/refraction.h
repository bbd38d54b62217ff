// SPDX-License-Identifier: AGPL-3.0-or-later
// The extended pinhole: refraction at the pole of a lens, film side <-> viewer side.
//
// A film point at lateral offset -q from the pole (q = pole - film point) leaves the pole in the
// direction (s, -c), s = n q / sqrt(q^2 + t^2), c = sqrt(1 - s^2): optics.md section 3, thesis 3.5.
#ifndef INTEGRAL_OPTICS_REFRACTION_H
#define INTEGRAL_OPTICS_REFRACTION_H

#include "integral/optics/vec.h"

#include <optional>

namespace integral {

/// The medium between film and poles: its thickness t (mm) and its refractive index n.
struct Medium {
    Medium(double thickness, double ior)
        : t(thickness), n(ior), m((ior - 1) * (ior + 1)), root_m(std::sqrt(m))
    {
    }
    double t, n;
    double m;      ///< n^2 - 1, without cancellation
    double root_m; ///< sqrt(m)
};

/// t^2 - m |q|^2 = L^2 (1 - |s|^2), without cancellation; <= 0 is total reflection.
inline double clearance(const Medium& medium, Vec2 q)
{
    const double q2 = dot(q, q), t2 = medium.t * medium.t, mq2 = medium.m * q2;
    if (2 * mq2 <= t2)
        return t2 - mq2;
    const double root = medium.root_m * std::sqrt(q2);
    return (medium.t - root) * (medium.t + root);
}

/// Unit direction towards the viewer (z < 0) of light from the film at pole - q, for a clearance
/// > 0 whose square root is `root`.
inline Vec3 refracted_at_pole(const Medium& medium, Vec2 q, double root)
{
    const double inverse_length = 1 / std::sqrt(dot(q, q) + medium.t * medium.t);
    const double lateral = medium.n * inverse_length;
    return {lateral * q.x, lateral * q.y, -root * inverse_length};
}

/// The same for any q; empty if the light is totally reflected.
inline std::optional<Vec3> direction_from_offset(const Medium& medium, Vec2 q)
{
    const double e = clearance(medium, q);
    if (!(e > 0))
        return std::nullopt;
    return refracted_at_pole(medium, q, std::sqrt(e));
}

/// Inverse: the q (pole - film point, mm) whose light leaves in `direction` (of any length, z < 0).
inline Vec2 offset_from_direction(const Medium& medium, Vec3 direction)
{
    const double scale = medium.t / std::sqrt(medium.m * dot(direction, direction) +
                                              direction.z * direction.z);
    return {scale * direction.x, scale * direction.y};
}

} // namespace integral

#endif
