// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests how many views agree on a disparity, with views whose votes are worked out by hand.
#include "integral/depth/votes.h"

#include <boost/test/unit_test.hpp>

#include <functional>

using namespace integral;

namespace {

constexpr int width = 9, height = 8;
constexpr float grey = 0.5f, other = 0.9f;

/// A view whose channels all hold value(column, row).
DepthView view_of(Vec2 shift, const std::function<float(int, int)>& value)
{
    DepthView view;
    view.shift = shift;
    for (auto& channel : view.channels)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                channel.push_back(value(x, y));
    return view;
}

DepthView flat(Vec2 shift, float value)
{
    return view_of(shift, [value](int, int) { return value; });
}

ViewSet set_of(std::vector<DepthView> others)
{
    ViewSet views;
    views.width = width;
    views.height = height;
    views.middle = flat({0, 0}, grey);
    views.others = std::move(others);
    return views;
}

VoteSettings plain_settings()
{
    VoteSettings settings;
    settings.halves = false;
    return settings;
}

/// The mean votes of all pixels for a disparity, row by row.
std::vector<float> mean_votes(const ViewSet& views, const VoteSettings& settings,
                              double disparity = 0)
{
    std::vector<float> mean(std::size_t(width) * height);
    Votes(views, settings).count(disparity, 0, height, mean.data());
    return mean;
}

float at(const std::vector<float>& mean, int x, int y) { return mean[std::size_t(y) * width + x]; }

} // namespace

BOOST_AUTO_TEST_SUITE(depth_votes)

BOOST_AUTO_TEST_CASE(a_half_of_the_views_has_none_of_the_middle_row_or_column)
{
    // Among 24 views around the middle, the ten on one side agree, and the others do not.
    const std::function<bool(Vec2)> sides[] = {
        [](Vec2 s) { return s.x > 0; }, [](Vec2 s) { return s.x < 0; },
        [](Vec2 s) { return s.y > 0; }, [](Vec2 s) { return s.y < 0; }};
    for (const auto& is_on_side : sides) {
        std::vector<DepthView> others;
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i)
                if (i != 0 || j != 0) {
                    const Vec2 shift{double(i), double(j)};
                    others.push_back(flat(shift, is_on_side(shift) ? grey : other));
                }
        const ViewSet views = set_of(std::move(others));
        const float trust = 1 - 2 / 10.0f;
        BOOST_TEST(std::fabs(at(mean_votes(views, VoteSettings()), 4, 4) - trust) < 1e-4);
        BOOST_TEST(std::fabs(at(mean_votes(views, plain_settings()), 4, 4) - 10 / 24.0f) < 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(a_view_has_no_vote_on_what_it_does_not_show)
{
    const struct {
        double disparity;
        int first, last; ///< columns (or rows) without a vote at the picture's start and end
    } cases[] = {{0, 0, 0}, {1, 0, 1}, {-1, 1, 0}, {0.5, 1, 2}, {-0.5, 2, 1}, {2.25, 0, 4}};
    for (const auto& c : cases) {
        // A shifted view votes against the disparity, an unshifted one for it.
        const auto votes_by = [&](Vec2 shift) {
            return mean_votes(set_of({flat(shift, other), flat({0, 0}, grey)}), plain_settings(),
                              c.disparity);
        };
        const auto across = votes_by({1, 0}), down = votes_by({0, 1});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool has_column = x >= c.first && x < width - c.last,
                           has_row = y >= c.first && y < height - c.last;
                BOOST_TEST(std::fabs(at(across, x, y) - (has_column ? 0.5f : 1.0f)) < 1e-4,
                           c.disparity << " across, " << x);
                BOOST_TEST(std::fabs(at(down, x, y) - (has_row ? 0.5f : 1.0f)) < 1e-4,
                           c.disparity << " down, " << y);
            }
    }
}

BOOST_AUTO_TEST_CASE(a_point_is_sought_where_its_disparity_moves_it)
{
    // A white column 2 to the right and a white row 1 down, where a disparity of 1 moves them.
    ViewSet views = set_of(
        {view_of({2, 1}, [](int x, int y) { return x == 6 || y == 5 ? 1.0f : 0.0f; })});
    views.middle = view_of({0, 0}, [](int x, int y) { return x == 4 || y == 4 ? 1.0f : 0.0f; });
    VoteSettings settings = plain_settings();
    settings.tolerance = 0;
    const auto right = mean_votes(views, settings, 1), wrong = mean_votes(views, settings, -1);
    for (int y = 0; y < height - 1; ++y)
        for (int x = 0; x < width - 2; ++x)
            BOOST_TEST(at(right, x, y) == 1);
    BOOST_TEST(at(wrong, 4, 3) < 1e-5);
}

BOOST_AUTO_TEST_CASE(the_texture_along_the_shift_allows_a_difference)
{
    constexpr float slope = 0.02f, difference = 0.004f;
    const auto ramp = [](int x, int) { return slope * float(x); };
    const auto lighter = [](int x, int) { return slope * float(x) + difference; };
    const auto vote_of = [&](Vec2 shift) {
        ViewSet views = set_of({view_of(shift, lighter)});
        views.middle = view_of({0, 0}, ramp);
        return at(mean_votes(views, plain_settings()), 4, 4);
    };
    const float noise = 0.003f * 0.003f, texture = 0.2f * 0.2f * 3 * slope * slope,
                square = 3 * difference * difference;
    BOOST_TEST(std::fabs(vote_of({1, 0}) - 1 / (1 + square / (noise + texture))) < 1e-4);
    BOOST_TEST(std::fabs(vote_of({0, 1}) - 1 / (1 + square / noise)) < 1e-4);
}

BOOST_AUTO_TEST_CASE(views_without_light_do_not_count_but_few_are_not_trusted)
{
    std::vector<DepthView> others(20, flat({0, 1}, grey));
    for (int k = 0; k < 20; ++k) { // all have light in column 3, two in column 4, four in column 5
        auto& lit = others[std::size_t(k)].lit;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                lit.push_back(x == 3 || (x == 4 && k < 2) || (x == 5 && k < 4) ? 1.0f : 0.0f);
    }
    const auto mean = mean_votes(set_of(std::move(others)), plain_settings());
    BOOST_TEST(at(mean, 2, 4) == 0);
    BOOST_TEST(std::fabs(at(mean, 3, 4) - 1) < 1e-6);
    BOOST_TEST(std::fabs(at(mean, 4, 4) - 2 / 3.0f) < 1e-6); // divided by 3, which is 15% of 20
    BOOST_TEST(std::fabs(at(mean, 5, 4) - 1) < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_cross_has_the_middle_row_and_column_alone)
{
    BOOST_TEST(is_in_cross({0.5, 4}));
    BOOST_TEST(is_in_cross({-4, -0.5}));
    BOOST_TEST(!is_in_cross({0.52, 4}));
    BOOST_TEST(!is_in_cross({-4, 0.52}));
    BOOST_TEST(!is_in_cross({-1, -1}));
    VoteSettings settings = plain_settings();
    settings.cross = true;
    const ViewSet views = set_of(
        {flat({1, 0}, grey), flat({0, -1}, grey), flat({1, 1}, other), flat({-1, 1}, other)});
    BOOST_TEST(at(mean_votes(views, settings), 4, 4) == 1);
    BOOST_TEST(std::fabs(at(mean_votes(views, plain_settings()), 4, 4) - 0.5f) < 1e-4);
}

BOOST_AUTO_TEST_SUITE_END()
