// SPDX-License-Identifier: AGPL-3.0-or-later
// The oracle's film: which lens images a film point, and the rays of a pixel.
#include "oracle_lenses.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace oracle {
namespace {

/// The position of the description's channel in its pixel: pixels to the right and up.
Point2 subpixel_shift(const Description& d, Real px, Real py)
{
    const Real third = (d.channel - 1) / 3.0L;
    if (d.subpixels == "rgb")
        return {third, 0};
    if (d.subpixels == "bgr")
        return {-third, 0};
    if (d.subpixels == "vrgb")
        return {0, -third};
    if (d.subpixels == "vbgr")
        return {0, third};
    if (d.subpixels != "cells")
        return {0, 0};
    const int column = int(std::floor(px)), row = int(std::floor(py)),
              number = int(d.places.size() / 3);
    const std::map<std::string, int> cells{{"same", 0},
                                           {"checkerboard", (column + row) % 2},
                                           {"columns", column % 2},
                                           {"rows", row % 2},
                                           {"staggered", (row + 2 * (column % 2)) % 4}};
    return d.places.at(3 * (cells.at(d.pattern) % number) + d.channel);
}

/// Width and height of a colour's area, in pixels.
Point2 subpixel_size(const Description& d)
{
    if (d.subpixels == "none")
        return {1, 1};
    if (d.subpixels == "cells")
        return {std::sqrt(1 / 3.0L), std::sqrt(1 / 3.0L)};
    return d.subpixels[0] == 'v' ? Point2{1, 1 / 3.0L} : Point2{1 / 3.0L, 1};
}

/// The rule for ties: the pole nearest to the sheet's centre wins, then least x, then least y.
bool wins_tie(const Description& d, Lens one, Lens other)
{
    const Real tie = 1e-9L * d.pitch;
    const Real mine = lens_distance(d, {0, 0}, one), theirs = lens_distance(d, {0, 0}, other);
    if (std::fabs(mine - theirs) > tie)
        return mine < theirs;
    const Point2 p = pole(d, one), q = pole(d, other);
    if (std::fabs(p[0] - q[0]) > tie)
        return p[0] < q[0];
    return p[1] < q[1];
}

/// The position of A in the aperture: 1 on its edge, less inside.
Real edge_ratio(const Description& d, Point2 size, Point2 a)
{
    const Real x = std::fabs(a[0]) / (size[0] / 2), y = std::fabs(a[1]) / (size[1] / 2);
    if (d.arrangement == "lenticular")
        return horizontal_slit(d) ? x : y;
    return d.shape == "ellipse" ? std::hypot(x, y) : std::max(x, y);
}

bool inside(Real ratio, Real& margin)
{
    margin = std::min(margin, std::fabs(ratio - 1));
    return ratio <= 1 + 1e-9L;
}

/// How far a lens that images the aperture can be from the film point: within total reflection, and
/// near enough for A to be in an aperture of this size, since |A| >= |delta| (1 + d/t) - |F| for
/// the refracted ray as for the straight one.
Real search_reach(const Description& d, Real distance, Point2 f, Point2 size)
{
    const Real straight = (std::hypot(f[0], f[1]) + std::hypot(size[0], size[1])) /
                          (1 + distance / d.thickness);
    const Real n = index(d);
    if (n <= 1)
        return straight + d.pitch;
    return std::min(straight, d.thickness / std::sqrt(n * n - 1)) + d.pitch;
}

std::optional<SheetRay> closest(const Description& d, Real distance, Point2 f, Point2 size,
                                Real& margin)
{
    Real least = infinity;
    each_lens(d, f, 2 * d.pitch,
              [&](Lens lens) { least = std::min(least, lens_distance(d, f, lens)); });
    std::optional<Lens> best;
    each_lens(d, f, least + d.pitch / 2, [&](Lens lens) {
        const Real more = lens_distance(d, f, lens) - least;
        if (more > 1e-12L * d.pitch)
            margin = std::min(margin, more / d.pitch);
        if (more > 1e-9L * d.pitch)
            return;
        if (!best || wins_tie(d, lens, *best))
            best = lens;
    });
    const auto ray = ray_through(d, distance, f, *best);
    if (!ray || !inside(edge_ratio(d, size, ray->aperture_point), margin))
        return std::nullopt;
    return ray;
}

std::optional<SheetRay> accurate(const Description& d, Real distance, Point2 f, Point2 size,
                                 Real& margin)
{
    const auto away = [&](const SheetRay& ray) {
        if (d.arrangement == "lenticular")
            return std::fabs(ray.aperture_point[horizontal_slit(d) ? 0 : 1]);
        return std::hypot(ray.aperture_point[0], ray.aperture_point[1]);
    };
    std::optional<SheetRay> best;
    each_lens(d, f, search_reach(d, distance, f, size), [&](Lens lens) {
        const auto ray = ray_through(d, distance, f, lens);
        if (!ray || !inside(edge_ratio(d, size, ray->aperture_point), margin))
            return;
        if (!best) {
            best = ray;
            return;
        }
        const Real difference = away(*ray) - away(*best);
        const Real scale = std::hypot(size[0], size[1]);
        if (std::fabs(difference) > 1e-12L * scale)
            margin = std::min(margin, std::fabs(difference) / scale);
        if (std::fabs(difference) > 1e-9L * d.pitch ? difference < 0
                                                    : wins_tie(d, lens, best->lens))
            best = ray;
    });
    return best;
}

/// The slit's height where the pole's ray passes the aperture.
Real slit_height(const Description& d, const SheetRay& ray)
{
    if (d.arrangement != "lenticular" || !d.aperture)
        return 0;
    const int e = horizontal_slit(d) ? 1 : 0;
    const Real across = (*d.aperture)[e],
               along = ray.aperture_point[1 - e] / ((*d.aperture)[1 - e] / 2);
    return d.shape == "ellipse" ? across * std::sqrt(std::max<Real>(0, 1 - along * along)) : across;
}

/// Whether a point at `offset` from a lens's pole is nearer to no other lens.
bool in_cell(const Description& d, Point2 offset)
{
    Description unmoved = d;
    unmoved.offset = {0, 0};
    const Real own = lens_distance(unmoved, offset, {0, 0});
    bool nearest = true;
    each_lens(unmoved, offset, own,
              [&](Lens lens) { nearest = nearest && lens_distance(unmoved, offset, lens) >= own; });
    return nearest;
}

/// Chooses a ray of the display prefilter: a point about the pixel's centre and one about its
/// lens's pole, each coordinate with the density of a tent. A coordinate is found from its number
/// by the inverse of the cumulated density, which on either side is 1/2 - (1 - a)^2/2.
std::optional<SheetRay> prefiltered(const Description& d, Real distance, Point2 pixel,
                                    const SheetRay& centre, bool pole_only, const Numbers& x)
{
    const bool lenticular = d.arrangement == "lenticular";
    std::array<Real, 4> at{}; // two in pixels, two in pitches of lenses and of their rows
    for (int k = 0; k < 4; k++) {
        const bool fixed = k < 2 ? d.pixel_samples == 1 : pole_only || (lenticular && k == 3);
        if (fixed)
            continue;
        const Real side = 2 * x[k] - 1;
        at[k] = std::copysign(1 - std::sqrt(1 - std::fabs(side)), side);
    }
    const Real angle = d.slant * pi / 180;
    const Point2 area = subpixel_size(d),
                 f = film_from_pixel(d, pixel[0] + at[0] * area[0], pixel[1] + at[1] * area[1]);
    const Real u = at[2] * d.pitch,
               v = at[3] * d.pitch * (d.arrangement == "hexagonal" ? std::sqrt(3.0L) / 2 : 1);
    LensPoint point;
    point.offset = {u * std::cos(angle) - v * std::sin(angle),
                    u * std::sin(angle) + v * std::cos(angle)};
    return beam_ray(d, distance, f, centre.lens, point);
}

} // namespace

