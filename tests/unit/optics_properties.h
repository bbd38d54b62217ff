// SPDX-License-Identifier: AGPL-3.0-or-later
// Shared by the tests of all lens mappings: random sheets with apertures, film points at which
// mappings are difficult to decide, and comparisons of results.
#ifndef TESTS_UNIT_OPTICS_PROPERTIES_H
#define TESTS_UNIT_OPTICS_PROPERTIES_H

#include "tests/unit/optics_sheets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace random_systems {

using namespace integral;
using random_sheets::Generator;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A sheet and its aperture.
struct System {
    LensSheet sheet;
    Aperture aperture;
    SheetOptics optics() const { return SheetOptics(sheet, aperture); }
    bool lenticular() const { return sheet.arrangement == Arrangement::lenticular; }
    /// The least factor by which the map from lens offsets to aperture points stretches lengths.
    double stretch() const { return 1 + sheet.ior * aperture.distance / sheet.thickness; }
    double total_reflection() const
    {
        return sheet.thickness / std::sqrt((sheet.ior - 1) * (sheet.ior + 1));
    }
};

inline std::ostream& operator<<(std::ostream& out, const System& s)
{
    return out << s.sheet << " aperture " << s.aperture.distance << ": " << s.aperture.width
               << " x " << s.aperture.height
               << (s.aperture.shape == ApertureShape::ellipse ? ", ellipse" : "");
}

/// A random system. The aperture has 1/20 to 20 times the size that fills a lens; sometimes its
/// width, its height or both are unlimited.
inline System random_system(Generator& random)
{
    System s;
    s.sheet = random.sheet();
    if (random.one_in(2))
        s.sheet.thickness = s.sheet.pitch * random.log_between(0.3, 30);
    s.aperture.distance = random.one_in(2) ? random.distance()
                                           : s.sheet.thickness * random.log_between(0.5, 3000);
    const double filling = s.sheet.pitch * s.stretch();
    const auto extent = [&] {
        return filling *
               (random.one_in(2) ? random.between(0.9, 1.2) : random.log_between(0.05, 20));
    };
    s.aperture.width = extent();
    s.aperture.height = random.one_in(3) ? extent() : s.aperture.width;
    if (random.one_in(12))
        (random.one_in(2) ? s.aperture.width : s.aperture.height) = random.one_in(2) ? infinity
                                                                                     : 1e12;
    s.aperture.shape = random.one_in(3) ? ApertureShape::ellipse : ApertureShape::rectangle;
    return s;
}

/// A system whose decisions hardly depend on rounding.
inline System plain_system(Generator& random)
{
    System s = random_system(random);
    s.sheet.thickness = s.sheet.pitch * random.log_between(0.5, 20);
    s.aperture.distance = s.sheet.thickness * random.log_between(2, 300);
    const double filling = s.sheet.pitch * s.stretch();
    s.aperture.width = filling * random.between(0.3, 3);
    s.aperture.height = filling * random.between(0.3, 3);
    return s;
}

inline Vec2 direction_at(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The film point whose light goes through `pole` to a point of the aperture's plane.
inline Vec2 film_point_through(const SheetOptics& optics, Vec2 pole, Vec2 aperture_point)
{
    const Vec2 way = aperture_point - pole;
    const double d = optics.aperture().distance, length_3 = std::sqrt(dot(way, way) + d * d);
    return pole - offset_from_direction(optics.medium(),
                                        {way.x / length_3, way.y / length_3, -d / length_3});
}

/// A film point up to 1e6 lenses from the centre (less if a search of all lenses would take too
/// long), or a point within 1e-8 of a place where a decision changes: where two lenses are equally
/// near, where the light meets the aperture's edge, or where the aperture points of two lenses are
/// equally near to the aperture's centre.
inline Vec2 random_film_point(Generator& random, const System& s, const SheetOptics& optics)
{
    const double pitch = s.sheet.pitch, most = 30 * pitch;
    double farthest = 1e6 * pitch;
    if (s.total_reflection() > most)
        farthest = std::min(farthest, most * s.stretch());
    const double far = random.log_between(1e-3, std::max(1.0, farthest / pitch)) * pitch;
    const Vec2 anywhere = far * direction_at(random.between(0, 6.3));
    const double near_0 = random.one_in(4)
                              ? 0
                              : (random.one_in(2) ? -1 : 1) * random.log_between(1e-11, 1e-8);
    if (random.one_in(2))
        return anywhere;
    const Lattice& lattice = optics.lattice();
    const LensIndex lens = lattice.nearest(anywhere),
                    other{lens.i + 1, lens.j - (!s.lenticular() && random.one_in(2))};
    const Vec2 pole = lattice.pole(lens), way = lattice.pole(other) - pole;
    if (random.one_in(3))
        return pole + (0.5 + near_0) * way +
               (random.one_in(2) ? 0 : random.between(-0.6, 0.6)) * Vec2{-way.y, way.x};
    const double widest = 1e6 * pitch, x = std::min(s.aperture.width, widest),
                 y = std::min(s.aperture.height, widest);
    if (random.one_in(2)) {
        Vec2 edge{0.5 * x * (1 + near_0), y * random.between(-0.5, 0.5)};
        if (!slit_is_horizontal(s.sheet) || (!s.lenticular() && random.one_in(2)))
            edge = {x * random.between(-0.5, 0.5), 0.5 * y * (1 + near_0)};
        if (s.lenticular())
            (slit_is_horizontal(s.sheet) ? edge.y : edge.x) = 0;
        return film_point_through(optics, pole, edge);
    }
    Vec2 low = film_point_through(optics, pole, {0, 0}),
         high = film_point_through(optics, pole + way, {0, 0});
    for (int step = 0; step < 60; ++step) {
        const Vec2 middle = 0.5 * (low + high);
        const auto a = optics.ray_through(middle, lens), b = optics.ray_through(middle, other);
        if (!a || !b)
            return middle;
        (length(a->aperture_point) < length(b->aperture_point) ? low : high) = middle;
    }
    return low + near_0 * way;
}

/// A film point at a random place of the sheet, at most `lenses` from its centre.
inline Vec2 plain_film_point(Generator& random, const System& s, double lenses)
{
    return random.between(0, lenses) * s.sheet.pitch * direction_at(random.between(0, 6.3));
}

inline bool equal(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }

/// Whether lens and ray are the same, bit for bit.
inline bool equal(const LensRay& a, const LensRay& b)
{
    return a.lens == b.lens && equal(a.pole, b.pole) && equal(a.aperture_point, b.aperture_point) &&
           a.direction.x == b.direction.x && a.direction.y == b.direction.y &&
           a.direction.z == b.direction.z;
}

inline bool equal(const MappedPoint& a, const MappedPoint& b)
{
    return a.ray.has_value() == b.ray.has_value() && (!a.ray || equal(*a.ray, *b.ray));
}

/// Whether two systems have the same rays for corresponding film points, except for rounding, after
/// `undo` is applied to `b`'s rays.
template <class Undo>
bool alike(const MappedPoint& a, const MappedPoint& b, const System& s, Undo undo)
{
    if (!a.ray || !b.ray)
        return a.ray.has_value() == b.ray.has_value();
    const Vec2 pole = a.ray->pole - undo(b.ray->pole),
               there = a.ray->aperture_point - undo(b.ray->aperture_point);
    return length(pole) <= 1e-6 * s.sheet.pitch &&
           length(there) <= 1e-6 * (s.sheet.pitch * s.stretch() + length(a.ray->aperture_point));
}

} // namespace random_systems

#endif
