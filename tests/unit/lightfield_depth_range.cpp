// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares the depths of scenes with the depth budget; the values are worked out by hand.
#include "integral/lightfield/depth_range.h"
#include "integral/lightfield/sheet_figures.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace integral;

BOOST_AUTO_TEST_SUITE(lightfield_depth_range)

BOOST_AUTO_TEST_CASE(a_hundred_and_one_depths)
{
    constexpr float open = std::numeric_limits<float>::infinity();
    DepthFrame frame;
    for (int k = 100; k >= 0; --k) { // -30 to 70, in no order that helps
        frame.depth.push_back(float(k - 30));
        frame.imaged.push_back(1);
        frame.depth.push_back(k % 2 ? open : 1e6f);
        frame.imaged.push_back(k % 2 ? 1.0f : 0.0f);
    }
    const DepthRange range = depth_range(frame, 20);
    BOOST_TEST(range.pixels == 151u);
    BOOST_TEST(range.surfaces == 101u);
    BOOST_TEST(range.nearest == -30);
    BOOST_TEST(range.low == -29);
    BOOST_TEST(range.median == 20);
    BOOST_TEST(range.high == 69);
    BOOST_TEST(range.farthest == 70);
    BOOST_TEST(std::fabs(range.before - 10.0 / 101) < 1e-12); // -30 to -21
    BOOST_TEST(std::fabs(range.behind - 50.0 / 101) < 1e-12); // 21 to 70
    BOOST_TEST(depth_range(frame, {}).behind == 0);
}

BOOST_AUTO_TEST_CASE(nothing_to_see)
{
    DepthFrame frame;
    frame.depth = {0, std::numeric_limits<float>::infinity()};
    frame.imaged = {0, 1};
    const DepthRange range = depth_range(frame, 20);
    BOOST_TEST(range.pixels == 1u);
    BOOST_TEST(range.surfaces == 0u);
    BOOST_TEST(range.farthest == 0);
}

BOOST_AUTO_TEST_CASE(a_pixel_for_a_budget)
{
    // The thesis's sheet at 300 dpi has 24.89 mm (doc/guide.md); half the pixel has twice that.
    const LensSheet sheet{Arrangement::square, 1.27, 3.08, 1.6, 0, {}};
    for (const double budget : {1.0, 24.89, 90.0, 4000.0}) {
        const auto pixel = pixel_for_budget(sheet, budget);
        BOOST_REQUIRE(pixel);
        BOOST_TEST(std::fabs(*depth_budget(sheet, *pixel) - budget) < 1e-12 * budget);
        BOOST_TEST(std::fabs(*pixel_for_budget(sheet, budget / 2) - 2 * *pixel) < 1e-12 * *pixel);
    }
    // n^2 p^2 > 4 t^2 + p^2: the formula has nothing to say
    BOOST_TEST(!pixel_for_budget({Arrangement::square, 2, 1, 1.6, 0, {}}, 10));
}

BOOST_AUTO_TEST_SUITE_END()
