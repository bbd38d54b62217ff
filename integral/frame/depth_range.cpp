// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/depth_range.h"

#include <algorithm>
#include <cmath>

namespace integral {

DepthRange depth_range(const DepthFrame& frame, std::optional<double> budget)
{
    DepthRange range;
    std::vector<float> depths;
    for (std::size_t k = 0; k < frame.depth.size(); ++k) {
        if (!(frame.imaged[k] > 0))
            continue;
        ++range.pixels;
        if (std::isfinite(frame.depth[k]))
            depths.push_back(frame.depth[k]);
    }
    range.surfaces = depths.size();
    if (depths.empty())
        return range;
    const auto part = [&](double fraction) { // the quantile of that fraction
        const auto at = depths.begin() + std::ptrdiff_t(fraction * double(depths.size() - 1));
        std::nth_element(depths.begin(), at, depths.end());
        return double(*at);
    };
    range.nearest = part(0);
    range.twentieth = part(0.05);
    range.median = part(0.5);
    range.last_twentieth = part(0.95);
    range.farthest = part(1);
    if (budget) {
        const auto share = [&](auto beyond) {
            return double(std::count_if(depths.begin(), depths.end(), beyond)) /
                   double(depths.size());
        };
        range.before = share([&](float depth) { return depth < -*budget; });
        range.behind = share([&](float depth) { return depth > *budget; });
    }
    return range;
}

} // namespace integral
