// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/view_order.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// The farther half of the views on one side of the middle one: edges hide most from these.
std::vector<const DepthView*> far_views(const ViewSet& views, bool to_the_left)
{
    std::vector<const DepthView*> side;
    for (const DepthView& view : views.others)
        if (std::fabs(view.shift.y) < 0.5 && (to_the_left ? view.shift.x > 0 : view.shift.x < 0))
            side.push_back(&view);
    std::sort(side.begin(), side.end(), [](const DepthView* a, const DepthView* b) {
        return std::fabs(a->shift.x) > std::fabs(b->shift.x);
    });
    side.resize((side.size() + 1) / 2);
    return side;
}

/// Colour difference between a pixel of the middle view and the place in `view` where a point of
/// that disparity appears; 0 beyond the view's edge.
double difference(const ViewSet& views, const DepthView& view, int x, int y, double disparity)
{
    const double at = x + view.shift.x * disparity;
    if (!(at >= 0 && at < views.width - 1))
        return 0;
    const std::size_t row = std::size_t(y) * views.width, left = row + std::size_t(at);
    const double part = at - std::floor(at);
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto& values = view.channels[c];
        sum += std::fabs(values[left] + part * (values[left + 1] - values[left]) -
                         views.middle.channels[c][row + std::size_t(x)]);
    }
    return sum;
}

} // namespace

bool HiddenSides::is_reversed() const
{
    constexpr int least_edges = 30;
    return farther + nearer >= least_edges && nearer > 2 * farther;
}

HiddenSides hidden_sides(const ViewSet& views, const DepthMap& map)
{
    constexpr double least_step = 3; // of depth at an edge, pixels in the farthest view
    constexpr double least_evidence = 0.1;
    constexpr int beside = 1, flat = 4; // pixels from the edge: compared; of one depth
    const std::vector<const DepthView*> sides[] = {far_views(views, true), far_views(views, false)};
    if (sides[0].empty() || sides[1].empty())
        return {};
    const double farthest = std::max(std::fabs(sides[0][0]->shift.x),
                                     std::fabs(sides[1][0]->shift.x)),
                 step = least_step / farthest;
    // A surface beyond the range is measured at its end.
    const auto is_at_end = [&](float disparity) {
        const bool is_known = map.range.least < map.range.greatest;
        return is_known && (disparity < map.range.least + 0.1 * step ||
                            disparity > map.range.greatest - 0.1 * step);
    };
    HiddenSides hidden;
    for (int y = 0; y < map.height; ++y)
        for (int x = flat; x + 1 + flat < map.width; ++x) {
            const float* at = &map.disparity[std::size_t(y) * map.width + x];
            const bool is_edge = std::fabs(at[0] - at[1]) >= step &&
                                 std::fabs(at[-flat] - at[0]) < 0.25 * step &&
                                 std::fabs(at[1 + flat] - at[1]) < 0.25 * step;
            if (!is_edge || is_at_end(at[0]) || is_at_end(at[1]))
                continue;
            // The mean difference in the far views of a side: the greater of both sides' means.
            const auto missing = [&](int pixel) {
                double worst = 0;
                for (const auto& side : sides) {
                    double sum = 0;
                    for (const DepthView* view : side)
                        sum += difference(views, *view, pixel, y, at[pixel - x]);
                    worst = std::max(worst, sum / double(side.size()));
                }
                return worst;
            };
            const double left = missing(x - beside), right = missing(x + 1 + beside),
                         of_farther = at[0] < at[1] ? left - right : right - left;
            hidden.farther += of_farther > least_evidence;
            hidden.nearer += of_farther < -least_evidence;
        }
    return hidden;
}

} // namespace integral
