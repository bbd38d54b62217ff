// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/slit.h"

#include <algorithm>

namespace integral {

namespace {

/// The slit's equation at a line of the lens. With S = sqrt(E - m tau^2), E the clearance at tau =
/// 0, the refracted ray is (n k cosine + S sine, n tau, -C)/L in the directions (b, a, z), C = S
/// cosine - n k sine.
///     H(tau) = alpha + g tau + D (g n tau + e.b (n k cosine + S sine))/C = 0,
///     H' = g + D n phi/(S C^2), phi = g (cosine E - n k sine S) + m (e.b) k tau,
/// D the distance from the line to the aperture. G of optics.md is H C.
struct Equation {
    double alpha, g, eb, distance, n, m, root_m, k, sine, cosine, e;

    double c(double s) const { return s * cosine - n * k * sine; }
    double g_value(double tau, double s) const
    {
        return (alpha + g * tau) * c(s) +
               distance * (g * n * tau + eb * (n * k * cosine + s * sine));
    }
    /// Newton's step, H/H'.
    double step(double tau, double s, double value) const
    {
        const double cs = c(s), phi = g * (cosine * e - n * k * sine * s) + m * eb * k * tau;
        return value * (s * cs) / (g * s * cs * cs + distance * n * phi);
    }
};

/// Nothing where no light gets to the plane from inside, or none leaves it towards the viewer.
std::optional<Equation> equation_of(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                    double eta, const TangentPlane& plane)
{
    const Incidence way = incidence(medium, plane, h);
    const double clear = clearance(medium, way, 0);
    if (!(clear > 0) || !(way.normal > 0))
        return std::nullopt;
    const Equation equation{dot(slit.normal, foot) - eta,
                            dot(slit.normal, slit.axis),
                            dot(slit.normal, slit.across),
                            slit.distance + plane.height,
                            medium.n,
                            medium.m,
                            medium.root_m,
                            way.tangential,
                            plane.sine,
                            plane.cosine,
                            clear};
    if (!(equation.c(std::sqrt(clear)) > 0))
        return std::nullopt;
    return equation;
}

/// The greatest |tau|: where total reflection starts, at `limit`, or C = 0 before that. Nothing if
/// H does not go from below 0 to above 0 between -end and end. If it does, it rises all the way,
/// but perhaps next to an end, on that end's own side of 0: the root is the only one.
std::optional<double> end_of(const Equation& equation, double root_e, double limit)
{
    const double floor = equation.n * equation.k * equation.sine; // C > 0 demands S cosine > floor
    if (floor < 0) {
        if (equation.g_value(-limit, 0) < 0 && equation.g_value(limit, 0) > 0)
            return limit;
        return std::nullopt;
    }
    double end = limit;
    if (floor > 0) {
        const double least_s = floor / equation.cosine;
        end = std::sqrt((root_e - least_s) * (root_e + least_s)) / equation.root_m;
    }
    if (std::fabs(equation.eb * equation.k) < equation.g * equation.cosine * end)
        return end;
    return std::nullopt;
}

/// A root of PoleEquation, and S there.
struct PoleRoot {
    double tau, s;
};

/// Newton's steps alone: nearly every ray of a picture needs two. False where they do not settle at
/// once.
inline bool settle_at_pole(const Slit& slit, const Medium& medium, Vec2 foot, double h, double eta,
                           PoleRoot& root)
{
    const double clear = clearance(medium, {h, 0});
    if (!(clear > 0))
        return false;
    const double root_clear = std::sqrt(clear);
    const PoleEquation equation{dot(slit.normal, foot) - eta,
                                dot(slit.normal, slit.axis),
                                h * dot(slit.normal, slit.across),
                                medium.n * slit.distance,
                                medium.m,
                                clear,
                                PoleEquation::end_of(root_clear, medium.root_m)};
    if (!(std::fabs(equation.lateral) < equation.g * equation.end))
        return false;
    double tau = equation.start(root_clear, medium.t);
    constexpr int most_steps = 5;
    for (int step = 0; step < most_steps && std::fabs(tau) < equation.end; ++step) {
        const double change = equation.step(tau);
        tau -= change;
        if (equation.settled(change, tau)) {
            root = {tau, equation.root(tau)};
            return root.s > 0;
        }
    }
    return false;
}

/// Where the light reaches the slit, from where and in which direction it leaves. `line`: a point
/// of the line that it leaves from.
inline SlitRay through_slit(const Slit& slit, double n, Vec2 foot, Vec2 line, double tau, double h,
                            double eta, double distance, Vec3 refracted)
{
    SlitRay ray;
    ray.offset = h * slit.across + tau * slit.axis;
    ray.refracted = refracted;
    ray.point = foot + tau * slit.axis;
    const double stretch = distance / -refracted.z;
    const Vec2 to_aperture = stretch * Vec2{refracted.x, refracted.y};
    if (n * stretch < 1) {
        // Here foot + tau a cancels; the point's component across the slit is known without.
        const double across_slit = eta - dot(slit.normal, to_aperture);
        const double along_axis = (across_slit - dot(slit.normal, line)) /
                                  dot(slit.normal, slit.axis);
        ray.point = line + along_axis * slit.axis;
    }
    ray.aperture_point = ray.point + to_aperture;
    if (slit.normal.x == 0)
        ray.aperture_point.y = slit.normal.y * eta;
    else
        ray.aperture_point.x = slit.normal.x * eta;
    return ray;
}

/// solve_slit where Newton's steps alone do not do, or the plane is not that of the poles.
std::optional<double> solve_in_bracket(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                       double eta, const TangentPlane& plane)
{
    const auto found = equation_of(slit, medium, foot, h, eta, plane);
    if (!found)
        return std::nullopt;
    const Equation& equation = *found;
    const double root_e = std::sqrt(equation.e);
    const double paraxial = -equation.step(0, root_e, equation.g_value(0, root_e));
    if (medium.m == 0)
        return paraxial; // exact: nothing is refracted
    const double limit = root_e / medium.root_m;
    const auto reach = end_of(equation, root_e, limit);
    if (!reach)
        return std::nullopt;

    // Newton steps, kept inside a shrinking bracket.
    const double end = *reach;
    double low = -end, high = end;
    double tau = paraxial > low && paraxial < high ? paraxial : 0;
    constexpr int most_steps = 200, soon = 20; // the worst cases tested need 55
    for (int step = 0; step < most_steps; ++step) {
        const double s2 = medium.m * (limit - tau) * (limit + tau);
        const double s = s2 > 0 ? std::sqrt(s2) : 0;
        if (!(s > 0) || !(equation.c(s) > 0)) { // rounded onto an end of the interval
            const double inner = 0.5 * (low + high);
            if (inner == tau || inner <= low || inner >= high)
                return std::nullopt;
            tau = inner;
            continue;
        }
        const double value = equation.g_value(tau, s);
        if (value == 0)
            break;
        (value < 0 ? low : high) = tau;
        const double before = tau, change = equation.step(tau, s, value);
        tau -= change;
        if (tau == before ||
            change * change <= slit_settled * std::fabs(tau) * (end - std::fabs(tau)))
            break;
        if (!(tau > low && tau < high) || (step > soon && step % 3 == 0))
            tau = 0.5 * (low + high);
        if (!(tau > low && tau < high)) // nothing lies between any more
            break;
    }
    return std::clamp(tau, -end, end);
}

} // namespace

bool reaches_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h, double eta,
                  const TangentPlane& plane)
{
    const auto equation = equation_of(slit, medium, foot, h, eta, plane);
    if (!equation)
        return false;
    const double root_e = std::sqrt(equation->e);
    return medium.m == 0 || end_of(*equation, root_e, root_e / medium.root_m);
}