std::vector<SheetRay> pixel_rays(const Description& d, Real distance, int i, int j, int count,
                                 const std::function<Numbers()>& next)
{
    std::vector<SheetRay> rays;
    Real margin = 1;
    const auto centre = film_ray(d, distance, film_from_pixel(d, i + 0.5L, j + 0.5L), margin);
    if (!centre)
        return rays;
    const Real angle = d.slant * pi / 180;
    const Point2 area = subpixel_size(d);
    const bool lenticular = d.arrangement == "lenticular",
               pole_only = d.beam_samples == 1 ||
                           (d.beam_samples == 0 && !curved(d) &&
                            !(lenticular && slit_height(d, {{}, {0, 0}, {}}) > 0));
    for (int tries = 0; int(rays.size()) < count && tries < 1000 * count; tries++) {
        if (d.display_prefilter) {
            if (const auto ray = prefiltered(d, distance, {i + 0.5L, j + 0.5L}, *centre, pole_only,
                                             next()))
                rays.push_back(*ray);
            continue;
        }
        const Numbers x = next();
        const Point2 moved = d.pixel_samples > 1
                                 ? Point2{(x[0] - 0.5L) * area[0], (x[1] - 0.5L) * area[1]}
                                 : Point2{0, 0};
        const Point2 f = film_from_pixel(d, i + 0.5L + moved[0], j + 0.5L + moved[1]);
        const auto own = d.pixel_samples > 1 ? film_ray(d, distance, f, margin) : centre;
        if (!own || own->lens.first != centre->lens.first ||
            own->lens.second != centre->lens.second)
            continue;
        LensPoint point;
        if (!pole_only) {
            // The square about the lens is larger than any cell; a cylinder is as wide as its
            // pitch.
            const Real u = (x[2] - 0.5L) * 2 * d.pitch,
                       v = lenticular ? 0 : (x[3] - 0.5L) * 2 * d.pitch;
            point.offset = {u * std::cos(angle) - v * std::sin(angle),
                            u * std::sin(angle) + v * std::cos(angle)};
            if (!in_cell(d, point.offset))
                continue;
            point.eta = (x[3] - 0.5L) * slit_height(d, *own);
        }
        if (const auto ray = beam_ray(d, distance, f, centre->lens, point))
            rays.push_back(*ray);
    }
    return rays;
}

