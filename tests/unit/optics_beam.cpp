// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares every lens model, forward and inverse, with 100-digit arithmetic, over the ranges of
// optics.md section 7 and in named worst cases. The errors go to the table of doc/numerics.md.
#include "tests/unit/numerics_table.h"
#include "tests/unit/optics_beam_oracle.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

namespace {

using oracle::Real;
using oracle::Vector;

constexpr double epsilon = 2.220446049250313e-16;
const std::string inverse = "film point (inverse)";

/// A film point, and the point of a lens where its light leaves.
struct Case {
    oracle::System system;
    LensIndex lens;
    LensPoint at;
    Vec2 film;
    bool usual = false; ///< a sheet that one could buy
    std::string worst;  ///< the name of a worst case, its row in the table; empty: by model
};

std::ostream& operator<<(std::ostream& out, const Case& c)
{
    out.precision(17);
    return out << "model " << int(c.system.model) << ' ' << c.system.sheet << " distance "
               << c.system.distance << " lens " << c.lens.i << ", " << c.lens.j << " offset "
               << c.at.offset.x << ", " << c.at.offset.y << " slit " << c.at.slit << " film "
               << c.film.x << ", " << c.film.y;
}

Vector vector(Vec3 v) { return {v.x, v.y, v.z}; }
double size(const Vec3& v) { return std::sqrt(dot(v, v)); }
Real planar(const Real& x, const Real& y) { return sqrt(x * x + y * y); }

/// Errors of a ray's direction; of the point where it leaves the lens, relative to the distances of
/// that point from the sheet's centre and from the film point; and of the aperture point, relative
/// to |point| + d/c.
struct Errors {
    double direction = 0, point = 0, aperture = 0;
};

Errors errors(const oracle::Beam& want, const Vector& point, const Vector& direction,
              const oracle::Point& aperture, double distance)
{
    const Real far = length(want.point);
    return {double(length(direction - want.direction)),
            double(length(point - want.point) / (far + want.length)),
            double(planar(aperture.x - want.aperture.x, aperture.y - want.aperture.y) /
                   (far - distance / want.direction.z))};
}

bool has_ray(const Case& c) { return oracle::beam(c.system, c.film, c.lens, c.at).has_value(); }

/// Calls `visit` with the case after changing one input by `units` in the last place, for every
/// input. (n has no rounding error: n - 1 is exact.)
template <class Visit> void for_each_neighbour(const Case& c, double units, Visit visit)
{
    const double by = units * epsilon;
    for (double sign : {-by, by}) {
        const double film = sign * (length(c.film) + length(Lattice(c.system.sheet).pole(c.lens)) +
                                    c.system.sheet.pitch);
        Case moved[] = {c, c, c, c, c, c, c, c};
        moved[0].film.x += film;
        moved[1].film.y += film;
        moved[2].at.offset = (1 + sign) * c.at.offset;
        moved[3].system.sheet.thickness *= 1 + sign;
        moved[4].system.sheet.ior += sign * (c.system.sheet.ior - 1);
        moved[5].at.slit *= 1 + sign;
        moved[6].system.distance *= 1 + sign;
        moved[7].system.sheet.slant += 57 *
                                       sign; // 57 degrees are 1 radian: turns the axes by `sign`
        for (const Case& one : moved)
            if (slit_is_horizontal(one.system.sheet) == slit_is_horizontal(c.system.sheet))
                visit(one);
    }
}

/// The change of the ray when inputs change by two units in the last place, summed over all inputs.
/// Nothing if such a change decides whether there is a ray.
std::optional<Errors> sensitivity(const Case& c, const std::optional<oracle::Beam>& want)
{
    Errors sum;
    bool decided = true;
    for_each_neighbour(c, 2, [&](const Case& moved) {
        const auto other = oracle::beam(moved.system, moved.film, moved.lens, moved.at);
        decided = decided && other.has_value() == want.has_value();
        if (!other || !want)
            return;
        const Errors e = errors(*want, other->point, other->direction, other->aperture,
                                c.system.distance);
        sum = {sum.direction + e.direction, sum.point + e.point, sum.aperture + e.aperture};
    });
    return decided ? std::optional(sum) : std::nullopt;
}

/// The bound of optics.md section 7, at least 1e-12: 16 eps kappa, kappa = (cosine inside / cosine
/// outside)^2 = t^2/(t^2 - m rho^2), on curved surfaces with the smaller of the cosine outside and
/// the cosine to the sheet's normal; and the film point's rounding.
double allowed_forward(const Case& c, const oracle::Beam& want)
{
    const double least = double((std::min)(want.cos_outside, Real(-want.direction.z)));
    const double kappa = std::pow(double(want.cos_inside) / least, 2);
    const double far = length(c.film) + double(length(want.point));
    return std::max(1e-12, 16 * epsilon * kappa * (1 + far / double(want.length)));
}

/// Checks an error, and records it. A worst case has one row for all errors of its ray.
void judge(const Case& c, const std::string& quantity, double error, double allowed)
{
    BOOST_TEST(error <= allowed, quantity);
    if (c.worst.empty())
        numerics::record(std::string(c.system.curved() ? "curved surface, " : "ideal beam, ") +
                             (c.system.lenticular() ? "lenticular" : "square, hexagonal"),
                         quantity, c.usual, error, allowed);
    else
        numerics::record(c.worst, quantity == inverse ? inverse : "ray", c.usual, error, allowed);
}

std::optional<BeamRay> check_forward(const Case& c)
{
    const SheetOptics optics(c.system.sheet, Aperture{c.system.distance, 1, 1}, c.system.model);
    const auto got = beam_ray(optics, c.film, c.lens, c.at);
    const auto want = oracle::beam(c.system, c.film, c.lens, c.at);
    if (got) {
        for (double value : {got->point.x, got->point.y, got->point.z, got->aperture_point.x,
                             got->aperture_point.y})
            BOOST_TEST(std::isfinite(value));
        BOOST_TEST(std::fabs(size(got->direction) - 1) <= 1e-12);
        BOOST_TEST(got->direction.z < 0);
    }
    if (got.has_value() != want.has_value()) {
        // The two may differ only where rounding decides: where a change of the input by sixteen
        // units in the last place matters, or where the ray leaves the lens or the sheet at such a
        // flat angle that the bound of its error is no longer small.
        bool decided = want ? allowed_forward(c, *want) < 1e-3
                            : 16 * epsilon *
                                      (1 + (length(c.film) + size(got->point)) /
                                               c.system.sheet.thickness) <
                                  1e-3 * std::pow(got->direction.z, 2);
        for_each_neighbour(c, 16, [&](const Case& moved) {
            decided = decided && has_ray(moved) == want.has_value();
        });
        BOOST_TEST(!decided, "a ray for one, none for the other");
        return std::nullopt;
    }
    if (!want)
        return std::nullopt;
    const double bound = allowed_forward(c, *want);
    if (bound > 0.1)
        return got;
    const Errors error = errors(*want, vector(got->point), vector(got->direction),
                                {got->aperture_point.x, got->aperture_point.y}, c.system.distance);
    Errors allowed{bound, bound, bound};
    if (error.direction > bound || error.point > bound || error.aperture > bound) {
        const auto inherent = sensitivity(c, want);
        if (!inherent)
            return got;
        allowed = {bound + inherent->direction, bound + inherent->point,
                   bound + inherent->aperture};
    }
    judge(c, "direction", error.direction, allowed.direction);
    judge(c, "point of the lens", error.point, allowed.point);
    judge(c, "aperture point", error.aperture, allowed.aperture);
    return got;
}

/// Error of a film point, relative to the distance of the lens's point from the sheet's centre plus
/// the path's length inside the lens.
double film_error(const oracle::Inverse& want, const oracle::Point& film)
{
    return double(planar(film.x - want.film.x, film.y - want.film.y) /
                  (length(want.from) + want.length));
}

void check_inverse(const Case& c, Vec3 scene)
{
    BOOST_TEST_CONTEXT("scene point " << scene.x << ", " << scene.y << ", " << scene.z)
    {
        const SheetOptics optics(c.system.sheet, Aperture{c.system.distance, 1, 1}, c.system.model);
        const auto got = film_point_imaging(optics, scene, c.lens, c.at);
        const auto want = oracle::imaging(c.system, vector(scene), c.lens, c.at);
        if (got)
            BOOST_TEST((std::isfinite(got->x) && std::isfinite(got->y)));
        double inherent = 0;
        bool decided = true;
        const auto neighbours = [&](double units) {
            const auto visit = [&](const Case& moved, Vec3 point) {
                const auto other = oracle::imaging(moved.system, vector(point), moved.lens,
                                                   moved.at);
                decided = decided && other.has_value() == want.has_value();
                if (other && want)
                    inherent += film_error(*want, other->film);
            };
            for_each_neighbour(c, units, [&](const Case& moved) { visit(moved, scene); });
            const double far = units * epsilon *
                               (size(scene) + length(Lattice(c.system.sheet).pole(c.lens)));
            for (double sign : {-far, far}) {
                visit(c, scene + Vec3{sign, 0, 0});
                visit(c, scene + Vec3{0, sign, 0});
                visit(c, scene + Vec3{0, 0, sign});
            }
        };
        if (got.has_value() != want.has_value()) {
            neighbours(16);
            // or where rounding the film point itself decides whether it has a ray
            Case back = c;
            back.film = got ? *got : Vec2{double(want->film.x), double(want->film.y)};
            const bool lit = has_ray(back);
            for_each_neighbour(
                back, 16, [&](const Case& moved) { decided = decided && has_ray(moved) == lit; });
            BOOST_TEST(!decided, "a film point for one, none for the other");
            return;
        }
        if (!want)
            return;
        // The direction's rounding, magnified by the path inside; kappa is that path divided by the
        // depth. Lenticular: also the rounding of the axis point, which is computed from the slit.
        const double kappa = double(want->length / want->depth), from = double(length(want->from));
        const double near = double(length(vector(scene) - want->from));
        double relative = kappa * (1 + (size(scene) + from) / near);
        if (c.system.lenticular()) {
            const double g = std::fabs(dot(optics.slit().normal, optics.slit().axis)),
                         d = c.system.distance;
            const double way = std::fabs(scene.z + d);
            const double slit = ((std::fabs(c.at.slit * scene.z) + size(scene) * d) / way + from) /
                                g;
            relative += slit * (1 / (from + double(want->length)) + kappa / near);
        }
        const double bound = std::max(1e-12, 16 * epsilon * relative);
        const double error = film_error(*want, {got->x, got->y});
        double allowed = bound;
        if (error > bound) {
            neighbours(2);
            if (!decided)
                return;
            allowed += inherent;
        }
        judge(c, inverse, error, allowed);
    }
}

/// Checks a case forward, then inversely from points of the ray in front of and behind the sheet,
/// and from a random point.
void check(const Case& c, random_sheets::Generator& random)
{
    BOOST_TEST_CONTEXT(c)
    {
        const double reach = random.log_between(0.01, 1e3) * c.system.distance;
        if (const auto ray = check_forward(c))
            for (double way : {reach, -reach})
                check_inverse(c, ray->point + way * ray->direction);
        const Vec2 pole = Lattice(c.system.sheet).pole(c.lens);
        const double x = random.between(-reach, reach), y = random.between(-reach, reach);
        check_inverse(c, {pole.x + x, pole.y + y, random.between(-reach, reach)});
    }
}

/// Changes n and t, if necessary, so that the lens surface reaches the cell's edge.
void give_surface(LensSheet& sheet, random_sheets::Generator& random)
{
    while (!has_surface(sheet)) {
        sheet.ior = random.one_in(4) ? 1 + random.log_between(1e-4, 1) : random.between(1, 4);
        const double least = cell_circumradius(sheet) / (sheet.ior - 1) * sheet.ior;
        if (least < 1e4 * sheet.pitch)
            sheet.thickness = random.log_between(least, 1e4 * sheet.pitch);
    }
}

Case random_case(random_sheets::Generator& random, bool usual)
{
    Case c;
    c.usual = usual;
    LensSheet& sheet = c.system.sheet;
    sheet = random.sheet();
    c.system.distance = random.distance();
    if (usual) {
        sheet.pitch = random.between(0.1, 3);
        sheet.ior = random.between(1.4, 1.7);
        sheet.thickness = sheet.pitch * random.between(0.5, 8);
        sheet.offset = {random.between(-1, 1) * sheet.pitch, random.between(-1, 1) * sheet.pitch};
        c.system.distance = random.between(100, 5000);
    }
    c.system.model = random.one_in(2)   ? LensModel::full
                     : random.one_in(3) ? LensModel::pinhole
                                        : LensModel::extended_pinhole;
    if (c.system.curved() && !usual)
        give_surface(sheet, random);
    if (c.system.curved() && !has_surface(sheet))
        sheet.thickness = sheet.pitch * random.between(2, 8);

    const Lattice lattice(sheet);
    const double reach = usual ? 300 : random.log_between(1, 1e6) * sheet.pitch;
    c.lens = lattice.nearest({random.between(-reach, reach), random.between(-reach, reach)});
    const Vec2 unit{random.between(0, 1), random.between(0, 1)};
    c.at = cell_point(lattice, unit,
                      random.one_in(2) ? c.system.distance * random.between(0, 1) : 0);
    const double near = sheet.pitch * (usual || !random.one_in(3) ? 0.7 : 2);
    c.film = lattice.pole(c.lens) + Vec2{random.between(-near, near), random.between(-near, near)};
    if (c.system.lenticular())
        c.film = c.film + (random.one_in(2) ? random.between(-reach, reach) : 0) * lattice.along();
    return c;
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_beam)

BOOST_AUTO_TEST_CASE(all_models_agree_with_100_digits)
{
    random_sheets::Generator random(3431);
    const int most = random_sheets::count(5000, 1000000);
    for (int k = 0; k < most; ++k)
        check(random_case(random, k % 4 == 0), random);
}

BOOST_AUTO_TEST_CASE(at_the_edge_of_what_a_lens_images)
{
    // Goes outwards from a film point with a ray to one without: total reflection, the slit's end,
    // or away from the viewer. Tests the edge, and 1e-12 to 1e-2 of the way before and behind it.
    random_sheets::Generator random(3432);
    const int most = random_sheets::count(400, 20000);
    for (int k = 0; k < most; ++k) {
        Case c = random_case(random, false);
        c.worst = "edge of what a lens images";
        const SheetOptics optics(c.system.sheet, Aperture{c.system.distance, 1, 1}, c.system.model);
        const double angle = random.between(0, 6.28318),
                     far = 1e3 * (c.system.sheet.thickness + c.system.sheet.pitch);
        const Vec2 start = optics.lattice().pole(c.lens),
                   way{far * std::cos(angle), far * std::sin(angle)};
        const auto lit = [&](double part) {
            return beam_ray(optics, start + part * way, c.lens, c.at).has_value();
        };
        if (!lit(0) || lit(1))
            continue;
        double low = 0, high = 1;
        for (int step = 0; step < 60; ++step)
            (lit(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
        for (double part : {0.0, 1e-12, 1e-9, 1e-5, 1e-2, -1e-9}) {
            c.film = start + low * (1 - part) * way;
            check(c, random);
        }
    }
}

BOOST_AUTO_TEST_CASE(named_worst_cases)
{
    random_sheets::Generator random(3433);
    const auto check_all = [&](const char* name, LensSheet sheet) {
        for (int arrangement = 0; arrangement < 3; ++arrangement)
            for (LensModel model : {LensModel::extended_pinhole, LensModel::full})
                for (double distance : {1.0, 300.0, 1e9}) {
                    sheet.arrangement = Arrangement(arrangement);
                    Case c{{sheet, model, distance}, {17, -6}, {}, {}, false, name};
                    if (c.system.lenticular())
                        c.lens.j = 0;
                    if (c.system.curved() && !has_surface(sheet))
                        continue;
                    const Lattice lattice(sheet);
                    const Vec2 pole = lattice.pole(c.lens);
                    const Vec2 p = sheet.pitch * lattice.across(),
                               q = sheet.pitch * lattice.along();
                    for (double u : {0.0, 0.5, 1 - epsilon})
                        for (double v : {0.0, 0.5})
                            for (double x : {-0.5, 0.3})
                                for (double y : {-0.5, 0.0}) {
                                    c.at = cell_point(lattice, {u, v}, 2);
                                    c.film = pole + x * p + y * q;
                                    check(c, random);
                                }
                }
    };
    const char* borders = "lens borders";
    check_all(borders, {Arrangement::lenticular, 1.27, 3.08, 1.6, 0, {0, 0}});
    check_all(borders, {Arrangement::lenticular, 1.27, 3.08, 1.6, -18.4349488, {0.3, -0.4}});
    for (double ior : {1.0, 1 + 1e-12})
        check_all("n = 1 and 1 + 1e-12", {Arrangement::lenticular, 1.27, 3.08, ior, 10, {0, 0}});
    for (double slant : {-89.99, 89.99, -90.0, 90.0, 45.0, 45.0000001})
        check_all("slants of 45, 89.99 and 90 degrees",
                  {Arrangement::lenticular, 1.27, 3.08, 1.6, slant, {0, 0}});
    for (double ratio : {0.02, 1e4})
        check_all("t/p of 0.02 and 10 000",
                  {Arrangement::lenticular, 1.27, 1.27 * ratio, 1.6, 30, {0, 0}});
}

BOOST_AUTO_TEST_CASE(surface_that_just_reaches_the_edge)
{
    // R is the cell's circumradius: the surface is vertical there
    const char* name = "R equal to the cell's circumradius";
    random_sheets::Generator random(3434);
    for (int arrangement = 0; arrangement < 3; ++arrangement)
        for (double ior : {1.01, 1.3, 1.5, 1.9, 4.0})
            for (double slant : {0.0, 30.0, -89.99, 90.0}) {
                LensSheet sheet{Arrangement(arrangement), 1.27, 1, ior, slant, {0, 0}};
                sheet.thickness = cell_circumradius(sheet) / (ior - 1) * ior;
                while (!has_surface(sheet))
                    sheet.thickness = std::nextafter(sheet.thickness, 1e9);
                const Lattice lattice(sheet);
                for (double u : {0.0, 1e-12, 0.01, 0.3, 0.5, 1 - epsilon})
                    for (double v : {0.0, 0.5, 0.99999})
                        for (double x : {-0.6, -0.1, 0.0, 0.4}) {
                            Case c{{sheet, LensModel::full, 300},
                                   {},
                                   cell_point(lattice, {u, v}),
                                   {},
                                   false,
                                   name};
                            c.film = sheet.pitch * (x * lattice.across() + 0.1 * lattice.along());
                            check(c, random);
                        }
            }
}

BOOST_AUTO_TEST_CASE(light_through_the_edge_of_the_aperture)
{
    // A film point found for a point of the aperture's edge sends its light to that edge. (A point
    // in the slit's own plane has no single film point; there, points just behind it are used.)
    random_sheets::Generator random(3435);
    const int most = random_sheets::count(1000, 100000);
    for (int k = 0; k < most; ++k) {
        Case c = random_case(random, false);
        c.worst = "light through the aperture's edge";
        const auto fill = filling_aperture(c.system.sheet, c.system.distance);
        if (!fill)
            continue;
        const Aperture aperture = *fill;
        const SheetOptics optics(c.system.sheet, aperture, c.system.model);
        const double z = c.system.lenticular() ? -0.75 * aperture.distance : -aperture.distance;
        const Vec3 edge{0.5 * aperture.width, 0.5 * aperture.height, z};
        BOOST_TEST_CONTEXT(c)
        {
            check_inverse(c, edge);
            if (const auto film = film_point_imaging(optics, edge, c.lens, c.at)) {
                c.film = *film;
                check_forward(c);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
