// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares the depths of scenes with the depth budget; the values are worked out by hand.
#include "integral/frame/depth_range.h"

#include "integral/sheet/depth_advice.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace integral;

BOOST_AUTO_TEST_SUITE(frame_depth_range)

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
    // The surfaces are 100.5 to 150 units from the eye, and 103 to 147.5 without a twentieth at
    // either end; a budget is a tenth of the viewing distance. With R = 147.5/103, 1/K - 1 = (0.9 R
    // - 1.1)/(0.1 (1.1 + 0.9 R)) = 0.7905, and D = 103 (K + 0.1 (1 - K))/(0.9 K).
    BOOST_REQUIRE(advice.fits.size() == 2);
    BOOST_TEST(advice.fits[0].fit.parallax == 0.55851, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(advice.fits[0].fit.sheet_distance == 123.491, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(advice.fits[0].shares.sharp == 0.90);
    // The scene is shallower than two budgets: the sheet is in its middle, and 0.9 to 1.1 times
    // 125.25 units hold the 50 surfaces of 26 to 75 mm.
    BOOST_TEST(advice.fits[1].fit.parallax == 1);
    BOOST_TEST(advice.fits[1].fit.sheet_distance == 125.25);
    BOOST_TEST(advice.fits[1].shares.sharp == 0.5);
    BOOST_TEST(advice.fits[1].shares.soft == 0.5);
    // The budget is 20 mm at 300 dpi, 80 mm at 1200 dpi and 96 mm at 1440 dpi.
    BOOST_REQUIRE(advice.dpi.has_value());
    BOOST_TEST(advice.dpi->value == 1440);
    BOOST_TEST(advice.dpi->sharp == 0.96);
    // The resolution of a panel cannot be changed.
    frame.metadata.film.subpixels = Subpixels::rgb;
    BOOST_TEST(!depth_advice(frame, 20).dpi.has_value());
}

BOOST_AUTO_TEST_CASE(the_fit_of_a_frame_with_parallax_is_the_fit_of_its_scene)
{
    // The same scene, seen with parallax 0.3 about a sheet at 100 units of 0.5 mm: z' = 0.3 z
    // 200/(200 + 0.7 z).
    std::vector<float> depths, seen;
    for (int k = 1; k <= 100; ++k) {
        depths.push_back(float(k));
        seen.push_back(float(0.3 * k * 200 / (200 + 0.7 * k)));
    }
    DepthFrame frame = frame_of(seen);
    frame.metadata.parallax = Parallax{0.3, 200};
    const DepthAdvice with = depth_advice(frame, 20), without = depth_advice(frame_of(depths), 20);
    for (int k = 0; k < 2; ++k) {
        BOOST_TEST(with.fits[k].fit.parallax == without.fits[k].fit.parallax,
                   boost::test_tools::tolerance(1e-5));
        BOOST_TEST(with.fits[k].fit.sheet_distance == without.fits[k].fit.sheet_distance,
                   boost::test_tools::tolerance(1e-5));
    }
    BOOST_TEST(with.now.sharp > without.now.sharp);
}

BOOST_AUTO_TEST_CASE(no_advice_of_numbers_that_nobody_can_use)
{
    // 1000 surfaces within the budget, and 1000 at the horizon.
    std::vector<float> depths(1000, 5);
    depths.resize(2000, 1e6f);
    const DepthAdvice advice = depth_advice(frame_of(depths), 20);
    BOOST_TEST(advice.now.beyond == 0.5);
    BOOST_TEST(!advice.dpi.has_value());
}

BOOST_AUTO_TEST_CASE(what_the_scenes_eye_sees_decides_and_not_what_the_aperture_sees)
{
    // The frame's depths are those that its aperture sees, a near and a far floor. The scene's eye
    // sees a wall, and nothing in a tenth of the picture. The budget is 20 mm of 200 mm.
    DepthFrame frame = frame_of({-90, -80, 500, 1000});
    constexpr float open = std::numeric_limits<float>::infinity();
    for (int k = 0; k < 90; ++k)
        frame.eye_distances.push_back(k < 45 ? 104 : 116); // 8 and 32 mm behind the sheet
    frame.eye_distances.insert(frame.eye_distances.end(), 10, open);
    const DepthAdvice advice = depth_advice(frame, 20);
    BOOST_TEST(advice.now.sharp == 0.45);
    BOOST_TEST(advice.now.soft == 0.45, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(advice.now.beyond == 0.1, boost::test_tools::tolerance(1e-12));
    // The sky is seen at the far end of the budget: 1/K - 1 = 200/20.
    BOOST_REQUIRE(advice.fits.size() == 2);
    BOOST_TEST(advice.fits[0].fit.parallax == 1 / 11.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(advice.fits[0].shares.sharp == 1);
    const DepthFrame seen = as_scene_eye_sees(frame);
    BOOST_TEST(seen.depth.size() == 100u);
    BOOST_TEST(seen.depth[0] == 8, boost::test_tools::tolerance(1e-5f));
    BOOST_TEST(std::isinf(seen.depth[99]));
    BOOST_TEST(depth_range(seen, 20).surfaces == 90u);
    BOOST_TEST(as_scene_eye_sees(frame_of({5})).depth[0] == 5);
}

BOOST_AUTO_TEST_SUITE_END()
