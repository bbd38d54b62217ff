// SPDX-License-Identifier: AGPL-3.0-or-later
// The parts of a sheet's calibration: least squares, camera, corners, targets, lenses' surface. The
// whole is tested on simulated photographs by tests/cli/calibration.test.
#include "integral/analysis/least_squares.h"
#include "integral/analysis/page_corners.h"
#include "integral/analysis/page_targets.h"
#include "integral/analysis/photo_plane.h"
#include "integral/analysis/sheet_view.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(analysis_calibration)

namespace {

/// A camera in front of and to the side of the page's middle.
PhotoCamera some_camera()
{
    PhotoCamera camera;
    camera.right = {1, 0, 0};
    camera.down = {0, -1, 0};
    camera.forward = {0, 0, -1};
    camera = turned(camera, {0.2, -0.15, 0.4});
    camera.place = -400 * camera.forward;
    camera.focal = 1400;
    camera.middle = {960, 540};
    return camera;
}

/// A picture of `width` x `height` pixels, each the mean of `parts` x `parts` points of `light`.
template <class Light> Plane drawn(int width, int height, Light light, int parts = 8)
{
    Plane plane{width, height, std::vector<float>(std::size_t(width) * height), 0};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int k = 0; k < parts * parts; ++k)
                sum += light(Vec2{x + (k % parts + 0.5) / parts, y + (k / parts + 0.5) / parts});
            plane.at(x, y) = float(sum / (parts * parts));
        }
    return plane;
}

} // namespace

