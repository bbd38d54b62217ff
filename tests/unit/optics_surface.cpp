// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the lenses' curved surface: an eye on a ray that leaves the surface sees back along it.
#include "integral/optics/beam.h"
#include "integral/optics/lens_surface.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <string>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_surface)

BOOST_AUTO_TEST_CASE(an_eye_on_a_ray_sees_the_film_point_that_sent_it)
{
    std::mt19937 random(11);
    const auto even = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    long met_first = 0, hidden = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        LensSheet sheet;
        sheet.arrangement = Arrangement(trial % 3);
        sheet.pitch = even(0.2, 3);
        sheet.ior = even(1.2, 2);
        sheet.thickness = sheet.ior / (sheet.ior - 1) * cell_circumradius(sheet) * even(1, 3);
        sheet.slant = even(-80, 80);
        const SheetOptics optics(sheet, {300, 100, 100}, LensModel::full);
        const SheetSurface surface(sheet);
        const LensIndex lens = optics.lattice().nearest({even(-5, 5), even(-5, 5)});
        const LensPoint point = cell_point(optics.lattice(), {even(0, 1), even(0, 1)}, 50);
        const double reach = 0.5 * sheet.pitch;
        const Vec2 film_point = optics.lattice().pole(lens) +
                                Vec2{even(-reach, reach), even(-reach, reach)};
        const auto ray = beam_ray(optics, film_point, lens, point);
        if (!ray)
            continue;
        const Vec2 slope{ray->direction.x / ray->direction.z, ray->direction.y / ray->direction.z};
        const Vec2 at_poles = Vec2{ray->point.x, ray->point.y} - ray->point.z * slope;
        const auto met = surface.first_intersection(at_poles, slope);
        const std::string what = "trial " + std::to_string(trial);
        BOOST_REQUIRE_MESSAGE(met && met->depth <= ray->point.z + 1e-9, what);
        if (met->depth < ray->point.z - 1e-6 * sheet.pitch) { // the edge of a neighbour hides it
            ++hidden;
            continue;
        }
        ++met_first;
        const auto seen = surface.film_point_seen(at_poles, slope, 0);
        BOOST_REQUIRE_MESSAGE(seen, what);
        BOOST_TEST(length(*seen - film_point) < 1e-6 * sheet.thickness, what);
    }
    BOOST_TEST(met_first > 10000);
    BOOST_TEST_MESSAGE(met_first << " rays, and " << hidden << " hidden by a neighbour's edge");
}

BOOST_AUTO_TEST_SUITE_END()
