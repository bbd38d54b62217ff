// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests symmetries of every lens mapping with random sheets in the ranges of optics.md section 7:
// mirrored and rotated sheets, other scales, and the order of lenses and of aperture points.
#include "integral/optics/camera.h"
#include "tests/unit/optics_properties.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

using namespace random_systems;

namespace {

constexpr std::array<LensMapping, 4> mappings = {LensMapping::closest, LensMapping::automatic,
                                                 LensMapping::accurate, LensMapping::exhaustive};

} // namespace

BOOST_AUTO_TEST_SUITE(optics_symmetries)

BOOST_AUTO_TEST_CASE(mirrored_and_turned_sheets_image_mirrored_and_turned_points)
{
    Generator random(79);
    const int systems = random_sheets::count(3000, 300000);
    long imaged = 0;
    for (int k = 0; k < systems; ++k) {
        const System s = plain_system(random);
        const SheetOptics optics = s.optics();
        System mirrored = s, turned = s, quarter = s, sixth = s;
        mirrored.sheet.slant = -s.sheet.slant;
        mirrored.sheet.offset.x = -s.sheet.offset.x;
        turned.sheet.offset = -1 * s.sheet.offset;
        quarter.sheet.offset = {-s.sheet.offset.y, s.sheet.offset.x};
        std::swap(quarter.aperture.width, quarter.aperture.height);
        const Vec2 x = direction_at(std::acos(-1.0) / 3), y{-x.y, x.x};
        sixth.aperture.shape = ApertureShape::ellipse;
        sixth.aperture.height = sixth.aperture.width;
        const SheetOptics round = sixth.optics();
        sixth.sheet.offset = s.sheet.offset.x * x + s.sheet.offset.y * y;
        const SheetOptics mirrored_optics = mirrored.optics(), turned_optics = turned.optics();
        const SheetOptics quarter_optics = quarter.optics(), sixth_optics = sixth.optics();
        for (int i = 0; i < 10; ++i) {
            const Vec2 point = plain_film_point(random, s, 40);
            BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << ">")
            for (const LensMapping mapping : mappings) {
                const MappedPoint here = optics.map(point, mapping);
                imaged += here.ray.has_value();
                BOOST_TEST(
                    alike(here, mirrored_optics.map({-point.x, point.y}, mapping), s, [](Vec2 v) {
                        return Vec2{-v.x, v.y};
                    }));
                BOOST_TEST(alike(here, turned_optics.map(-1 * point, mapping), s,
                                 [](Vec2 v) { return -1 * v; }));
                if (s.sheet.arrangement == Arrangement::square)
                    BOOST_TEST(alike(here, quarter_optics.map({-point.y, point.x}, mapping), s,
                                     [](Vec2 v) {
                                         return Vec2{v.y, -v.x};
                                     }));
                if (s.sheet.arrangement == Arrangement::hexagonal)
                    BOOST_TEST(alike(round.map(point, mapping),
                                     sixth_optics.map(point.x * x + point.y * y, mapping), s,
                                     [&](Vec2 v) {
                                         return Vec2{dot(x, v), dot(y, v)};
                                     }));
            }
        }
    }
    BOOST_TEST(imaged > systems * 10);
}

BOOST_AUTO_TEST_CASE(all_lengths_scale_together)
{
    Generator random(81);
    const int systems = random_sheets::count(3000, 300000);
    long imaged = 0;
    for (int k = 0; k < systems; ++k) {
        const bool by_two = random.one_in(2); // bit for bit
        const System s = by_two ? random_system(random) : plain_system(random);
        const double scale = by_two ? std::ldexp(1.0, int(random.between(-20, 20)))
                                    : random.log_between(1e-4, 1e4);
        System scaled = s;
        scaled.sheet.pitch *= scale;
        scaled.sheet.thickness *= scale;
        scaled.sheet.offset = scale * s.sheet.offset;
        scaled.aperture = {scale * s.aperture.distance, scale * s.aperture.width,
                           scale * s.aperture.height, s.aperture.shape};
        const SheetOptics optics = s.optics(), scaled_optics = scaled.optics();
        for (int i = 0; i < 6; ++i) {
            const Vec2 point = by_two ? random_film_point(random, s, optics)
                                      : plain_film_point(random, s, 40);
            BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << "> scale "
                                 << scale)
            for (const LensMapping mapping :
                 {LensMapping::closest, LensMapping::automatic, LensMapping::accurate}) {
                const MappedPoint here = optics.map(point, mapping);
                MappedPoint there = scaled_optics.map(scale * point, mapping);
                imaged += here.ray.has_value();
                if (by_two && there.ray) {
                    there.ray->pole = (1 / scale) * there.ray->pole;
                    there.ray->aperture_point = (1 / scale) * there.ray->aperture_point;
                }
                const auto back = [&](Vec2 v) { return (1 / scale) * v; };
                BOOST_TEST((by_two ? equal(here, there) : alike(here, there, s, back)));
                BOOST_TEST((here.empty == there.empty));
            }
        }
    }
    BOOST_TEST(imaged > systems * 3);
}