BOOST_AUTO_TEST_CASE(least_squares_find_the_parameters_of_a_curve)
{
    // a exp(b x) + c, with an outlier of weight 0 and a fourth parameter that is fixed.
    LeastSquaresProblem problem;
    problem.steps = {1e-5, 1e-5, 1e-5, 0};
    problem.weights.assign(21, 1);
    problem.weights[7] = 0;
    problem.residuals = [](const std::vector<double>& p) {
        std::vector<double> residuals;
        for (int k = 0; k <= 20; ++k) {
            const double x = 0.1 * k, y = 2 * std::exp(-1.5 * x) + 0.3 + (k == 7 ? 5 : 0);
            residuals.push_back(p[0] * std::exp(p[1] * x) + p[2] - y);
        }
        return residuals;
    };
    const LeastSquaresFit fit = least_squares(problem, {1, -0.5, 0, 9});
    BOOST_TEST(std::fabs(fit.parameters[0] - 2) < 1e-6);
    BOOST_TEST(std::fabs(fit.parameters[1] + 1.5) < 1e-6);
    BOOST_TEST(std::fabs(fit.parameters[2] - 0.3) < 1e-6);
    BOOST_TEST(fit.parameters[3] == 9);
    BOOST_TEST(std::fabs(fit.derivative(10, 0) - std::exp(-1.5)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(an_inverse_times_its_matrix_is_one)
{
    SquareMatrix a(3);
    a.values = {4, 1, -1, 1, 3, 0.5, -1, 0.5, 2};
    const auto inverse = inverse_positive(a);
    BOOST_TEST_REQUIRE(inverse.has_value());
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double sum = 0;
            for (int k = 0; k < 3; ++k)
                sum += inverse->at(i, k) * a.at(k, j);
            BOOST_TEST(std::fabs(sum - (i == j)) < 1e-12);
        }
    a.at(2, 2) = -2;
    BOOST_TEST(!inverse_positive(a).has_value());
}

BOOST_AUTO_TEST_CASE(a_photo_point_and_its_direction_are_inverse)
{
    PhotoCamera camera = some_camera();
    camera.k1 = 0.05;
    camera.k2 = -0.03;
    camera.tangential = {0.001, -0.002};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-150, 150);
    for (int k = 0; k < 100; ++k) {
        const Vec3 point{place(random), place(random), 3};
        const Vec3 direction = direction_from_photo(camera, photo_from_page(camera, point)),
                   way = point - camera.place;
        BOOST_TEST(length(direction - (1 / length(way)) * way) < 1e-9);
    }
    // A point on the axis appears at the principal point; one to the right of it, to its right.
    const Vec2 middle = photo_from_page(camera, camera.place + 400 * camera.forward);
    BOOST_TEST(length(middle - camera.middle) < 1e-9);
    camera.k1 = camera.k2 = 0;
    camera.tangential = {};
    const Vec2 right = photo_from_page(camera, camera.place + 400 * camera.forward +
                                                   40 * camera.right + 20 * camera.down);
    BOOST_TEST(length(right - Vec2{960 + 140, 540 + 70}) < 1e-9);
}

BOOST_AUTO_TEST_CASE(four_points_give_the_camera)
{
    const PhotoCamera camera = some_camera();
    const std::array<Vec2, 4> page = {{{-90, 130}, {90, 130}, {90, -130}, {-90, -130}}};
    std::array<Vec2, 4> photo;
    for (int k = 0; k < 4; ++k)
        photo[k] = photo_from_page(camera, {page[k].x, page[k].y, 0});
    const PhotoCamera found = camera_from_four(page, photo, {1920, 1080});
    BOOST_TEST(std::fabs(found.focal / camera.focal - 1) < 0.03); // one of its steps
    BOOST_TEST(length(found.place - camera.place) < 0.03 * 400);
    for (int k = 0; k < 4; ++k)
        BOOST_TEST(length(photo_from_page(found, {page[k].x, page[k].y, 0}) - photo[k]) < 3);
}

BOOST_AUTO_TEST_CASE(a_corner_is_found_to_a_few_hundredths_of_a_pixel)
{
    // Squares of 9 pixels, turned and sheared, blurred by their pixels alone.
    const Vec2 middle{30.37, 29.71}, a{0.9, 0.35}, b{-0.3, 1.05};
    const Plane plane = drawn(60, 60, [&](Vec2 at) {
        const Vec2 from = at - middle;
        const double u = dot(a, from) / 9, v = dot(b, from) / 9;
        return (int(std::floor(u)) + int(std::floor(v))) % 2 == 0 ? 0.8 : 0.05;
    });
    const auto found = corner_near(plane, {32, 28}, 6);
    BOOST_TEST_REQUIRE(found.has_value());
    BOOST_TEST(length(*found - middle) < 0.05);
    BOOST_TEST(!corner_near(plane, {3, 3}, 6).has_value()); // at the plane's side
    const Plane edge = drawn(60, 60, [&](Vec2 at) { return at.x < 30 ? 0.8 : 0.05; });
    BOOST_TEST(!corner_near(edge, {30, 30}, 6).has_value());
}

BOOST_AUTO_TEST_CASE(targets_are_found_in_perspective)
{
    PhotoCamera camera = turned(some_camera(), {0, 0, 1.2});
    camera.place = -500 * camera.forward;
    const std::array<Vec2, 4> page = {{{-90, 130}, {90, 130}, {90, -130}, {-90, -130}}};
    const Plane plane = drawn(
        1920, 1080,
        [&](Vec2 at) {
            const Vec3 d = direction_from_photo(camera, at);
            const double way = -camera.place.z / d.z;
            const Vec2 point{camera.place.x + way * d.x, camera.place.y + way * d.y};
            if (std::fabs(point.x) > 105 || std::fabs(point.y) > 148)
                return 0.18; // a table
            for (int k = 0; k < 4; ++k) {
                const double away = length(point - page[k]);
                if (away < target_disc)
                    return away > target_ring || away < (k == 0 ? first_dot : other_dot) ? 0.05
                                                                                         : 0.8;
            }
            return 0.8;
        },
        2);
    const std::array<Vec2, 4> found = find_page_targets(plane);
    for (int k = 0; k < 4; ++k)
        BOOST_TEST(length(found[k] - photo_from_page(camera, {page[k].x, page[k].y, 0})) < 1);
    const Plane blank = drawn(200, 100, [](Vec2) { return 0.5; });
    BOOST_CHECK_THROW(find_page_targets(blank), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_curved_surface_changes_the_film_by_its_coma_and_depth)
{
    // Figures of another program, which traced 20000 rays through the same lens: at slope 0.1 the
    // phase moves by 0.18535 mm where the pole's ray moves by 0.19192 mm; the mean is 0.01897 mm
    // more.
    LensSheet sheet; // 1.27, 3.08, 1.6
    const SurfaceEffect effect = surface_effect(sheet);
    const double at = 0.1, beat = effect.beat[0] + effect.beat[1] * at * at +
                                  effect.beat[3] * at * at * at * at;
    BOOST_TEST(std::fabs(beat - (0.18535 / 0.19192 - 1)) < 0.001);
    BOOST_TEST(std::fabs(effect.coarse[0] - 0.1897) < 0.001);
    // The surface of narrow lenses is their pole.
    sheet.pitch = 0.02;
    const SurfaceEffect none = surface_effect(sheet);
    BOOST_TEST(std::fabs(none.beat[0]) < 2e-5);
    BOOST_TEST(std::fabs(none.coarse[0]) < 2e-4);
    BOOST_TEST(std::fabs(none.along[0]) < 2e-5);
    // Lenses wider than their spheres have no such surface.
    sheet.pitch = 5;
    BOOST_TEST(surface_effect(sheet).beat[0] == 0);
}

BOOST_AUTO_TEST_CASE(a_film_point_and_its_photo_point_are_inverse)
{
    SheetView view;
    view.camera = some_camera();
    view.pitch = 1.27;
    view.angle = 0.1;
    view.thickness = 3.08;
    view.ior = 1.6;
    view.surface = surface_effect(LensSheet());
    view.surface_share = 1;
    view.stretch = 0.002;
    for (const Vec2 film : {Vec2{0, 0}, Vec2{80, -110}, Vec2{-60, 90}})
        BOOST_TEST(length(sight_of(view, photo_of_film(view, film)).coarse_film - film) < 1e-4);
    // Without a surface the pole's ray, by Snell's law: an eye 400 mm above the page's left side.
    SheetView pole;
    pole.camera.right = {1, 0, 0};
    pole.camera.down = {0, -1, 0};
    pole.camera.forward = {0, 0, -1};
    pole.camera.place = {-100, 0, 403.08};
    pole.camera.focal = 1000;
    pole.thickness = 3.08;
    pole.ior = 1.6;
    const Vec2 photo = photo_from_page(pole.camera, {50, 0, 3.08});
    const double sine = 150 / std::hypot(150, 400) / 1.6;
    const Sight sight = sight_of(pole, photo);
    BOOST_TEST(std::fabs(sight.lens.x - 50) < 1e-9);
    BOOST_TEST(std::fabs(sight.film.x - 50 - 3.08 * sine / std::sqrt(1 - sine * sine)) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
