// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/ray_gradient.h"

namespace integral {
namespace {

/// The symmetric matrix J = n d (I/S + m q q^T/S^3): the derivative of n d q/S, the lateral way
/// from the pole to the aperture plane, by q = pole - film point; S = sqrt(t^2 - m |q|^2).
struct WayDerivative {
    WayDerivative(const Medium& medium, double distance, Vec2 offset)
        : q(offset), s2(clearance(medium, offset)), m(medium.m)
    {
        nd_s = medium.n * distance / std::sqrt(s2);
    }
    Vec2 operator*(Vec2 v) const { return nd_s * (v + (m * dot(q, v) / s2) * q); }

    Vec2 q;
    double s2, m, nd_s;
};

} // namespace

RayGradient ray_gradient(const SheetOptics& optics, Vec2 film_point, const LensRay& ray)
{
    const WayDerivative way(optics.medium(), optics.aperture().distance, ray.pole - film_point);
    RayGradient gradient;
    if (optics.sheet().arrangement != Arrangement::lenticular) {
        gradient.x.aperture = -1 * (way * Vec2{1, 0}); // the pole stays, q moves against the point
        gradient.y.aperture = -1 * (way * Vec2{0, 1});
        return gradient;
    }
    // The exit moves along the axis, by p per mm, and e.A moves as the slit does:
    // e.(a p + J (a p - f)) = eta for a film point that moves by f and a slit that moves by eta.
    const Slit& slit = optics.slit();
    const double rise = dot(slit.normal, slit.axis + way * slit.axis);
    const auto shift = [&](Vec2 film, double eta) {
        const double p = (eta + dot(slit.normal, way * film)) / rise;
        const Vec2 exit = p * slit.axis;
        return RayShift{exit, exit + way * (exit - film)};
    };
    gradient.x = shift({1, 0}, 0);
    gradient.y = shift({0, 1}, 0);
    gradient.slit = shift({0, 0}, signed_height(slit, 1));
    return gradient;
}

} // namespace integral
