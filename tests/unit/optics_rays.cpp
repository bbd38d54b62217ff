// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares a lens's ray and its inverse with 100-digit arithmetic over the ranges of optics.md
// section 7. Errors must be within 16 eps kappa, or 1e-12 where that is smaller.
#include "tests/unit/numerics_table.h"
#include "tests/unit/optics_oracle.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

namespace {

constexpr double epsilon = 2.220446049250313e-16;

/// Error of a direction (of unit length), and of the aperture point relative to |pole| + |film
/// point| + d/c (optics.md section 7).
struct Error {
    double direction = 0, aperture = 0;
};

template <class Got>
Error difference_of(const Got& dx, const Got& dy, const Got& dz, const Got& ax, const Got& ay,
                    const oracle::Ray& want, Vec2 film_point, double distance)
{
    const oracle::Real px = want.pole.x, py = want.pole.y;
    const oracle::Real scale = sqrt(px * px + py * py) + length(film_point) + distance / want.c;
    return {double(sqrt(dx * dx + dy * dy + dz * dz)), double(sqrt(ax * ax + ay * ay) / scale)};
}

Error difference(const LensRay& got, const oracle::Ray& want, Vec2 film_point, double distance)
{
    return difference_of<oracle::Real>(
        got.direction.x - want.s_x, got.direction.y - want.s_y, got.direction.z + want.c,
        got.aperture_point.x - want.aperture.x, got.aperture_point.y - want.aperture.y, want,
        film_point, distance);
}

/// The change of the ray when the film point and the rotation of the axes change by four units in
/// the last place.
Error sensitivity(const LensSheet& sheet, double distance, Vec2 film_point, LensIndex lens,
                  const oracle::Ray& want)
{
    Error most;
    const Vec2 p = Lattice(sheet).pole(lens);
    for (double sign : {-1.0, 1.0})
        for (int axis = 0; axis < 2; ++axis) {
            const double size = 4 * epsilon * (length(film_point) + length(p));
            Vec2 moved = film_point;
            (axis ? moved.y : moved.x) += sign * size;
            const auto other = oracle::ray(sheet, distance, moved, lens);
            if (!other)
                return {1, 1};
            const Error e = difference_of<oracle::Real>(
                other->s_x - want.s_x, other->s_y - want.s_y, other->c - want.c,
                other->aperture.x - want.aperture.x, other->aperture.y - want.aperture.y, want,
                film_point, distance);
            most.direction = std::max(most.direction, e.direction);
            most.aperture = std::max(most.aperture, e.aperture);
        }
    return {4 * most.direction, 4 * most.aperture};
}

/// Compares one ray with the oracle's. Whether there is a ray may differ only next to the border.
/// `what`: the table's row.
void check_ray(const char* what, const LensSheet& sheet, double distance, Vec2 film_point,
               LensIndex lens)
{
    BOOST_TEST_CONTEXT(sheet << " distance " << distance << " film <" << film_point.x << ", "
                             << film_point.y << "> lens " << lens.i << ", " << lens.j)
    {
        const SheetOptics optics(sheet, Aperture{distance, 1, 1});
        const auto got = optics.ray_through(film_point, lens);
        const auto want = oracle::ray(sheet, distance, film_point, lens);
        if (got.has_value() != want.has_value()) {
            // within rounding of total reflection, where 16 eps kappa is no longer small
            if (want)
                BOOST_TEST(double(16 * epsilon * want->kappa * (1 + want->offset_ratio)) > 1e-3);
            else
                BOOST_TEST(-got->direction.z < 1e-3);
            return;
        }
        if (!want)
            return;
        const bool slit = sheet.arrangement == Arrangement::lenticular;
        const oracle::Real rounding = 16 * epsilon * (1 + want->offset_ratio);
        const double bound = std::max(1e-12, double(rounding * want->kappa));
        // Where the axis point is computed from a slit, the aperture point's condition is 1/c^2
        // (optics.md section 7).
        const double aperture_bound = slit ? std::max(bound, double(rounding / (want->c * want->c)))
                                           : bound;
        if (aperture_bound > 0.1)
            return;
        const Error error = difference(*got, *want, film_point, distance);
        Error allowed{bound, aperture_bound};
        if (error.direction > bound || error.aperture > aperture_bound) {
            // A greater error is accepted only if rounding the film point has the same effect. That
            // is so near the slit's end, which kappa does not take into account.
            BOOST_TEST(slit);
            const Error inherent = sensitivity(sheet, distance, film_point, lens, *want);
            allowed = {bound + inherent.direction, aperture_bound + inherent.aperture};
        }
        numerics::record(what, "direction", false, error.direction, allowed.direction);
        numerics::record(what, "aperture point", false, error.aperture, allowed.aperture);
        BOOST_TEST(error.direction <= allowed.direction);
        BOOST_TEST(error.aperture <= allowed.aperture);
    }
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_rays)

BOOST_AUTO_TEST_CASE(agree_with_100_digits)
{
    random_sheets::Generator random(20261121);
    const int sheets = random_sheets::count(10000, 1000000);
    for (int k = 0; k < sheets; ++k) {
        const LensSheet sheet = random.sheet();
        const double distance = random.distance();
        // 1 to 1e6 lenses from the centre, up to 2 pitches from the pole
        const double reach = random.log_between(1, 1e6) * sheet.pitch;
        const Lattice lattice(sheet);
        const LensIndex lens = lattice.nearest(
            {random.between(-reach, reach), random.between(-reach, reach)});
        const double near = sheet.pitch * (random.one_in(3) ? 2 : 0.7);
        const Vec2 film_point = lattice.pole(lens) +
                                Vec2{random.between(-near, near), random.between(-near, near)};
        const bool lenticular = sheet.arrangement == Arrangement::lenticular;
        check_ray(lenticular ? "pole ray, lenticular" : "pole ray, square, hexagonal", sheet,
                  distance, film_point, lens);
    }
}

BOOST_AUTO_TEST_CASE(agree_next_to_total_reflection)
{
    random_sheets::Generator random(4711);
    const int sheets = random_sheets::count(2000, 100000);
    for (int k = 0; k < sheets; ++k) {
        LensSheet sheet = random.sheet();
        if (sheet.ior < 1.01)
            sheet.ior = random.between(1.01, 4);
        sheet.offset = {0, 0};
        const double border = sheet.thickness / std::sqrt((sheet.ior - 1) * (sheet.ior + 1));
        const double rho = border * (1 - random.log_between(1e-9, 1e-2)),
                     angle = random.between(0, 6.28318);
        const LensIndex centre;
        const char* what = "pole ray within 1e-2 to 1e-9 of total reflection";
        if (sheet.arrangement == Arrangement::lenticular) {
            const Lattice lattice(sheet);
            const double limit = std::fabs(slit_is_horizontal(sheet) ? lattice.along().y
                                                                     : lattice.along().x);
            check_ray(what, sheet, random.distance(), (rho * limit) * lattice.across(), centre);
        } else
            check_ray(what, sheet, random.distance(),
                      {rho * std::cos(angle), rho * std::sin(angle)}, centre);
    }
}

BOOST_AUTO_TEST_CASE(slit_where_it_is_worst_conditioned)
{
    // far above the axis and close to the eye (Y + tau cancels), at n near 1, and at 45 degrees
    for (double ior : {1.0, 1 + 1e-12, 1 + 1e-6, 1.01, 1.6, 4.0})
        for (double slant :
             {0.0, 1e-9, 18.4349, 45.0, 45.0000001, -45.0, 75.0, -89.99, 89.99, -90.0, 90.0})
            for (double distance : {1e-2, 1.0, 300.0, 1e9})
                for (double height : {0.0, 1e-9, 1.0, 100.0, 1e5})
                    for (double h : {0.0, 1e-12, 0.3, 0.635})
                        check_ray("pole ray, slit worst conditioned",
                                  {Arrangement::lenticular, 1.27, 3.08, ior, slant, {0, 0}},
                                  distance, {h, height}, {0, 0});
}

BOOST_AUTO_TEST_CASE(refraction_and_its_inverse_undo_each_other)
{
    random_sheets::Generator random(99);
    for (int k = 0; k < 20000; ++k) {
        const Medium medium(random.log_between(1e-3, 1e3),
                            random.one_in(5) ? 1 : random.between(1, 4));
        const double limit = medium.m > 0 ? medium.t / medium.root_m : 10 * medium.t;
        const double rho = limit * random.between(0, 0.999), angle = random.between(0, 6.28318);
        const Vec2 q{rho * std::cos(angle), rho * std::sin(angle)};
        const auto direction = direction_from_offset(medium, q);
        BOOST_REQUIRE(direction);
        BOOST_TEST(std::fabs(length(*direction) - 1) < 1e-12 * 1000);
        BOOST_TEST(length(offset_from_direction(medium, *direction) - q) <=
                   1e-12 * (length(q) + medium.t));
    }
}

BOOST_AUTO_TEST_CASE(total_reflection_is_no_ray)
{
    const Medium medium(3, 1.5);
    const double limit = medium.t / medium.root_m;
    BOOST_TEST(direction_from_offset(medium, {limit * (1 - 1e-12), 0}).has_value());
    BOOST_TEST(!direction_from_offset(medium, {limit * (1 + 1e-12), 0}).has_value());
    BOOST_TEST(!direction_from_offset(medium, {0, 1e300}).has_value());
    BOOST_TEST(!direction_from_offset(medium, {NAN, 0}).has_value());
}

BOOST_AUTO_TEST_CASE(an_eye_sees_the_film_point_that_sends_to_it)
{
    random_sheets::Generator random(5);
    for (int k = 0; k < 3000; ++k) {
        LensSheet sheet = random.sheet();
        sheet.thickness = sheet.pitch * random.between(1, 10);
        const double distance = sheet.pitch * random.between(50, 5000);
        const auto aperture = filling_aperture(sheet, distance);
        if (!aperture)
            continue;
        const SheetOptics optics(sheet, *aperture);
        const Vec2 film_point{random.between(-30, 30) * sheet.pitch,
                              random.between(-30, 30) * sheet.pitch};
        const MappedPoint mapped = optics.map(film_point, LensMapping::accurate);
        if (!mapped.ray)
            continue;
        LensIndex lens;
        const Vec2 seen = optics.film_point_seen(mapped.ray->pole, mapped.ray->direction, &lens);
        BOOST_TEST((lens == mapped.ray->lens));
        BOOST_TEST(length(seen - film_point) <= 1e-10 * sheet.pitch, sheet);
    }
}

BOOST_AUTO_TEST_SUITE_END()