BOOST_AUTO_TEST_CASE(lenses_that_lie_across_are_upright_ones_turned)
{
    // bit for bit: nothing but signs and the order of coordinates differs
    Generator random(83);
    long imaged = 0;
    for (int k = 0; k < random_sheets::count(2000, 200000); ++k) {
        System s = plain_system(random);
        s.sheet.arrangement = Arrangement::lenticular;
        s.sheet.slant = 0;
        const SheetOptics upright = s.optics();
        for (const double sign : {1.0, -1.0}) {
            const auto turned = [&](Vec2 v) { return Vec2{-sign * v.y, sign * v.x}; };
            System lying = s;
            lying.sheet.slant = sign * 90;
            lying.sheet.offset = turned(s.sheet.offset);
            std::swap(lying.aperture.width, lying.aperture.height);
            const SheetOptics optics = lying.optics();
            BOOST_TEST((cell_extent(lying.sheet).y == cell_extent(s.sheet).x));
            for (int i = 0; i < 5; ++i) {
                const Vec2 point = plain_film_point(random, s, 40);
                for (const LensMapping mapping : mappings) {
                    MappedPoint here = upright.map(point, mapping);
                    const MappedPoint there = optics.map(turned(point), mapping);
                    imaged += here.ray.has_value();
                    if (here.ray) {
                        LensRay& ray = *here.ray;
                        ray.pole = turned(ray.pole);
                        const Vec2 way = turned({ray.direction.x, ray.direction.y});
                        ray.direction = {way.x, way.y, ray.direction.z};
                        ray.aperture_point = turned(ray.aperture_point);
                    }
                    BOOST_TEST_CONTEXT(lying << " film point <" << point.x << ", " << point.y
                                             << ">")
                    BOOST_TEST(equal(here, there));
                }
            }
        }
    }
    BOOST_TEST(imaged > 10000);
}

BOOST_AUTO_TEST_CASE(scene_and_units_scale_together)
{
    Generator random(82);
    const int cameras = random_sheets::count(1000, 100000);
    long lines = 0;
    for (int k = 0; k < cameras; ++k) {
        CameraParameters parameters;
        parameters.sheet.arrangement = Arrangement(random.between(0, 3));
        parameters.sheet.slant = random.between(-80, 80);
        parameters.film.units_per_mm = random.log_between(1e-4, 1e4);
        if (random.one_in(2))
            parameters.depth_range = Vec2{random.between(0, 100), random.between(1, 100)};
        const double unit = *parameters.film.units_per_mm;
        const auto vector = [&](double size) {
            return size * unit *
                   Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        };
        const ViewFrame view{vector(1e3), vector(300), vector(100), vector(100),
                             random.between(0.5, 2)};
        const bool by_two = random.one_in(2); // bit for bit
        const double scale = by_two ? std::ldexp(1.0, int(random.between(-6, 6)))
                                    : random.log_between(1e-2, 1e2);
        const auto camera_scaled = [&](double by) -> std::optional<IntegralCamera> {
            CameraParameters p = parameters;
            p.film.units_per_mm = by * unit;
            try {
                return make_camera(p,
                                   {by * view.location, by * view.direction, by * view.right,
                                    by * view.up, view.sheet_distance_ratio},
                                   600, 400);
            } catch (const std::invalid_argument&) { // three vectors nearly in one plane
                return std::nullopt;
            }
        };
        const auto here = camera_scaled(1), there = camera_scaled(scale);
        BOOST_TEST_REQUIRE(here.has_value() == there.has_value());
        if (!here)
            continue;
        for (int i = 0; i < 20; ++i) {
            const Vec2 pixel{random.between(0, 600), random.between(0, 400)};
            const auto a = here->optics.map(film_from_pixel(here->film, pixel), here->mapping);
            const auto b = there->optics.map(film_from_pixel(there->film, pixel), there->mapping);
            BOOST_TEST_REQUIRE(a.ray.has_value() == b.ray.has_value());
            if (!a.ray)
                continue;
            ++lines;
            const SightLine line = sight_line(*here, pole_beam(*a.ray)),
                            scaled = sight_line(*there, pole_beam(*b.ray));
            const double far = scale * (length(line.origin) + length(view.location));
            const double off = length(scaled.origin - scale * line.origin) / far;
            const double turned = length(scaled.direction - line.direction);
            const double longer = std::fabs(scaled.length - scale * line.length) / (scale * unit);
            BOOST_TEST(off <= (by_two ? 0 : 1e-11));
            BOOST_TEST(turned <= (by_two ? 0 : 1e-11));
            BOOST_TEST(longer <= (by_two ? 0 : 1e-9 * line.length / unit));
        }
    }
    BOOST_TEST(lines > cameras * 5);
}

