// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the projection lens against the thin lens's equation and its inverse.
#include "integral/optics/projection.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_projection)

BOOST_AUTO_TEST_CASE(images_are_where_the_thin_lens_equation_has_them)
{
    // 1/100 = 1/150 + 1/300, twice as large.
    const ProjectionLens lens{100, 150, 500};
    BOOST_TEST(lens.magnification() == 2);
    BOOST_TEST(lens.image_distance() == 300);
    // All light of a sheet's point meets in its image, upside down.
    for (const Vec2 lens_point : {Vec2{0, 0}, Vec2{5, -2}, Vec2{-30, 11}}) {
        const Line line = projected(lens, {3, -4}, lens_point);
        BOOST_TEST(line.origin.x == -6);
        BOOST_TEST(line.origin.y == 8);
        BOOST_TEST(line.origin.z == 0);
        // It passes through that point of the lens.
        BOOST_TEST(std::abs(line.origin.x + 300 * line.direction.x - lens_point.x) < 1e-12);
        BOOST_TEST(std::abs(line.origin.y + 300 * line.direction.y - lens_point.y) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(the_inverse_gives_both_points_back)
{
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int k = 0; k < 1000; ++k) {
        const double focal = between(10, 300);
        ProjectionLens lens{focal, focal * between(1.1, 4), 500};
        if (k % 2) { // several lenses; the light goes through the lens that it meets
            lens.columns = 1 + k % 5;
            lens.rows = 1 + k % 3;
            lens.extent = {between(20, 110), between(20, 110)};
        }
        const Vec2 sheet{between(-100, 100), between(-100, 100)},
            at_lens{between(-50, 50), between(-50, 50)};
        Line line = projected(lens, sheet, at_lens);
        const double along = between(-200, 200), scale = between(0.1, 3);
        line.origin = line.origin + along * line.direction;
        line.direction = scale * line.direction;
        const ProjectedFrom from = projected_from(lens, line);
        BOOST_TEST(length(from.sheet_point - sheet) < 1e-10);
        BOOST_TEST(length(from.lens_point - at_lens) < 1e-10);
    }
}

BOOST_AUTO_TEST_CASE(each_macro_lens_images_about_its_own_middle)
{
    ProjectionLens lens{100, 150, 500};
    lens.columns = 3;
    lens.rows = 2;
    lens.extent = {60, 40};
    const auto is_at = [](Vec2 a, Vec2 b) { return length(a - b) < 1e-12; };
    BOOST_TEST(is_at(lens.middle_at({-11, 1}), {-20, 10}));
    BOOST_TEST(is_at(lens.middle_at({9, -19}), {0, -10}));
    BOOST_TEST(is_at(lens.middle_at({1000, -1000}), {20, -10})); // beyond: the outermost
    // A point before a lens's middle is imaged there; other points are imaged upside down about it.
    for (const Vec2 lens_point : {Vec2{12, 3}, Vec2{28, 17}}) {
        BOOST_TEST(is_at({projected(lens, {20, 10}, lens_point).origin.x,
                          projected(lens, {20, 10}, lens_point).origin.y},
                         {20, 10}));
        const Vec3 off = projected(lens, {21, 13}, lens_point).origin;
        BOOST_TEST(is_at({off.x, off.y}, {18, 4}));
    }
}

BOOST_AUTO_TEST_CASE(the_eye_has_its_image_between_sheet_and_lens)
{
    // The eye is 300 + 700 before the lens: 1/100 = 1/1000 + 9/1000, a ninth as large.
    const ProjectionLens lens{100, 150, 700};
    BOOST_TEST(std::abs(lens.eye_image_distance() - (150 - 1000 / 9.0)) < 1e-12);
    BOOST_TEST(std::abs(lens.eye_scale() - 1 / 9.0) < 1e-15);
    // A line from the sheet through the eye's image goes through the eye.
    const Vec2 from{4, -3}, eye{9, 18}, image = -lens.eye_scale() * eye;
    const Vec2 on_lens = from + (lens.distance / lens.eye_image_distance()) * (image - from);
    const Line line = projected(lens, from, on_lens);
    const Vec2 seen{line.origin.x - 700 * line.direction.x, line.origin.y - 700 * line.direction.y};
    BOOST_TEST(length(seen - eye) < 1e-11);
}

BOOST_AUTO_TEST_SUITE_END()
