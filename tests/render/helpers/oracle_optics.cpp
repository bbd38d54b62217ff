// SPDX-License-Identifier: AGPL-3.0-or-later
#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace oracle {
namespace {

const Real pi = std::acos(-1.0L);
const Real infinity = std::numeric_limits<Real>::infinity();

/// A lens's pole as the lattice has it; for a lenticular sheet, the point of its axis that is nearest to the lattice's own
/// origin.
Point2 pole(const Description& d, Lens lens)
{
    const Real p = d.pitch, angle = d.slant * pi / 180;
    Point2 q{lens.first * p, 0};
    if (d.arrangement == "square") q[1] = lens.second * p;
    if (d.arrangement == "hexagonal") {
        q[1] = lens.second * p * std::sqrt(3.0L) / 2;
        if (lens.second % 2 != 0) q[0] += p / 2;
    }
    return {d.offset[0] + q[0] * std::cos(angle) - q[1] * std::sin(angle),
            d.offset[1] + q[0] * std::sin(angle) + q[1] * std::cos(angle)};
}

/// How far the film point is from the lens, whose axis (lenticular) or pole counts.
Real lens_distance(const Description& d, Point2 f, Lens lens)
{
    const Point2 q = pole(d, lens);
    const Real dx = q[0] - f[0], dy = q[1] - f[1], angle = d.slant * pi / 180;
    if (d.arrangement == "lenticular") return std::fabs(dx * std::cos(angle) + dy * std::sin(angle));
    return std::hypot(dx, dy);
}

/// Calls `visit` with every lens within `reach` of the film point.
void each_lens(const Description& d, Point2 f, Real reach, const std::function<void(Lens)>& visit)
{
    const Real angle = d.slant * pi / 180, x = f[0] - d.offset[0], y = f[1] - d.offset[1];
    const Real u = x * std::cos(angle) + y * std::sin(angle), v = y * std::cos(angle) - x * std::sin(angle);
    const Real row = d.arrangement == "hexagonal" ? d.pitch * std::sqrt(3.0L) / 2 : d.pitch;
    const long i0 = std::floor((u - reach) / d.pitch) - 1, i1 = std::ceil((u + reach) / d.pitch) + 1;
    long j0 = 0, j1 = 0;
    if (d.arrangement != "lenticular") j0 = std::floor((v - reach) / row) - 1, j1 = std::ceil((v + reach) / row) + 1;
    for (long i = i0; i <= i1; i++)
        for (long j = j0; j <= j1; j++)
            if (lens_distance(d, f, {i, j}) <= reach) visit({i, j});
}

/// Steps 2 to 4 from film point f through the point q of the sheet plane.
std::optional<SheetRay> refract(const Description& d, Real distance, Point2 f, Point2 q, Lens lens)
{
    const Real length = std::sqrt((q[0] - f[0]) * (q[0] - f[0]) + (q[1] - f[1]) * (q[1] - f[1])
                                  + d.thickness * d.thickness);
    const Real sx = d.ior * (q[0] - f[0]) / length, sy = d.ior * (q[1] - f[1]) / length;
    const Real rest = 1 - sx * sx - sy * sy;
    if (rest <= 0) return std::nullopt;
    const Real c = std::sqrt(rest);
    return SheetRay{lens, {q[0] + sx * distance / c, q[1] + sy * distance / c}, {-sx, -sy, c}};
}

bool horizontal_slit(const Description& d) { return std::fabs(d.slant) <= 45; }

/// The point of the axis whose ray meets the slit, A_y = 0 or A_x = 0, by bisection along the axis.
std::optional<SheetRay> slit_ray(const Description& d, Real distance, Point2 f, Lens lens)
{
    const Real angle = d.slant * pi / 180;
    const Point2 b{std::cos(angle), std::sin(angle)};
    const int e = horizontal_slit(d) ? 1 : 0; // the coordinate that the slit fixes
    Point2 a{-std::sin(angle), std::cos(angle)};
    if (a[e] < 0) a = {-a[0], -a[1]};
    const Point2 q0 = pole(d, lens);
    const Real h = (q0[0] - f[0]) * b[0] + (q0[1] - f[1]) * b[1];
    const Point2 foot{f[0] + h * b[0], f[1] + h * b[1]};
    const auto at = [&](Real tau) { return Point2{foot[0] + tau * a[0], foot[1] + tau * a[1]}; };
    // Where the slit is missed: below (-1) or above (1); total reflection is infinitely far on its own side.
    const auto side = [&](Real tau) {
        const auto ray = refract(d, distance, f, at(tau), lens);
        const Real value = ray ? ray->aperture_point[e] : at(tau)[e] - f[e];
        return value < 0 ? -1 : 1;
    };
    Real low, high;
    if (d.ior > 1) {
        const Real limit = d.thickness * d.thickness / (d.ior * d.ior - 1) - h * h;
        if (limit <= 0) return std::nullopt;
        high = std::sqrt(limit);
        if (high * a[e] <= std::fabs(h * b[e])) return std::nullopt;
    } else {
        for (high = d.thickness + std::fabs(h); side(high) < 0 || side(-high) > 0; high *= 2) {}
    }
    low = -high;
    for (int step = 0; step < 200; step++) {
        const Real middle = (low + high) / 2;
        if (middle <= low || middle >= high) break;
        (side(middle) < 0 ? low : high) = middle;
    }
    return refract(d, distance, f, at((low + high) / 2), lens);
}

/// Ties: the pole nearest to the sheet's centre, then least x, then least y.
bool wins_tie(const Description& d, Lens one, Lens other)
{
    const Real tie = 1e-9L * d.pitch;
    const Real mine = lens_distance(d, {0, 0}, one), theirs = lens_distance(d, {0, 0}, other);
    if (std::fabs(mine - theirs) > tie) return mine < theirs;
    const Point2 p = pole(d, one), q = pole(d, other);
    if (std::fabs(p[0] - q[0]) > tie) return p[0] < q[0];
    return p[1] < q[1];
}

/// 1 where A is on the aperture's edge, less inside.
Real edge_ratio(const Description& d, Point2 size, Point2 a)
{
    const Real x = std::fabs(a[0]) / (size[0] / 2), y = std::fabs(a[1]) / (size[1] / 2);
    if (d.arrangement == "lenticular") return horizontal_slit(d) ? x : y;
    return d.shape == "ellipse" ? std::hypot(x, y) : std::max(x, y);
}

bool inside(Real ratio, Real& margin)
{
    margin = std::min(margin, std::fabs(ratio - 1));
    return ratio <= 1 + 1e-9L;
}

/// How far a lens that images the aperture can be from the film point: within total reflection, and near enough for A
/// to be in an aperture of this size, since |A| >= |delta| (1 + d/t) - |F| for the refracted ray as for the straight one.
Real search_reach(const Description& d, Real distance, Point2 f, Point2 size)
{
    const Real straight = (std::hypot(f[0], f[1]) + std::hypot(size[0], size[1])) / (1 + distance / d.thickness);
    if (d.ior <= 1) return straight + d.pitch;
    return std::min(straight, d.thickness / std::sqrt(d.ior * d.ior - 1)) + d.pitch;
}

std::optional<SheetRay> closest(const Description& d, Real distance, Point2 f, Point2 size, Real& margin)
{
    Real least = infinity;
    each_lens(d, f, 2 * d.pitch, [&](Lens lens) { least = std::min(least, lens_distance(d, f, lens)); });
    std::optional<Lens> best;
    each_lens(d, f, least + d.pitch / 2, [&](Lens lens) {
        const Real more = lens_distance(d, f, lens) - least;
        if (more > 1e-12L * d.pitch) margin = std::min(margin, more / d.pitch);
        if (more > 1e-9L * d.pitch) return;
        if (!best || wins_tie(d, lens, *best)) best = lens;
    });
    const auto ray = ray_through(d, distance, f, *best);
    if (!ray || !inside(edge_ratio(d, size, ray->aperture_point), margin)) return std::nullopt;
    return ray;
}

std::optional<SheetRay> accurate(const Description& d, Real distance, Point2 f, Point2 size, Real& margin)
{
    const auto away = [&](const SheetRay& ray) {
        if (d.arrangement == "lenticular") return std::fabs(ray.aperture_point[horizontal_slit(d) ? 0 : 1]);
        return std::hypot(ray.aperture_point[0], ray.aperture_point[1]);
    };
    std::optional<SheetRay> best;
    each_lens(d, f, search_reach(d, distance, f, size), [&](Lens lens) {
        const auto ray = ray_through(d, distance, f, lens);
        if (!ray || !inside(edge_ratio(d, size, ray->aperture_point), margin)) return;
        if (!best) { best = ray; return; }
        const Real difference = away(*ray) - away(*best);
        const Real scale = std::hypot(size[0], size[1]);
        if (std::fabs(difference) > 1e-12L * scale) margin = std::min(margin, std::fabs(difference) / scale);
        if (std::fabs(difference) > 1e-9L * d.pitch ? difference < 0 : wins_tie(d, lens, best->lens)) best = ray;
    });
    return best;
}

} // namespace