BOOST_AUTO_TEST_CASE(aperture_points_move_against_the_film_point)
{
    // When the film point moves along a line, the aperture point A moves the opposite way, as long
    // as the same lens sends its light out.
    Generator random(83);
    const int systems = random_sheets::count(2000, 200000);
    for (int k = 0; k < systems; ++k) {
        System s = random_system(random);
        if (s.lenticular())
            s.sheet.slant = 0; // for slanted slits it need not hold where refraction is strong
        const SheetOptics optics = s.optics();
        const LensIndex lens = optics.lattice().nearest(plain_film_point(random, s, 100));
        const Vec2 pole = optics.lattice().pole(lens);
        const Vec2 way = s.lenticular() ? Vec2{1, 0} : direction_at(random.between(0, 6.3));
        const double beside = random.between(-0.5, 0.5) * s.sheet.pitch;
        const double reach = std::min(2 * s.sheet.pitch, s.total_reflection());
        double before = infinity;
        for (int i = -50; i <= 50; ++i) {
            const auto ray = optics.ray_through(
                pole + (i * reach / 50) * way + beside * Vec2{-way.y, way.x}, lens);
            if (!ray)
                continue;
            const double now = dot(way, ray->aperture_point);
            BOOST_TEST_REQUIRE(now < before, s);
            before = now;
        }
    }
}

BOOST_AUTO_TEST_CASE(lenses_stand_in_the_order_of_their_film_points)
{
    // Behind an unlimited aperture, the lenses selected along a row of the film are in order;
    // micro-images are displaced outwards, farther ones more (optics.md section 4).
    Generator random(84);
    const int systems = random_sheets::count(500, 50000);
    for (int k = 0; k < systems; ++k) {
        System s = plain_system(random);
        s.sheet.slant = 0;
        s.sheet.offset = {0, 0};
        s.aperture = {std::max(s.aperture.distance, 100 * s.sheet.pitch), infinity,
                      infinity}; // up to 27 degrees
        const SheetOptics optics = s.optics();
        std::int64_t last = 0;
        for (int i = 0; i <= 1000; ++i) {
            const Vec2 point{i * 0.05 * s.sheet.pitch, 0};
            const auto mapped = optics.map(point, LensMapping::accurate);
            if (!mapped.ray)
                continue; // beyond total reflection
            BOOST_TEST_REQUIRE(mapped.ray->lens.j == 0, s);
            BOOST_TEST_REQUIRE(mapped.ray->lens.i >= last, s);
            last = mapped.ray->lens.i;
            BOOST_TEST(optics.lattice().nearest(point).i >= last);
        }
        BOOST_TEST(last > 10, s);
        double displaced = 0;
        for (int i = 1; i < 50; ++i) {
            const Vec2 pole = optics.lattice().pole({i, 0});
            const double now = film_point_through(optics, pole, {0, 0}).x - pole.x;
            BOOST_TEST_REQUIRE(now > displaced, s);
            BOOST_TEST(optics.map(pole + Vec2{now, 0}, LensMapping::accurate).ray->lens.i == i);
            displaced = now;
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
