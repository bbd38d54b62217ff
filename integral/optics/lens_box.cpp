// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/lens_box.h"

#include <limits>

namespace integral {

/// Light from the film point f through a pole P meets the aperture plane at A = f + g (P - f), so
/// P = f - (f - A)/g. The factor g = 1 + n d/sqrt(t^2 - m |P - f|^2) is greatest for the pole
/// farthest from f.
LensBox box_of_passing_poles(const Aperture& aperture, const Medium& medium, Vec2 film_point,
                             Vec2 centre, double radius)
{
    constexpr double to_corner = 1.4143, rounding = 1e-9;
    const auto stretch = [&](double offset) {
        const double clear = clearance(medium, {offset, 0});
        return clear > 0 ? 1 + medium.n * aperture.distance / std::sqrt(clear)
                         : std::numeric_limits<double>::infinity();
    };
    const double away = length(centre - film_point), corner = to_corner * radius,
                 least = stretch(std::max(0.0, away - corner) * (1 - rounding)) * (1 - rounding),
                 most = stretch((away + corner) * (1 + rounding)) * (1 + rounding),
                 margin = 1e-6 * radius + rounding * length(film_point);
    struct Interval {
        double low, high;
    };
    const auto poles = [&](double at, double extent) -> Interval {
        const double half = 0.5 * extent * inclusive_edge, low = at - half, high = at + half;
        return {at - high / (high > 0 ? least : most) - margin,
                at - low / (low < 0 ? least : most) + margin};
    };
    const Interval across = poles(film_point.x, aperture.width),
                   up = poles(film_point.y, aperture.height);
    return {{across.low, up.low}, {across.high, up.high}};
}

} // namespace integral
