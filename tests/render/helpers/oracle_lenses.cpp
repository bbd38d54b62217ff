// SPDX-License-Identifier: AGPL-3.0-or-later
// The oracle's lattice, and the rays of one lens.
#include "oracle_lenses.h"

namespace oracle {

Real index(const Description& d) { return d.model == "pinhole" ? 1 : d.ior; }

bool curved(const Description& d) { return d.model == "hybrid" || d.model == "full"; }

bool horizontal_slit(const Description& d) { return std::fabs(d.slant) <= 45; }

Point2 pole(const Description& d, Lens lens)
{
    const Real p = d.pitch, angle = d.slant * pi / 180;
    Point2 q{lens.first * p, 0};
    if (d.arrangement == "square")
        q[1] = lens.second * p;
    if (d.arrangement == "hexagonal") {
        q[1] = lens.second * p * std::sqrt(3.0L) / 2;
        if (lens.second % 2 != 0)
            q[0] += p / 2;
    }
    return {d.offset[0] + q[0] * std::cos(angle) - q[1] * std::sin(angle),
            d.offset[1] + q[0] * std::sin(angle) + q[1] * std::cos(angle)};
}

Real lens_distance(const Description& d, Point2 f, Lens lens)
{
    const Point2 q = pole(d, lens);
    const Real dx = q[0] - f[0], dy = q[1] - f[1], angle = d.slant * pi / 180;
    if (d.arrangement == "lenticular")
        return std::fabs(dx * std::cos(angle) + dy * std::sin(angle));
    return std::sqrt(dx * dx + dy * dy);
}

void each_lens(const Description& d, Point2 f, Real reach, const std::function<void(Lens)>& visit)
{
    const Real angle = d.slant * pi / 180, x = f[0] - d.offset[0], y = f[1] - d.offset[1];
    const Real u = x * std::cos(angle) + y * std::sin(angle),
               v = y * std::cos(angle) - x * std::sin(angle);
    const Real row = d.arrangement == "hexagonal" ? d.pitch * std::sqrt(3.0L) / 2 : d.pitch;
    const long i0 = std::floor((u - reach) / d.pitch) - 1,
               i1 = std::ceil((u + reach) / d.pitch) + 1;
    long j0 = 0, j1 = 0;
    if (d.arrangement != "lenticular")
        j0 = std::floor((v - reach) / row) - 1, j1 = std::ceil((v + reach) / row) + 1;
    for (long i = i0; i <= i1; i++)
        for (long j = j0; j <= j1; j++)
            if (lens_distance(d, f, {i, j}) <= reach)
                visit({i, j});
}

namespace {

/// A point of a lens where light leaves it: at depth z behind the poles, the normal towards the
/// viewer.
struct Exit {
    Point2 at;
    Real z = 0;
    Point3 normal{0, 0, -1};
};

/// The point `offset` from the pole (lenticular: from the axis): on the plane of the poles, or on
/// the spherical or cylindrical surface of radius t (n - 1)/n. Nothing beyond its edge.
std::optional<Exit> exit_at(const Description& d, Point2 pole, Point2 offset)
{
    if (!curved(d))
        return Exit{{pole[0] + offset[0], pole[1] + offset[1]}};
    const Real radius = d.thickness * (d.ior - 1) / d.ior, r = std::hypot(offset[0], offset[1]);
    if (r > radius)
        return std::nullopt;
    const Real rise = std::sqrt(radius * radius - r * r);
    return Exit{{pole[0] + offset[0], pole[1] + offset[1]},
                radius - rise,
                {offset[0] / radius, offset[1] / radius, -rise / radius}};
}

/// Steps 2 to 4 from film point f through a point of the lens: Snell's law in its vector form.
std::optional<SheetRay> refract(const Description& d, Real distance, Point2 f, const Exit& exit,
                                Lens lens)
{
    const Real n = index(d);
    Point3 u{exit.at[0] - f[0], exit.at[1] - f[1], exit.z - d.thickness};
    const Real length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    Real cosine = 0;
    for (int i = 0; i < 3; i++)
        u[i] /= length, cosine += u[i] * exit.normal[i];
    const Real rest = 1 - n * n * (1 - cosine * cosine);
    if (rest <= 0 || cosine <= 0)
        return std::nullopt;
    Point3 w{};
    for (int i = 0; i < 3; i++)
        w[i] = n * u[i] + (std::sqrt(rest) - n * cosine) * exit.normal[i];
    if (w[2] >= 0)
        return std::nullopt;
    const Real way = (distance + exit.z) / -w[2];
    return SheetRay{
        lens, {exit.at[0] + w[0] * way, exit.at[1] + w[1] * way}, {-w[0], -w[1], -w[2]}};
}

/// The ray of a line of a cylinder lens, v across from its axis, that meets the slit, A_y = eta or
/// A_x = eta, by bisection along the line.
std::optional<SheetRay> slit_ray(const Description& d, Real distance, Point2 f, Lens lens, Real v,
                                 Real eta)
{
    const Real angle = d.slant * pi / 180, n = index(d);
    const Point2 b{std::cos(angle), std::sin(angle)};
    const int e = horizontal_slit(d) ? 1 : 0; // the coordinate that the slit fixes
    Point2 a{-std::sin(angle), std::cos(angle)};
    if (a[e] < 0)
        a = {-a[0], -a[1]};
    const Point2 q0 = pole(d, lens);
    const Real h = (q0[0] - f[0]) * b[0] + (q0[1] - f[1]) * b[1];
    const auto line = exit_at(d, {f[0] + h * b[0], f[1] + h * b[1]},
                              {v * b[0], v * b[1]}); // where it is nearest to f
    if (!line)
        return std::nullopt;
    const auto at = [&](Real tau) {
        Exit exit = *line;
        exit.at[0] += tau * a[0], exit.at[1] += tau * a[1];
        return exit;
    };
    // The side on which the slit is missed: below (-1) or above (1). Total reflection counts as a
    // miss by an infinite distance on the same side.
    const auto side = [&](Real tau) {
        const auto ray = refract(d, distance, f, at(tau), lens);
        const Real value = ray         ? ray->aperture_point[e] - eta
                           : curved(d) ? tau * a[e]
                                       : at(tau).at[e] - f[e];
        return value < 0 ? -1 : 1;
    };
    Real low, high;
    if (n > 1) {
        const Real depth = d.thickness - line->z, to_line = h + v;
        const Real into = to_line * (line->normal[0] * b[0] + line->normal[1] * b[1]) -
                          depth * line->normal[2];
        const Real limit = into * into * n * n / (n * n - 1) - to_line * to_line - depth * depth;
        if (into <= 0 || limit <= 0)
            return std::nullopt;
        high = std::sqrt(limit);
        if (curved(d)) { // light may leave sideways before total reflection begins
            if (!refract(d, distance, f, at(0), lens))
                return std::nullopt;
            const auto end = [&](Real fails) {
                Real passes = 0;
                for (int step = 0; step < 200; step++) {
                    const Real middle = (passes + fails) / 2;
                    (refract(d, distance, f, at(middle), lens) ? passes : fails) = middle;
                }
                return passes;
            };
            low = end(-high);
            high = end(high);
            if (side(low) > 0 || side(high) < 0)
                return std::nullopt;
        } else if (high * a[e] <= std::fabs(h * b[e]))
            return std::nullopt;
        else
            low = -high;
    } else {
        for (high = d.thickness + std::fabs(h); side(high) < 0 || side(-high) > 0; high *= 2) {
        }
        low = -high;
    }
    for (int step = 0; step < 200; step++) {
        const Real middle = (low + high) / 2;
        if (middle <= low || middle >= high)
            break;
        (side(middle) < 0 ? low : high) = middle;
    }
    return refract(d, distance, f, at((low + high) / 2), lens);
}

} // namespace

std::optional<SheetRay> ray_through(const Description& d, Real distance, Point2 f, Lens lens)
{
    Description flat = d; // the pole's ray is the same for every model
    if (curved(d))
        flat.model = "extended_pinhole";
    if (d.arrangement == "lenticular")
        return slit_ray(flat, distance, f, lens, 0, 0);
    return refract(flat, distance, f, Exit{pole(d, lens)}, lens);
}

Point2 mirrored_in_lens(const Description& d, Point2 f, Lens lens)
{
    const Point2 q = pole(d, lens);
    if (d.arrangement != "lenticular")
        return {2 * q[0] - f[0], 2 * q[1] - f[1]};
    const Real angle = d.slant * pi / 180;
    const Point2 b{std::cos(angle), std::sin(angle)};
    const Real h = (q[0] - f[0]) * b[0] + (q[1] - f[1]) * b[1];
    return {f[0] + 2 * h * b[0], f[1] + 2 * h * b[1]};
}

std::optional<SheetRay> beam_ray(const Description& d, Real distance, Point2 f, Lens lens,
                                 const LensPoint& point)
{
    const Point2 q = pole(d, lens);
    const Real angle = d.slant * pi / 180;
    const Point2 b{std::cos(angle), std::sin(angle)};
    const bool lenticular = d.arrangement == "lenticular";
    if (d.pseudoscopic)
        f = mirrored_in_lens(d, f, lens);
    if (curved(d)) {
        if (lenticular)
            return slit_ray(d, distance, f, lens, point.offset[0] * b[0] + point.offset[1] * b[1],
                            point.eta);
        const auto exit = exit_at(d, q, point.offset);
        return exit ? refract(d, distance, f, *exit, lens) : std::nullopt;
    }
    auto ray = lenticular ? slit_ray(d, distance, f, lens, 0, point.eta)
                          : refract(d, distance, f, Exit{q}, lens);
    if (ray)
        ray->aperture_point[0] += point.offset[0], ray->aperture_point[1] += point.offset[1];
    return ray;
}

std::vector<LensPoint> hybrid_points(const Description& d)
{
    const Real angle = d.slant * pi / 180, half = d.pitch / 2;
    const Point2 b{half * std::cos(angle), half * std::sin(angle)}, a{-b[1], b[0]};
    if (d.arrangement == "lenticular")
        return {{}, {{-b[0], -b[1]}}, {b}};
    return {{}, {{-b[0], -b[1]}}, {b}, {{-a[0], -a[1]}}, {a}};
}

std::vector<Real> hybrid_weights(const Description& d)
{
    const auto light = [](Real place) { return std::cos(std::atan(4 * place)); };
    std::vector<Real> weights(hybrid_points(d).size(), light(1));
    weights[0] = light(0);
    Real sum = 0;
    for (const Real weight : weights)
        sum += weight;
    for (Real& weight : weights)
        weight /= sum;
    return weights;
}

} // namespace oracle
