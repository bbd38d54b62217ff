// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks the words that name eyes, and limits for the views that eyes see.
#include "integral/compare/compare_limits.h"
#include "integral/compare/seen.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(compare_seen)

BOOST_AUTO_TEST_CASE(words_of_eyes)
{
    const SeenEyes grid = seen_eyes_of({"5x3"});
    BOOST_TEST(grid.columns == 5);
    BOOST_TEST(grid.rows == 3);
    BOOST_TEST(grid.places.empty());
    const SeenEyes two = seen_eyes_of({"-20,0,400", "20.5,1e1,400"});
    BOOST_TEST(two.columns == 0);
    BOOST_REQUIRE(two.places.size() == 2);
    BOOST_TEST(two.places[1].x == 20.5);
    BOOST_TEST(two.places[1].y == 10);
    BOOST_TEST(two.places[0].z == 400);
    const std::vector<std::vector<std::string>> bad = {
        {},          {""},      {"3"},       {"0x3"},          {"17x1"},
        {"3x3x3"},   {"1.5x2"}, {"1,2"},     {"1,2,0"},        {"1,2,-3"},
        {"1,2,3,4"}, {"a,b,c"}, {"1,2,inf"}, {"3x3", "1,2,3"}, {"1,2,3 "}};
    for (const auto& words : bad)
        BOOST_CHECK_THROW(seen_eyes_of(words), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(limits_are_for_what_eyes_see)
{
    Comparison pixels;
    pixels.rmse = 0.5;
    pixels.worst = WorstMicroImage{{}, {}, 0.7};
    auto seen = std::make_shared<SeenFigures>();
    seen->overall.rmse = 0.01;
    seen->overall.ssim = 1;
    pixels.seen = seen;
    Limits limits;
    limits[0] = 0.02;
    BOOST_TEST(missed_limits(limits, pixels).empty());
    limits[0] = 0.005;
    limits[4] = 0.6;
    const std::vector<std::string> expected = {
        "as seen, RMSE 0.01 is greater than 0.005",
        "the worst micro-image's RMSE 0.7 is greater than 0.6"};
    BOOST_TEST(missed_limits(limits, pixels) == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
