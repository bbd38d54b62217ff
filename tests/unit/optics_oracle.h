// SPDX-License-Identifier: AGPL-3.0-or-later
// The equations of optics.md section 3 in 100-digit arithmetic, written down plainly and sharing
// nothing with integral/optics but the parameter structs.
#ifndef TESTS_UNIT_OPTICS_ORACLE_H
#define TESTS_UNIT_OPTICS_ORACLE_H

#include "integral/optics/beam.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <optional>

namespace oracle {

using Real = boost::multiprecision::cpp_dec_float_100;

struct Point {
    Real x, y;
};

/// The ray of one film point through one lens, with the condition number of the error bound.
struct Ray {
    Point pole;        ///< mm
    Real s_x, s_y, c;  ///< direction (s_x, s_y, -c)
    Point aperture;    ///< mm
    Real kappa;        ///< t^2 / (t^2 - m rho^2)
    Real offset_ratio; ///< (|film point| + |pole|) / L
};

/// The lattice's axes at the sheet's slant: across (b) and along (a).
inline void axes(const integral::LensSheet& sheet, Point& across, Point& along)
{
    const Real angle = Real(sheet.slant) * boost::math::constants::pi<Real>() / 180;
    across = {cos(angle), sin(angle)};
    along = {-sin(angle), cos(angle)};
}

inline Point pole(const integral::LensSheet& sheet, integral::LensIndex lens)
{
    Point across, along;
    axes(sheet, across, along);
    const Real p = sheet.pitch;
    Real u = p * lens.i, v = 0;
    if (sheet.arrangement == integral::Arrangement::square)
        v = p * lens.j;
    if (sheet.arrangement == integral::Arrangement::hexagonal) {
        v = p * lens.j * sqrt(Real(3)) / 2;
        if (lens.j % 2 != 0)
            u += p / 2;
    }
    return {Real(sheet.offset.x) + u * across.x + v * along.x,
            Real(sheet.offset.y) + u * across.y + v * along.y};
}

/// The root of G by bisection on [-T, T], or nothing where |h| >= t g/sqrt(m).
inline std::optional<Real> slit_root(Real alpha, Real beta, Real g, Real e, Real m, Real nd)
{
    if (m == 0)
        return -(alpha * sqrt(e) + nd * beta) / (g * (sqrt(e) + nd));
    if (e <= 0)
        return std::nullopt;
    const Real t_end = sqrt(e / m);
    if (abs(beta) >= g * t_end)
        return std::nullopt;
    const auto value = [&](const Real& tau) {
        const Real inside = e - m * tau * tau;
        return (alpha + g * tau) * (inside > 0 ? Real(sqrt(inside)) : Real(0)) +
               nd * (g * tau + beta);
    };
    Real low = -t_end, high = t_end;
    for (int step = 0; step < 200; ++step) {
        const Real middle = (low + high) / 2;
        (value(middle) < 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// The slit's normal e, signed so that e.a > 0, and e.A of a slit at `height`.
struct SlitFrame {
    Point e;
    Real eta;
};
inline SlitFrame slit_frame(const integral::LensSheet& sheet, Point along, double height)
{
    const bool horizontal = std::fabs(sheet.slant) <= 45;
    const Point plain{horizontal ? 0 : 1, horizontal ? 1 : 0};
    if (plain.x * along.x + plain.y * along.y < 0)
        return {{-plain.x, -plain.y}, -Real(height)};
    return {plain, height};
}

/// Steps 2 to 4 of optics.md section 3; nothing on total reflection or if the slit is missed.
inline std::optional<Ray> ray(const integral::LensSheet& sheet, double distance,
                              integral::Vec2 film, integral::LensIndex lens, double slit_height = 0)
{
    const Real t = sheet.thickness, n = sheet.ior, m = (n - 1) * (n + 1), d = distance, x = film.x,
               y = film.y;
    Ray out;
    out.pole = pole(sheet, lens);
    if (sheet.arrangement == integral::Arrangement::lenticular) {
        Point b, a;
        axes(sheet, b, a);
        const Real h = b.x * (out.pole.x - x) + b.y * (out.pole.y - y);
        const Point foot{x + h * b.x, y + h * b.y};
        const auto [e, eta] = slit_frame(sheet, a, slit_height);
        const Real g = e.x * a.x + e.y * a.y;
        const auto tau = slit_root(e.x * foot.x + e.y * foot.y - eta, h * (e.x * b.x + e.y * b.y),
                                   g, t * t - m * h * h, m, n * d);
        if (!tau)
            return std::nullopt;
        out.pole = {foot.x + *tau * a.x, foot.y + *tau * a.y};
    }
    const Real qx = out.pole.x - x, qy = out.pole.y - y, rho2 = qx * qx + qy * qy,
               length = sqrt(rho2 + t * t);
    out.s_x = n * qx / length;
    out.s_y = n * qy / length;
    const Real c2 = 1 - out.s_x * out.s_x - out.s_y * out.s_y;
    if (c2 <= 0)
        return std::nullopt;
    out.c = sqrt(c2);
    out.aperture = {out.pole.x + out.s_x * d / out.c, out.pole.y + out.s_y * d / out.c};
    out.kappa = t * t / (t * t - m * rho2);
    out.offset_ratio = (sqrt(x * x + y * y) +
                        sqrt(out.pole.x * out.pole.x + out.pole.y * out.pole.y)) /
                       length;
    return out;
}

} // namespace oracle

#endif