std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                 double eta, const TangentPlane& plane)
{
    PoleRoot root;
    if (plane.sine == 0 && medium.m > 0 && settle_at_pole(slit, medium, foot, h, eta, root))
        return root.tau;
    return solve_in_bracket(slit, medium, foot, h, eta, plane);
}

std::optional<SlitRay> slit_ray(const Slit& slit, const Medium& medium, Vec2 film_point,
                                Vec2 on_axis, double eta, const TangentPlane& plane)
{
    const double h = dot(slit.across, on_axis - film_point) + plane.v;
    const Vec2 foot = film_point + h * slit.across;
    PoleRoot root;
    if (plane.sine == 0 && medium.m > 0 && settle_at_pole(slit, medium, foot, h, eta, root)) {
        const Vec2 lateral = medium.n * (h * slit.across + root.tau * slit.axis);
        return through_slit(slit, medium.n, foot, on_axis, root.tau, h, eta, slit.distance,
                            {lateral.x, lateral.y, -root.s});
    }
    const auto tau = solve_in_bracket(slit, medium, foot, h, eta, plane);
    if (!tau)
        return std::nullopt;
    const Incidence way = incidence(medium, plane, h);
    const double clear = clearance(medium, way, *tau);
    if (!(clear > 0))
        return std::nullopt;
    const Vec3 out = refracted(medium, plane, way, *tau, std::sqrt(clear));
    if (!(out.z < 0))
        return std::nullopt;
    const Vec3 direction{out.x * slit.across.x + out.y * slit.axis.x,
                         out.x * slit.across.y + out.y * slit.axis.y, out.z};
    return through_slit(slit, medium.n, foot, on_axis + plane.v * slit.across, *tau, h, eta,
                        slit.distance + plane.height, direction);
}

} // namespace integral
