// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that film_in_sight is the inverse of sight_line in scenes of any place, scale and parallax.
#include "integral/optics/film_in_sight.h"

#include <boost/test/unit_test.hpp>

#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_film_in_sight)

namespace {

IntegralCamera camera_of(Arrangement arrangement, double slant, std::optional<double> parallax)
{
    CameraParameters p;
    p.sheet = {arrangement, 1.27, 3.3, 1.6, slant, {0.031, -0.017}};
    p.film.pixel_pitch = {0.1, 0.127};
    p.parallax = parallax;
    if (parallax)
        p.viewing_distance = 410;
    ViewFrame view; // turned about y, with the sheet 7 units away
    view.location = {3, 2, -5};
    view.direction = {3, 0, 4};
    view.right = {0.8, 0, -0.6};
    view.up = {0, 0.8, 0};
    view.sheet_distance_ratio = 1.4;
    return make_camera(p, view, 150, 120);
}

} // namespace

BOOST_AUTO_TEST_CASE(lines_of_sight_lead_back_to_their_film_points)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0, 150), y(0, 120), along(-9, 9);
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 12.0, 80.0})
            for (const std::optional<double> parallax : {std::optional<double>(), {0.2}, {1.3}}) {
                const IntegralCamera camera = camera_of(arrangement, slant, parallax);
                int imaged = 0;
                for (int k = 0; k < 500; ++k) {
                    const Vec2 point = film_from_pixel(camera.film, {x(random), y(random)});
                    const auto ray = camera.optics.map(point, camera.mapping).ray;
                    if (!ray)
                        continue;
                    ++imaged;
                    const SightLine line = sight_line(camera, pole_beam(*ray));
                    const auto seen = film_in_sight(camera,
                                                    line.origin + along(random) * line.direction,
                                                    (k % 2 ? 3 : -0.2) * line.direction);
                    BOOST_REQUIRE(seen);
                    BOOST_TEST((seen->lens == ray->lens));
                    BOOST_TEST(length(seen->film_point - point) < 1e-9);
                }
                BOOST_TEST(imaged > 250);
            }
}

BOOST_AUTO_TEST_CASE(lines_along_the_sheet_show_nothing)
{
    const IntegralCamera camera = camera_of(Arrangement::square, 0, std::nullopt);
    BOOST_TEST(!film_in_sight(camera, {3, 2, -5}, camera.placement.x));
    BOOST_TEST(!film_in_sight(camera, {3, 2, -5}, camera.placement.x + 1e-13 * camera.placement.z));
}

BOOST_AUTO_TEST_SUITE_END()
