// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares the depths of scenes with the depth budget; the values are worked out by hand.
#include "integral/lightfield/depth_range.h"

#include "integral/lightfield/depth_advice.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace integral;

BOOST_AUTO_TEST_SUITE(lightfield_depth_range)

BOOST_AUTO_TEST_CASE(a_hundred_and_one_depths)
{
    constexpr float open = std::numeric_limits<float>::infinity();
    DepthFrame frame;
    for (int k = 100; k >= 0; --k) { // 70 down to -30
        frame.depth.push_back(float(k - 30));
        frame.imaged.push_back(1);
        frame.depth.push_back(k % 2 ? open : 1e6f);
        frame.imaged.push_back(k % 2 ? 1.0f : 0.0f);
    }
    const DepthRange range = depth_range(frame, 20);
    BOOST_TEST(range.pixels == 151u);
    BOOST_TEST(range.surfaces == 101u);
    BOOST_TEST(range.nearest == -30);
    BOOST_TEST(range.twentieth == -25);
    BOOST_TEST(range.median == 20);
    BOOST_TEST(range.last_twentieth == 65);
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

/// A frame of these depths, behind square lenses of 1.27 mm at 300 dpi, placed 100 units from the
/// eye at two mm a unit.
static DepthFrame frame_of(const std::vector<float>& depths)
{
    DepthFrame frame;
    frame.depth = depths;
    frame.imaged.assign(depths.size(), 1);
    frame.metadata.sheet.arrangement = Arrangement::square;
    frame.metadata.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    frame.metadata.aperture.distance = 200;
    Placement placement;
    placement.units_per_mm = 0.5;
    placement.sheet_distance = 100;
    frame.metadata.placement = placement;
    return frame;
}

BOOST_AUTO_TEST_CASE(advice_by_hand)
{
    // Depths 1 to 100 mm behind the sheet; the budget is 20 mm.
    std::vector<float> depths;
    for (int k = 1; k <= 100; ++k)
        depths.push_back(float(k));
    DepthFrame frame = frame_of(depths);
    const DepthAdvice advice = depth_advice(frame, 20);
    BOOST_TEST(advice.now.sharp == 0.20);
    BOOST_TEST(advice.now.soft == 0.20, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(advice.now.beyond == 0.60, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(advice.sheet_distance == 100);
    // The depth budget grows with the sheet's distance D from the eye, so that what is 0.9 D to
    // 1.1 D from the eye is sharp. The surfaces are 100.5 to 150 units from the eye. A range of 0.9
    // D to 1.1 D holds most of them where it ends at the farthest: it then begins at 150 x 0.9/1.1
    // = 122.7 units, which is 45.5 mm, and holds the 55 surfaces of 46 to 100 mm. The nearest range
    // that holds as many is that of 43 to 97 mm, which is 121.5 to 148.5 units: D = 135.
    BOOST_REQUIRE(advice.sheet.has_value());
    BOOST_TEST(advice.sheet->sharp == 0.55);
    BOOST_TEST(advice.sheet->value == 135, boost::test_tools::tolerance(0.001));
    // To bring 95 of them within 20 mm, depths would have to be compressed to 20/95 = 0.21. The
    // most that is advised is 0.25, which brings 80 within 20 mm.
    BOOST_REQUIRE(advice.compress.has_value());
    BOOST_TEST(advice.compress->value == 0.25);
    BOOST_TEST(advice.compress->sharp == 0.80);
    // The budget is 20 mm at 300 dpi, 80 mm at 1200 dpi and 96 mm at 1440 dpi.
    BOOST_REQUIRE(advice.dpi.has_value());
    BOOST_TEST(advice.dpi->value == 1440);
    BOOST_TEST(advice.dpi->sharp == 0.96);
    // With a fixed scale the budget does not grow: 20 mm to either side of a surface hold 41.
    frame.metadata.placement->scale_is_given = true;
    BOOST_TEST(depth_advice(frame, 20).sheet->sharp == 0.41);
    // The resolution of a panel cannot be changed.
    frame.metadata.film.subpixels = Subpixels::rgb;
    BOOST_TEST(!depth_advice(frame, 20).dpi.has_value());
}

BOOST_AUTO_TEST_CASE(no_advice_of_numbers_that_nobody_can_use)
{
    // A thousand things in the budget, and as many at the horizon.
    std::vector<float> depths(1000, 5);
    depths.resize(2000, 1e6f);
    const DepthAdvice advice = depth_advice(frame_of(depths), 20);
    BOOST_TEST(advice.now.beyond == 0.5);
    BOOST_TEST(!advice.sheet.has_value()); // either half, not both
    BOOST_TEST(!advice.compress.has_value());
    BOOST_TEST(!advice.dpi.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
