// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests how pictures share the viewing zone.
#include "integral/sheet/zone_shares.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(sheet_zone_shares)

namespace {

/// The share of picture k at a place of the zone.
double part_of(const ZoneShares& shares, int k, double place)
{
    const PictureMix mix = shares.at(place);
    return (mix.first == k ? 1 - mix.part : 0) + (mix.second == k ? mix.part : 0);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_flip_changes_at_once_where_the_shares_end)
{
    const ZoneShares shares({{1, 2, 1}, 0, false});
    const double places[] = {0, 0.2499, 0.2501, 0.7499, 0.7501, 0.9999};
    const int requested[] = {0, 0, 1, 1, 2, 2};
    for (int k = 0; k < 6; ++k)
        BOOST_TEST(part_of(shares, requested[k], places[k]) == 1);
}

BOOST_AUTO_TEST_CASE(side_lobes_repeat_the_zone)
{
    const ZoneShares shares({{1, 1}, 0.5, true});
    for (const double place : {0.01, 0.24, 0.5, 0.76})
        for (const int k : {-3, 2})
            BOOST_TEST(part_of(shares, 0, place + k) == part_of(shares, 0, place),
                       boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_transition_is_a_part_of_the_smaller_neighbour)
{
    // Shares 0.2 and 0.8; half of 0.2 is the transition: 0.15 to 0.25.
    const ZoneShares shares({{1, 4}, 0.5, false});
    BOOST_TEST(shares.half_transition(1) == 0.05, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(part_of(shares, 1, 0.149) == 0);
    BOOST_TEST(part_of(shares, 1, 0.175) == 0.25, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(part_of(shares, 1, 0.2) == 0.5, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(part_of(shares, 1, 0.251) == 1);
    // At the zone's edge the pictures change at once.
    BOOST_TEST(part_of(shares, 0, 0.001) == 1);
    BOOST_TEST(part_of(shares, 1, 0.999) == 1);
}

BOOST_AUTO_TEST_CASE(a_morph_is_linear_between_the_shares_middles)
{
    const ZoneShares shares({{1, 1, 1}, 1, false});
    for (const double t : {0.0, 0.3, 0.9})
        BOOST_TEST(part_of(shares, 1, 1 / 6. + t / 3) == t,
                   boost::test_tools::tolerance(1e-9));
    BOOST_TEST(part_of(shares, 0, 0.05) == 1);
}

BOOST_AUTO_TEST_CASE(a_loop_has_the_same_transition_at_the_edge)
{
    const ZoneShares shares({{1, 1}, 1, true});
    for (const double t : {0.0, 0.1, 0.24})
        BOOST_TEST(part_of(shares, 0, t) == 0.5 + 2 * t, boost::test_tools::tolerance(1e-9));
    for (const double place : {0.1, 0.4, 0.6, 0.95})
        BOOST_TEST(part_of(shares, 0, place) + part_of(shares, 1, place) == 1,
                   boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(shares_of_nothing_are_refused)
{
    BOOST_CHECK_THROW(ZoneShares({{}, 0, false}), std::invalid_argument);
    BOOST_CHECK_THROW(ZoneShares({{1, 0}, 0, false}), std::invalid_argument);
    BOOST_CHECK_THROW(ZoneShares({{1, -2}, 0, false}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
