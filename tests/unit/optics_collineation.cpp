// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the parallax map of optics.md section 8 against its definition by eyes and sheet points in
// 100-digit arithmetic, and collineations against their inverses.
#include "integral/optics/camera.h"

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

using namespace integral;
using Exact = boost::multiprecision::cpp_dec_float_100;

namespace {

struct Random {
    std::mt19937_64 bits{8};
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(bits);
    }
    double about(double low, double high) // evenly by its logarithm
    {
        return std::exp(between(std::log(low), std::log(high)));
    }
};

/// Where the straight line from an eye at (eye, -distance) to (x, z) meets the sheet.
Exact on_sheet(Exact eye, Exact distance, Exact x, Exact z)
{
    return eye + (x - eye) * distance / (distance + z);
}

bool is_near(Vec3 a, Vec3 b, double tolerance)
{
    return length(a - b) <= tolerance * (1 + length(a) + length(b));
}

const ViewFrame view{{1, 2, -30}, {0, 0, 1}, {1.5, 0, 0}, {0, 1, 0}, 30};

CameraParameters parameters(std::optional<double> parallax, std::optional<double> viewing_distance)
{
    CameraParameters p;
    p.sheet.arrangement = Arrangement::square;
    p.sheet.pitch = 1.27;
    p.sheet.thickness = 3.08;
    p.sheet.ior = 1.6;
    p.parallax = parallax;
    p.viewing_distance = viewing_distance;
    return p;
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_collineation)

BOOST_AUTO_TEST_CASE(both_eyes_have_a_point_behind_the_same_place_of_the_sheet)
{
    Random random;
    double worst = 0;
    for (int k = 0; k < 20000; ++k) {
        const double viewer = random.about(10, 1e5), scene = random.about(1e-1, 1e7);
        const Parallax parallax{k % 7 == 0 ? 1 : random.about(1e-3, 2), scene};
        const double z = k % 3 == 0 ? -scene * random.between(0, 0.999)
                                    : scene * random.about(1e-6, 1e4),
                     x = random.between(-1, 1) * (scene + z);
        const auto seen = image_of(relief_of(parallax, viewer), Vec3{x, 0, z});
        // With K > 1 the viewer's infinity is nearer than the scene's.
        BOOST_TEST(seen.has_value() == (scene + (1 - parallax.factor) * z > 0));
        if (!seen)
            continue;
        for (const double eye : {-0.3 * viewer, 0.0, 0.1 * viewer}) {
            const Exact own = on_sheet(Exact(parallax.factor) * eye, scene, x, z),
                        viewed = on_sheet(eye, viewer, seen->x, seen->z);
            // w = 1 + bend z cancels near infinity, and distance + z near the eye.
            const double bent = (1 - parallax.factor) * z,
                         condition = (scene + std::fabs(bent)) / (scene + bent) *
                                     (scene + std::fabs(z)) / (scene + z),
                         size = std::fabs(eye) + std::fabs(x) + std::fabs(seen->x) +
                                std::fabs(double(own));
            worst = std::max(worst, std::fabs(double(own - viewed)) / (size * condition));
        }
    }
    BOOST_TEST(worst < 1e-14);
}

BOOST_AUTO_TEST_CASE(depths_are_those_of_the_closed_form)
{
    Random random;
    for (int k = 0; k < 20000; ++k) {
        const Exact factor = random.about(1e-3, 1), viewer = random.about(10, 1e5),
                    scene = random.about(1e-1, 1e7), z = scene * random.about(1e-6, 1e4);
        const Exact exact = factor * viewer * z / (scene + (1 - factor) * z);
        const Collineation relief = relief_of({double(factor), double(scene)}, double(viewer));
        const double seen = image_of(relief, Vec3{0, 0, double(z)})->z;
        BOOST_TEST(std::fabs(double(seen / exact - 1)) < 1e-14);
        const Exact back = scene * exact / (factor * viewer - (1 - factor) * exact);
        BOOST_TEST(std::fabs(double(back / z - 1)) < 1e-80);
        if (const auto depth = preimage_depth(relief, seen)) {
            // Near the viewer's picture of infinity, a rounding of z' is a large change of z.
            const double condition = double((scene + (1 - factor) * z) / scene);
            BOOST_TEST(std::fabs(*depth / double(z) - 1) < 1e-14 * condition);
        }
    }
}

BOOST_AUTO_TEST_CASE(points_lines_and_normals_go_there_and_back)
{
    Random random;
    for (int k = 0; k < 5000; ++k) {
        const Collineation map{k % 2 ? 1 : -random.about(0.3, 3), random.about(0.05, 5),
                               random.between(-1e-3, 1e-3)};
        const auto point = [&] {
            return Vec3{random.between(-100, 100), random.between(-100, 100),
                        random.between(-300, 300)};
        };
        const Vec3 a = point(), b = point();
        BOOST_TEST(is_near(*preimage_of(map, *image_of(map, a)), a, 1e-12));
        const Line line{a, b - a}, image = image_of(map, line), back = preimage_of(map, image);
        const auto at = [](const Line& l, double z) {
            return l.origin + ((z - l.origin.z) / l.direction.z) * l.direction;
        };
        for (const Vec3& p : {a, b}) {
            const Vec3 on_image = *image_of(map, p);
            BOOST_TEST(is_near(at(image, on_image.z), on_image, 1e-10));
            BOOST_TEST(is_near(at(back, p.z), p, 1e-10));
        }
        if (map.lateral != 1)
            continue;
        // Three points of a plane, and their images.
        const Vec3 c = point(), normal = cross(b - a, c - a);
        const Vec3 facing = image_of_normal(map, a, normal), to = *image_of(map, a);
        for (const Vec3& p : {b, c}) {
            const Vec3 along = *image_of(map, p) - to;
            BOOST_TEST(std::fabs(dot(facing, along)) < 1e-9 * length(facing) * length(along));
        }
    }
}

