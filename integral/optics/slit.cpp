// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/slit.h"

#include <algorithm>

namespace integral {

std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h)
{
    const double g = dot(slit.normal, slit.axis);
    const double alpha = dot(slit.normal, foot);        // e.Q0 (the slit is at eta = 0)
    const double beta = h * dot(slit.normal, slit.across);
    const double nd = medium.n * slit.distance;

    const double e = clearance(medium, {h, 0});         // E = t^2 - m h^2
    if (!(e > 0))
        return std::nullopt;
    const double root_e = std::sqrt(e);
    const double paraxial = -(alpha * root_e + nd * beta) / (g * (root_e + nd));
    if (medium.m == 0)
        return paraxial;                                // exact: nothing is refracted

    const double limit = root_e / medium.root_m;        // T, where total reflection starts
    if (!(std::fabs(beta) < g * limit))
        return std::nullopt;

    // H(tau) = alpha + g tau + n d (g tau + beta)/S, S = sqrt(E - m tau^2), rises strictly from
    // -infinity to +infinity on (-T, T): Newton steps, kept inside a shrinking bracket.
    double low = -limit, high = limit;
    double tau = paraxial > low && paraxial < high ? paraxial : 0;
    constexpr int most_steps = 200;                     // bisection alone needs 60
    for (int step = 0; step < most_steps; ++step) {
        const double s2 = medium.m * (limit - tau) * (limit + tau);
        if (!(s2 > 0)) {                                // rounded onto an end of the interval
            const double inner = 0.5 * (low + high);
            if (inner == tau || inner <= low || inner >= high)
                return std::nullopt;
            tau = inner;
            continue;
        }
        const double s = std::sqrt(s2);
        const double value = (alpha + g * tau) * s + nd * (g * tau + beta);             // H S
        if (value == 0)
            break;
        (value < 0 ? low : high) = tau;
        const double slope = g * s2 * s + nd * (g * e + beta * medium.m * tau);         // H' S^3
        const double before = tau, change = value * s2 / slope;
        tau -= change;
        // Newton's error after a step is about change^2/(distance to the end of the interval).
        if (tau == before || change * change <= 1e-17 * std::fabs(tau) * (limit - std::fabs(tau)))
            break;
        if (!(tau > low && tau < high))
            tau = 0.5 * (low + high);
    }
    return std::clamp(tau, -limit, limit);
}

} // namespace integral
