// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the measured depth where there is hardly any texture: plain walls behind objects, and
// polished floors.
#include "integral/depth/depth_scores.h"
#include "integral/depth/multibaseline.h"
#include "integral/depth/plane_filter.h"
#include "integral/depth/surface_fill.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace integral;

namespace {

ViewSet grey_set(int width, int height)
{
    ViewSet views;
    views.width = width;
    views.height = height;
    for (auto& channel : views.colours)
        channel.assign(views.pixels(), 0.5f);
    views.middle.channels = views.colours;
    DepthView right;
    right.shift = {1, 0};
    DepthView above;
    above.shift = {0, 1};
    views.others = {right, above};
    return views;
}

/// A chequered floor of disparity 0 as seen from 5 x 5 eyes; it reflects faint stripes of disparity
/// -1.2.
ViewSet polished_floor(int size)
{
    constexpr int grid = 5, tile = 16;
    std::vector<Image> all;
    for (int row = 0; row < grid; ++row)
        for (int column = 0; column < grid; ++column) {
            Image image = make_image<std::uint16_t>(size, size, 3, Encoding());
            const double to_left = -1.2 * (column - grid / 2), down = 1.2 * (row - grid / 2);
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const bool light = ((x / tile) + (y / tile)) % 2 == 0;
                    const double stripes = std::sin(0.5 * (x + to_left)) +
                                           std::sin(0.4 * (y + down) + 1);
                    const float grey = float((light ? 0.75 : 0.35) + 0.012 * stripes);
                    store_pixel(image, x, y, {grey, grey, grey, 1});
                }
            all.push_back(std::move(image));
        }
    return view_set(all, {grid, grid}, std::nullopt);
}

} // namespace

BOOST_AUTO_TEST_SUITE(depth_surface_fill)

BOOST_AUTO_TEST_CASE(a_plain_wall_is_not_as_near_as_what_stands_before_it)
{
    // A square of another colour in front of a wall, on which a shadow's edge shows. Only pixels
    // near edges have a measured depth; on the wall next to the square it is wrong, namely the
    // square's.
    constexpr int size = 160;
    ViewSet views = grey_set(size, size);
    std::vector<float> disparity(views.pixels(), 0), confidence(views.pixels(), 0);
    const auto away = [](int x, int y) { // from the square's edge; less than 0 inside
        return std::max({40 - x, x - 90, 40 - y, y - 90});
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const std::size_t i = std::size_t(y) * size + x;
            if (away(x, y) < 0)
                views.colours[0][i] = 0.9f;
            if (x > 120)
                for (auto& channel : views.colours)
                    channel[i] = 0.3f;
            if (std::abs(away(x, y)) < 4) {
                disparity[i] = 1;
                confidence[i] = 0.4f;
            }
            if (std::abs(x - 120) < 4) {
                disparity[i] = -1;
                confidence[i] = 0.4f;
            }
        }
    fill_surfaces(views, 160, 2, disparity, confidence);
    // Pixels nearer to the other surface's depth than to their own.
    int all = 0, wrong = 0;
    for (int y = 2; y < size - 2; ++y)
        for (int x = 2; x < size - 2; ++x) {
            if (std::abs(away(x, y)) < 5)
                continue;
            const float truth = away(x, y) < 0 ? 1.0f : -1.0f;
            ++all;
            wrong += !(std::fabs(disparity[std::size_t(y) * size + x] - truth) < 1);
        }
    BOOST_TEST(wrong < 0.02 * all);
}

BOOST_AUTO_TEST_CASE(a_dark_floor_has_its_own_depth_and_not_the_walls_above)
{
    // The floor slopes towards the eye from the foot of a textured wall. It has the wall's darkest
    // colour, and every second pixel of it has a faint texture.
    constexpr int size = 160, foot = 60;
    ViewSet views = grey_set(size, size);
    std::vector<float> disparity(views.pixels(), -1), confidence(views.pixels(), 0.5f), all_truth;
    const auto truth = [&](int y) { return -1 + 0.01f * float(std::max(0, y - foot)); };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const std::size_t i = std::size_t(y) * size + x;
            for (auto& channel : views.colours)
                channel[i] = y >= foot || (x / 5 + y / 5) % 2 ? 0.1f : 0.4f;
            all_truth.push_back(truth(y));
            if (y >= foot) {
                const bool textured = (x + y) % 2 == 0;
                disparity[i] = textured ? truth(y) : float((7 * x + 3 * y) % 11) / 5 - 1;
                confidence[i] = textured ? 0.25f : 0.02f;
            }
        }
    fill_surfaces(views, 160, 2, disparity, confidence);
    BOOST_TEST(depth_scores(views, disparity, all_truth, 2).all.bad[0] < 3);
}

BOOST_AUTO_TEST_CASE(planes_go_on_and_level_out)
{
    const ViewSet views = grey_set(90, 60);
    std::vector<float> value(views.pixels()), weight(views.pixels());
    const auto plane = [](int x, int y) { return float(0.02 * x + 0.03 * y); };
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 90; ++x) {
            value[std::size_t(y) * 90 + x] = plane(x, y);
            weight[std::size_t(y) * 90 + x] = (x + y) % 7 == 0 ? 0.5f : 0;
        }
    const auto fit = PlaneFilter(views, {8, 0.05, 0}, 1).planes(value, weight);
    for (const auto& [x, y] : {std::pair{45, 30}, {20, 20}, {70, 40}})
        BOOST_TEST(std::fabs(fit.value[std::size_t(y) * 90 + x] - plane(x, y)) < 0.02);
    // At a corner of the picture, all pixels that count lie on one side, so that the mean is off by
    // the slope over several pixels.
    const float mean = PlaneFilter(views, {8, 0.05, 0}, 1).means(value, weight).value[0];
    BOOST_TEST(mean > 0.07);
    BOOST_TEST(std::fabs(fit.value[0]) < 0.5 * mean);
    const std::vector<float> none(views.pixels(), 0);
    BOOST_TEST(std::isnan(PlaneFilter(views, {8, 0.05, 0}, 1).planes(value, none).value[9]));
}

BOOST_AUTO_TEST_CASE(a_polished_floor_is_not_as_far_as_what_mirrors_in_it)
{
    constexpr int size = 144;
    ViewSet views = polished_floor(size);
    soften(views, 2);
    const std::vector<float> truth(views.pixels(), 0);
    const auto bad = [&](double reach) {
        MultibaselineSettings settings;
        settings.range = DisparityRange{-1.6, 0.6};
        settings.reach = reach;
        const auto map = multibaseline(views, settings, 2, {});
        BOOST_REQUIRE(map);
        return depth_scores(views, map->disparity, truth, 8).all.bad[0];
    };
    const double without = bad(0), with = bad(160);
    BOOST_TEST(without > 30);
    BOOST_TEST(with < 0.5 * without);
}

BOOST_AUTO_TEST_SUITE_END()
