// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which measured setting is the best for a goal, and the command line for it.
#include "integral/batch/tune.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(batch_tune)

static std::vector<TunePoint> points()
{
    std::vector<TunePoint> all(3);
    const double figures[3][2] = {{0.05, 10}, {0.02, 40}, {0.018, 30}};
    for (int k = 0; k < 3; ++k) {
        all[k].error.rms = figures[k][0];
        all[k].error.low = 0.9 * figures[k][0];
        all[k].seconds = figures[k][1];
    }
    return all;
}

BOOST_AUTO_TEST_CASE(the_best_for_a_goal)
{
    BOOST_TEST(*best_point(points(), {0.02, {}}) == 2u); // both are good enough; the faster one
    BOOST_TEST(*best_point(points(), {0.06, {}}) == 0u);
    BOOST_TEST(!best_point(points(), {0.01, {}}));
    BOOST_TEST(*best_point(points(), {{}, 100}) == 2u); // the least error
    BOOST_TEST(*best_point(points(), {{}, 20}) == 0u);
    BOOST_TEST(!best_point(points(), {{}, 5}));
    BOOST_TEST(!best_point(points(), {0.02, 20}));
    BOOST_TEST(!best_point(points(), {{}, {}}));
    // An estimate whose interval reaches down to 0 counts by its upper bound.
    std::vector<TunePoint> vague = points();
    vague[1].error.rms = vague[1].error.low = 0;
    vague[1].error.high = 0.03;
    BOOST_TEST(!best_point(vague, {0.01, {}}));
    BOOST_TEST(*best_point(vague, {{}, 100}) == 2u);
}

BOOST_AUTO_TEST_CASE(the_command_keeps_the_options_and_the_camera)
{
    TuneResult result;
    result.camera = "lens_sheet { \"my sheet.json\" }";
    const TuneSetting brute{"pixel_samples 2 beam_samples 4", {"-A"}},
        smooth{"pixel_samples 1 beam_samples 1", {"+A0.1", "+AM2", "+R5"}};
    const std::vector<std::string> options = {"+W300", "Integral_Camera=" + result.camera,
                                              "Declare=it's=1"};
    BOOST_TEST(tuned_command("a b.pov", options, result, brute) ==
               "povray-integral '+Ia b.pov' +W300 'Declare=it'\\''s=1' 'Integral_Camera=lens_sheet "
               "{ \"my sheet.json\" } pixel_samples 2 beam_samples 4'");
    BOOST_TEST(tuned_command("x.ini", {}, TuneResult(), smooth) ==
               "povray-integral x.ini +A0.1 +AM2 +R5 'Integral_Camera=pixel_samples 1 "
               "beam_samples 1'");
}

BOOST_AUTO_TEST_SUITE_END()
