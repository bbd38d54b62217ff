// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the lens models' properties: symmetries, round trips, and properties common to all. Their
// accuracy is tested in optics_beam.cpp.
#include "integral/optics/beam.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

#include <limits>

using namespace integral;

namespace {

constexpr double pi = 3.14159265358979323846;
const Arrangement arrangements[] = {Arrangement::lenticular, Arrangement::square,
                                    Arrangement::hexagonal};
const LensModel models[] = {LensModel::pinhole, LensModel::extended_pinhole, LensModel::hybrid,
                            LensModel::full};

/// A sheet of typical dimensions, one of its lenses, a point of the lens and a film point behind
/// it.
struct System {
    LensSheet sheet;
    double distance = 300;
    LensModel model = LensModel::full;
    LensIndex lens;
    LensPoint at;
    Vec2 film;

    SheetOptics optics() const { return {sheet, Aperture{distance, distance, distance}, model}; }
    std::optional<BeamRay> ray() const { return beam_ray(optics(), film, lens, at); }
    bool lenticular() const { return sheet.arrangement == Arrangement::lenticular; }
};

System random_system(random_sheets::Generator& random)
{
    System s;
    s.sheet.arrangement = arrangements[int(random.between(0, 3))];
    s.model = models[int(random.between(0, 4))];
    s.sheet.pitch = random.between(0.2, 2);
    s.sheet.ior = random.between(1.4, 1.8);
    s.sheet.thickness = s.sheet.pitch * random.between(2.1, 6);
    s.sheet.slant = random.one_in(3) ? 0 : random.between(-80, 80);
    s.sheet.offset = {random.between(-1, 1), random.between(-1, 1)};
    s.distance = random.between(50, 2000);
    s.lens.i = int(random.between(-60, 60));
    s.lens.j = s.lenticular() ? 0 : int(random.between(-60, 60));
    const Lattice lattice(s.sheet);
    s.at = cell_point(lattice, {random.between(0, 1), random.between(0, 1)},
                      random.one_in(2) ? 50 : 0);
    s.film = lattice.pole(s.lens) +
             s.sheet.pitch * Vec2{random.between(-0.7, 0.7), random.between(-0.7, 0.7)};
    if (s.lenticular())
        s.film = s.film + random.between(-60, 60) * lattice.along();
    return s;
}

double apart(const BeamRay& a, const BeamRay& b, double distance)
{
    return length(a.direction - b.direction) + length(a.point - b.point) / distance +
           length(a.aperture_point - b.aperture_point) / (distance + length(a.aperture_point));
}

/// Compares a system's ray, after `move` is applied to it, with another system's ray.
template <class Move> void check_same(const System& s, const System& other, Move move)
{
    const auto a = s.ray(), b = other.ray();
    BOOST_TEST_REQUIRE(a.has_value() == b.has_value(), s.sheet);
    if (!a)
        return;
    const Vec2 point = move(Vec2{a->point.x, a->point.y}),
               way = move(Vec2{a->direction.x, a->direction.y});
    const BeamRay moved{
        {point.x, point.y, a->point.z}, {way.x, way.y, a->direction.z}, move(a->aperture_point)};
    BOOST_TEST(apart(moved, *b, s.distance) <= 1e-11, s.sheet << " model " << int(s.model));
}

LensIndex opposite(const LensSheet& sheet, LensIndex lens, bool rows_too)
{
    const bool shifted = sheet.arrangement == Arrangement::hexagonal && lens.j % 2 != 0;
    return {-lens.i - (shifted ? 1 : 0), rows_too ? -lens.j : lens.j};
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_models)

BOOST_AUTO_TEST_CASE(every_model_agrees_at_the_pole)
{
    random_sheets::Generator random(11);
    int rays = 0;
    for (int k = 0; k < 5000; ++k) {
        System s = random_system(random);
        s.at = {};
        s.model = LensModel::extended_pinhole;
        const auto plain = s.optics().ray_through(s.film, s.lens);
        for (LensModel model : {LensModel::extended_pinhole, LensModel::hybrid, LensModel::full}) {
            s.model = model;
            const auto ray = s.ray();
            BOOST_TEST_REQUIRE(ray.has_value() == plain.has_value(), s.sheet);
            if (!ray)
                continue;
            ++rays;
            const BeamRay same{
                {plain->pole.x, plain->pole.y, 0}, plain->direction, plain->aperture_point};
            BOOST_TEST(apart(same, *ray, s.distance) <= 1e-12);
        }
        // the pinhole's film point, pole and aperture point are on one straight line
        s.model = LensModel::pinhole;
        const auto straight = s.ray();
        BOOST_TEST_REQUIRE(straight.has_value());
        const Vec2 inside = Vec2{straight->point.x, straight->point.y} - s.film;
        const Vec2 outside = straight->aperture_point - Vec2{straight->point.x, straight->point.y};
        BOOST_TEST(length((1 / s.sheet.thickness) * inside - (1 / s.distance) * outside) < 1e-11);
    }
    BOOST_TEST(rays > 10000);
}

BOOST_AUTO_TEST_CASE(hybrid_refracts_as_full_does)
{
    random_sheets::Generator random(17);
    for (int k = 0; k < 1000; ++k) {
        System s = random_system(random), other = s;
        s.model = LensModel::full;
        other.model = LensModel::hybrid;
        const auto a = s.ray(), b = other.ray();
        BOOST_TEST_REQUIRE(a.has_value() == b.has_value());
        if (a)
            BOOST_TEST(apart(*a, *b, s.distance) == 0);
    }
}

BOOST_AUTO_TEST_CASE(an_ideal_beam_is_parallel)
{
    random_sheets::Generator random(12);
    for (int k = 0; k < 2000; ++k) {
        System s = random_system(random);
        s.model = k % 2 ? LensModel::pinhole : LensModel::extended_pinhole;
        const auto ray = s.ray();
        System centred = s;
        centred.at.offset = {};
        const auto pole_ray = centred.ray();
        BOOST_TEST_REQUIRE(ray.has_value() == pole_ray.has_value());
        if (!ray)
            continue;
        BOOST_TEST(length(ray->direction - pole_ray->direction) <= 1e-12);
        BOOST_TEST(length(ray->point - pole_ray->point - Vec3{s.at.offset.x, s.at.offset.y, 0}) <=
                   1e-10);
        BOOST_TEST(length(ray->aperture_point - pole_ray->aperture_point - s.at.offset) <= 1e-10);
    }
}

BOOST_AUTO_TEST_CASE(rays_meet_the_slit)
{
    random_sheets::Generator random(13);
    for (int k = 0; k < 5000; ++k) {
        System s = random_system(random);
        s.sheet.arrangement = Arrangement::lenticular;
        s.lens.j = 0;
        s.at = cell_point(Lattice(s.sheet), {random.between(0, 1), random.between(0, 1)}, 80);
        s.film = Lattice(s.sheet).pole(s.lens) +
                 Vec2{random.between(-0.3, 0.3), random.between(-0.3, 0.3)};
        const auto ray = s.ray();
        if (!ray)
            continue;
        const bool horizontal = slit_is_horizontal(s.sheet);
        const double beside = refracts_at_surface(s.model) ? 0
                              : horizontal                 ? s.at.offset.y
                                                           : s.at.offset.x;
        BOOST_TEST(std::fabs((horizontal ? ray->aperture_point.y : ray->aperture_point.x) - beside -
                             s.at.slit) <= 1e-13);
    }
}

BOOST_AUTO_TEST_CASE(rays_go_there_and_back)
{
    random_sheets::Generator random(14);
    int rays = 0;
    for (int k = 0; k < 20000; ++k) {
        const System s = random_system(random);
        const SheetOptics optics = s.optics();
        const auto ray = s.ray();
        if (!ray || ray->direction.z > -0.05)
            continue;
        ++rays;
        // from any point of the ray, in front of and behind the sheet, the film point is found
        // again
        for (double z : {-3 * s.distance, -0.4 * s.distance, -1.0, 2.5, 4000.0}) {
            const Vec3 scene = ray->point +
                               ((z - ray->point.z) / ray->direction.z) * ray->direction;
            const auto film = film_point_imaging(optics, scene, s.lens, s.at);
            BOOST_TEST_REQUIRE(film.has_value(), s.sheet);
            BOOST_TEST(length(*film - s.film) <= 1e-10,
                       s.sheet << " model " << int(s.model) << " z " << z);
        }
        // and a scene point's film point has a ray through it
        const Vec3 scene{random.between(-200, 200), random.between(-200, 200),
                         random.between(-40, 400)};
        const auto film = film_point_imaging(optics, scene, s.lens, s.at);
        const auto there = film ? beam_ray(optics, *film, s.lens, s.at) : std::nullopt;
        if (film && there)
            BOOST_TEST(length(cross(scene - there->point, there->direction)) <= 1e-9, s.sheet);
        BOOST_TEST(film.has_value() == there.has_value(), s.sheet);
    }
    BOOST_TEST(rays > 10000);
}

BOOST_AUTO_TEST_CASE(symmetries)
{
    random_sheets::Generator random(15);
    for (int k = 0; k < 5000; ++k) {
        const System s = random_system(random);
        // left and right exchanged
        System mirrored = s;
        mirrored.sheet.slant = -s.sheet.slant;
        mirrored.sheet.offset.x = -s.sheet.offset.x;
        mirrored.film.x = -s.film.x;
        mirrored.at.offset.x = -s.at.offset.x;
        mirrored.at.slit = slit_is_horizontal(s.sheet) ? s.at.slit : -s.at.slit;
        mirrored.lens = opposite(s.sheet, s.lens, false);
        check_same(s, mirrored, [](Vec2 v) { return Vec2{-v.x, v.y}; });
        // turned by 180 degrees
        System turned = s;
        turned.sheet.offset = -1 * s.sheet.offset;
        turned.film = -1 * s.film;
        turned.at = {-1 * s.at.offset, -s.at.slit};
        turned.lens = opposite(s.sheet, s.lens, true);
        check_same(s, turned, [](Vec2 v) { return -1 * v; });
        // a square sheet turned by 90 degrees
        const auto quarter = [](Vec2 v) { return Vec2{-v.y, v.x}; };
        if (s.sheet.arrangement == Arrangement::square) {
            System other = s;
            other.sheet.offset = quarter(s.sheet.offset);
            other.film = quarter(s.film);
            other.at.offset = quarter(s.at.offset);
            other.lens = {-s.lens.j, s.lens.i};
            check_same(s, other, quarter);
        }
        // lenses with a pole, turned by any angle
        if (!s.lenticular()) {
            const double angle = random.between(-9, 9), c = std::cos(angle * pi / 180),
                         sine = std::sin(angle * pi / 180);
            const auto turn = [&](Vec2 v) {
                return Vec2{c * v.x - sine * v.y, sine * v.x + c * v.y};
            };
            System other = s;
            other.sheet.slant += angle;
            other.sheet.offset = turn(s.sheet.offset);
            other.film = turn(s.film);
            other.at.offset = turn(s.at.offset);
            check_same(s, other, turn);
        }
    }
}

BOOST_AUTO_TEST_CASE(common_scaling_of_all_lengths)
{
    // Scaled by a power of two, results are equal to the last bit; by another number, except for
    // rounding.
    random_sheets::Generator random(16);
    for (int k = 0; k < 5000; ++k) {
        const System s = random_system(random);
        for (double scale : {std::ldexp(1.0, -17), std::ldexp(1.0, 20), 1e-4, 3e5}) {
            System scaled = s;
            scaled.sheet.pitch *= scale;
            scaled.sheet.thickness *= scale;
            scaled.sheet.offset = scale * s.sheet.offset;
            scaled.distance *= scale;
            scaled.at = {scale * s.at.offset, scale * s.at.slit};
            scaled.film = scale * s.film;
            const auto a = s.ray(), b = scaled.ray();
            BOOST_TEST_REQUIRE(a.has_value() == b.has_value());
            if (!a)
                continue;
            const bool power = scale < 1e-4 || scale > 5e5;
            const double most = power ? 0 : 1e-11;
            BOOST_TEST(length(a->direction - b->direction) <= most);
            const double far = scale * (s.distance + length(a->aperture_point));
            BOOST_TEST(length(scale * a->aperture_point - b->aperture_point) <= most * far);
            BOOST_TEST(length(scale * a->point - b->point) <= most * scale * s.distance);
        }
    }
}

BOOST_AUTO_TEST_CASE(light_of_the_focus_leaves_parallel_to_third_order)
{
    // the film is at the paraxial focus: halving the distance from the axis leaves an eighth of the
    // error
    for (Arrangement arrangement : arrangements)
        for (double ior : {1.3, 1.6, 2.0}) {
            System s;
            s.sheet = {arrangement, 1.27, 6, ior, 15, {0, 0}};
            const auto bend = [&](double v) {
                s.at = {v * Lattice(s.sheet).across(), 0};
                const auto ray = s.ray();
                BOOST_TEST_REQUIRE(ray.has_value());
                // lenticular: the light that meets the slit leaves along the axis a little
                return std::fabs(
                    dot(Lattice(s.sheet).across(), Vec2{ray->direction.x, ray->direction.y}));
            };
            BOOST_TEST(bend(0) == 0);
            BOOST_TEST(bend(0.2) > 0);
            BOOST_TEST(bend(0.2) / bend(0.1) == 8, boost::test_tools::tolerance(0.03));
            BOOST_TEST(bend(0.1) / bend(0.05) == 8, boost::test_tools::tolerance(0.01));
        }
}

BOOST_AUTO_TEST_CASE(a_cylinder_s_section_is_a_sphere_s)
{
    // in the plane across an upright cylinder, with the slit at the height of the film point
    for (double x : {-0.5, -0.1, 0.0, 0.3})
        for (double v : {-0.6, -0.2, 0.1, 0.635}) {
            System cylinder, sphere;
            cylinder.film = sphere.film = {x, 0};
            cylinder.at.offset = sphere.at.offset = {v, 0};
            sphere.sheet.arrangement = Arrangement::square;
            const auto a = cylinder.ray(), b = sphere.ray();
            BOOST_TEST_REQUIRE(a.has_value());
            BOOST_TEST_REQUIRE(b.has_value());
            BOOST_TEST(apart(*a, *b, 300) <= 1e-14);
        }
}

BOOST_AUTO_TEST_CASE(directions_move_steadily_with_the_film_point)
{
    // When the film point moves to the right, the direction of its light moves to the left (except
    // for rounding), for steps of all sizes.
    for (LensModel model : models)
        for (double v : {-0.5, 0.0, 0.3})
            for (double step : {1e-3, 1e-9, 1e-15}) {
                System s;
                s.model = model;
                s.at.offset = {v, 0};
                std::optional<BeamRay> before;
                for (int k = -500; k <= 500; ++k) {
                    s.film = {0.2 + k * step, 0};
                    const auto ray = s.ray();
                    if (before && ray)
                        BOOST_TEST(ray->direction.x <= before->direction.x + 4e-16);
                    before = ray;
                }
            }
}

BOOST_AUTO_TEST_CASE(no_light_is_no_value)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    for (Arrangement arrangement : arrangements)
        for (LensModel model : models) {
            System s;
            s.sheet.arrangement = arrangement;
            s.model = model;
            const SheetOptics optics = s.optics();
            for (Vec2 film : {Vec2{nan, 0}, Vec2{0, nan}})
                BOOST_TEST(!beam_ray(optics, film, {}, {}).has_value());
            if (model != LensModel::pinhole)
                for (double far : {1e3, 1e100, 1e200})
                    BOOST_TEST(!beam_ray(optics, {far, 0}, {}, {}).has_value());
            if (refracts_at_surface(model)) {
                BOOST_TEST(!beam_ray(optics, {0, 0}, {}, {{2, 0}, 0}).has_value()); // R is 1.155
                BOOST_TEST(!film_point_imaging(optics, {0, 0, 100}, {}, {{2, 0}, 0}).has_value());
                // The line of sight is so oblique that the surface hides the point.
                BOOST_TEST(
                    !film_point_imaging(optics, {-1000, 0, -1}, {}, {{0.6, 0}, 0}).has_value());
            }
            for (double bad : {0.0, nan, infinity}) {
                BOOST_TEST(!film_point_imaging(optics, {5, 0, bad}, {}).has_value());
                BOOST_TEST((bad == 0 || !film_point_imaging(optics, {bad, 0, 5}, {}).has_value()));
            }
            BOOST_TEST(!film_point_imaging(optics, {0, 0, 0}, {}).has_value());
            // in the slit's own plane a point has no line of its own to the lens
            BOOST_TEST(film_point_imaging(optics, {3, 4, -300}, {}).has_value() == !s.lenticular());
        }
}

BOOST_AUTO_TEST_SUITE_END()