BOOST_AUTO_TEST_CASE(no_parallax_between_eyes_shows_one_picture_in_the_sheet)
{
    const Collineation relief = relief_of({0, 300}, 400);
    const Vec3 seen = *image_of(relief, Vec3{6, -3, 300});
    BOOST_TEST(seen.x == 3);
    BOOST_TEST(seen.y == -1.5);
    BOOST_TEST(seen.z == 0);
    const Line line = preimage_of(relief, Line{{3, -1.5, 0}, {0.2, 0.1, 1}});
    BOOST_TEST(is_near(line.origin + 300 * line.direction, {6, -3, 300}, 1e-15));
    BOOST_TEST(is_near(line.origin - 300 * line.direction, {0, 0, -300}, 1e-15));
}

BOOST_AUTO_TEST_CASE(sight_lines_go_from_the_scenes_eye_through_the_sheets_point)
{
    for (const double factor : {0.0, 0.1, 0.5, 1.0, 1.5})
        for (const double viewed : {250.0, 400.0, 1e4}) {
            const IntegralCamera camera = make_camera(parameters(factor, viewed), view, 600, 400);
            const double scene = 30 / camera.placement.units_per_mm;
            BOOST_TEST(camera.optics.aperture().distance == viewed);
            for (const Vec2 film_point : {Vec2{0.1, 0.2}, Vec2{-20, 11}, Vec2{24.7, -16}}) {
                const auto ray = camera.optics.ray_through(
                    film_point, camera.optics.lattice().nearest(film_point));
                BOOST_TEST_REQUIRE(ray.has_value());
                const SightLine line = sight_line(camera, pole_beam(*ray));
                const Vec3 from = sheet_from_scene(camera.placement, line.origin),
                           requested{factor * ray->aperture_point.x, factor * ray->aperture_point.y,
                                     -scene};
                BOOST_TEST(is_near(from, requested, 1e-12));
                const Vec3 way = sheet_from_scene(camera.placement, line.origin + line.direction) -
                                 from;
                BOOST_TEST(is_near(from + (scene / way.z) * way, {ray->pole.x, ray->pole.y, 0},
                                   1e-9));
                // A point of the line maps onto the viewer's line and back.
                const Vec3 point = line.origin + 40 * line.direction,
                           seen = seen_from_scene(camera, point);
                const Vec3 on_line =
                    Vec3{ray->pole.x, ray->pole.y, 0} + (seen.z / ray->direction.z) * ray->direction;
                if (std::isfinite(seen.z))
                    BOOST_TEST(is_near(seen, on_line, 1e-10));
                if (factor > 0 && std::isfinite(seen.z))
                    BOOST_TEST(is_near(*scene_from_seen(camera, seen), point, 1e-10));
            }
        }
}

BOOST_AUTO_TEST_CASE(depth_range_is_where_the_viewer_sees_things)
{
    CameraParameters p = parameters(0.2, 400);
    p.depth_range = Vec2{30, 50};
    const IntegralCamera camera = make_camera(p, view, 600, 400);
    const auto ray = camera.optics.map({0.1, 0.2}, LensMapping::automatic).ray;
    BOOST_TEST_REQUIRE(ray.has_value());
    const SightLine line = sight_line(camera, pole_beam(*ray));
    BOOST_TEST(seen_from_scene(camera, line.origin).z == -30, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(seen_from_scene(camera, line.origin + line.length * line.direction).z == 50,
               boost::test_tools::tolerance(1e-12));
    // Infinity is seen at 0.2 * 400 / 0.8 = 100 mm.
    p.depth_range = Vec2{30, 101};
    BOOST_TEST(sight_line(make_camera(p, view, 600, 400), pole_beam(*ray)).length == 0);
}

BOOST_AUTO_TEST_CASE(one_eye_for_both_is_no_parallax)
{
    const double scene = 30 / make_camera(parameters({}, {}), view, 600, 400).placement.units_per_mm;
    BOOST_TEST(!make_camera(parameters({}, {}), view, 600, 400).parallax.has_value());
    BOOST_TEST(!make_camera(parameters(1, scene), view, 600, 400).parallax.has_value());
    // The default parallax shows the true depth at the sheet.
    const auto parallax = make_camera(parameters({}, 400), view, 600, 400).parallax;
    BOOST_TEST_REQUIRE(parallax.has_value());
    BOOST_TEST(parallax->factor == scene / 400);
    CameraParameters moved = parameters({}, 400);
    moved.move_eye = true;
    BOOST_TEST(!make_camera(moved, view, 600, 400).parallax.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
