// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which side of an edge is hidden, with rows of pixels worked out by hand.
#include "integral/depth/view_order.h"

#include <boost/test/unit_test.hpp>

#include <functional>

using namespace integral;

namespace {

constexpr int width = 40, height = 30;
constexpr int shift = 3; // pixels, for the disparity 1

/// A view whose rows all hold value(column).
DepthView view_of(double moved, const std::function<float(int)>& value)
{
    DepthView view;
    view.shift = {moved, 0};
    for (auto& channel : view.channels)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                channel.push_back(value(x));
    return view;
}

/// A middle view and one on either side.
ViewSet set_of(const std::function<float(int)>& middle, const std::function<float(int)>& plus,
               const std::function<float(int)>& minus)
{
    ViewSet views;
    views.width = width;
    views.height = height;
    views.middle = view_of(0, middle);
    views.others = {view_of(shift, plus), view_of(-shift, minus)};
    return views;
}

/// Disparity 0 to the left of `first_near`, 1 from there on.
DepthMap step_at(const ViewSet& views, int first_near)
{
    DepthMap map = blank_map(views);
    for (int y = 0; y < height; ++y)
        for (int x = first_near; x < width; ++x)
            map.disparity[std::size_t(y) * width + std::size_t(x)] = 1;
    return map;
}

float far_colour(int x) { return x % 2 ? 0.1f : 0.3f; }
float near_colour(int x) { return x % 2 ? 0.7f : 0.9f; }

} // namespace

BOOST_AUTO_TEST_SUITE(depth_view_order)

BOOST_AUTO_TEST_CASE(the_surface_that_a_view_lacks_is_the_hidden_one)
{
    constexpr int edge = 20;
    for (const bool reversed : {false, true}) {
        // The view whose near pixels stand `moved` to the right. Where both surfaces stand, the
        // near one is seen, or in reversed views the far one; where neither does, the far one.
        const auto view = [&](int moved) {
            return [=](int x) {
                const bool near = x - moved >= edge && !(reversed && x < edge);
                return near ? near_colour(x - moved) : far_colour(x);
            };
        };
        const ViewSet views = set_of(view(0), view(shift), view(-shift));
        const HiddenSides hidden = hidden_sides(views, step_at(views, edge));
        BOOST_TEST(hidden.farther == (reversed ? 0 : height));
        BOOST_TEST(hidden.nearer == (reversed ? height : 0));
        BOOST_TEST(hidden.is_reversed() == reversed);
    }
}

BOOST_AUTO_TEST_CASE(from_a_view_s_last_column_on_nothing_is_compared)
{
    const auto grey = [](int) { return 0.5f; };
    // The pixel that is compared on the near side is two to the right of the edge's last far one.
    for (const int last_far : {width - 6, width - 7}) {
        const bool is_within = last_far + 2 + shift < width - 1;
        const ViewSet views = set_of(
            grey, [](int x) { return x >= width - 2 ? 0 : 0.5f; }, grey);
        const HiddenSides hidden = hidden_sides(views, step_at(views, last_far + 1));
        BOOST_TEST(hidden.farther == 0);
        BOOST_TEST(hidden.nearer == (is_within ? height : 0));
    }
}

BOOST_AUTO_TEST_SUITE_END()