std::optional<SheetRay> ray_through(const Description& d, Real distance, Point2 f, Lens lens)
{
    if (d.arrangement == "lenticular") return slit_ray(d, distance, f, lens);
    return refract(d, distance, f, pole(d, lens), lens);
}

Point2 film_from_pixel(const Description& d, Real px, Real py)
{
    const Point2 pixel = d.pixel_pitch ? *d.pixel_pitch : Point2{25.4L / d.dpi[0], 25.4L / d.dpi[1]};
    return {(px - d.width / 2.0L) * pixel[0], (d.height / 2.0L - py) * pixel[1]};
}

Point2 aperture_size(const Description& d, Real distance)
{
    if (d.aperture) return *d.aperture;
    const auto filling = [&](Real cell) {
        const Real half = cell / 2, sine = d.ior * half / std::hypot(half, d.thickness);
        if (sine >= 1) throw std::invalid_argument("no finite aperture fills this sheet");
        return 2 * distance * sine / std::sqrt(1 - sine * sine);
    };
    const Real angle = d.slant * pi / 180;
    if (d.arrangement == "lenticular") {
        // The other extent is the slit's height and decides nothing.
        return horizontal_slit(d) ? Point2{filling(d.pitch / std::cos(angle)), infinity}
                                  : Point2{infinity, filling(d.pitch / std::fabs(std::sin(angle)))};
    }
    return {filling(d.pitch), filling(d.arrangement == "hexagonal" ? 2 * d.pitch / std::sqrt(3.0L) : d.pitch)};
}

std::optional<SheetRay> film_ray(const Description& d, Real distance, Point2 f, Real& margin)
{
    Point2 size = aperture_size(d, distance);
    if (d.arrangement == "lenticular") size[horizontal_slit(d) ? 1 : 0] = 0;
    if (d.mapping == "closest") return closest(d, distance, f, size, margin);
    if (d.mapping == "auto")
        if (const auto ray = closest(d, distance, f, size, margin)) return ray;
    return accurate(d, distance, f, size, margin);
}

} // namespace oracle