Point2 film_from_pixel(const Description& d, Real px, Real py)
{
    const Point2 pixel = d.pixel_pitch ? *d.pixel_pitch
                                       : Point2{25.4L / d.dpi[0], 25.4L / d.dpi[1]};
    const Point2 shift = subpixel_shift(d, px, py);
    return {(px + shift[0] - d.width / 2.0L) * pixel[0],
            (d.height / 2.0L - py + shift[1]) * pixel[1]};
}

Point2 aperture_size(const Description& d, Real distance)
{
    if (d.aperture)
        return *d.aperture;
    const auto filling = [&](Real cell) {
        const Real half = cell / 2, sine = index(d) * half / std::hypot(half, d.thickness);
        if (sine >= 1)
            throw std::invalid_argument("no finite aperture fills this sheet");
        return 2 * distance * sine / std::sqrt(1 - sine * sine);
    };
    const Real angle = d.slant * pi / 180;
    if (d.arrangement == "lenticular") {
        // The other extent is the slit's height and decides nothing.
        return horizontal_slit(d) ? Point2{filling(d.pitch / std::cos(angle)), infinity}
                                  : Point2{infinity, filling(d.pitch / std::fabs(std::sin(angle)))};
    }
    // The upright rectangle around the turned cell, from its corners.
    const bool hexagonal = d.arrangement == "hexagonal";
    const int corners = hexagonal ? 6 : 4;
    const Real radius = d.pitch / std::sqrt(hexagonal ? 3.0L : 2.0L);
    Point2 farthest{0, 0};
    for (int k = 0; k < corners; ++k) {
        const Real at = angle + (2 * k + 1) * pi / corners;
        farthest = {std::fmax(farthest[0], radius * std::cos(at)),
                    std::fmax(farthest[1], radius * std::sin(at))};
    }
    return {filling(2 * farthest[0]), filling(2 * farthest[1])};
}

std::optional<SheetRay> film_ray(const Description& d, Real distance, Point2 f, Real& margin)
{
    Point2 size = aperture_size(d, distance);
    if (d.arrangement == "lenticular")
        size[horizontal_slit(d) ? 1 : 0] = 0;
    if (d.mapping == "closest")
        return closest(d, distance, f, size, margin);
    if (d.mapping == "auto")
        if (const auto ray = closest(d, distance, f, size, margin))
            return ray;
    return accurate(d, distance, f, size, margin);
}

} // namespace oracle
