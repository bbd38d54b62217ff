// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_quality.h"

#include <algorithm>
#include <cmath>

namespace integral {

std::optional<DepthQuality> depth_quality(const std::string& name)
{
    if (name == "draft")
        return DepthQuality::draft;
    if (name == "good")
        return DepthQuality::good;
    if (name == "best")
        return DepthQuality::best;
    return std::nullopt;
}

MultibaselineSettings settings_for(DepthQuality quality)
{
    MultibaselineSettings settings;
    if (quality == DepthQuality::draft) {
        settings.step = 0.3;
        settings.votes.tolerance = 0.2;
        settings.filter = {3, 3, 0.12};
        settings.median = {2, 2, 0.12};
    } else if (quality == DepthQuality::best) {
        settings.step = 0.12;
    }
    return settings;
}

void keep_views(ViewSet& views, DepthQuality quality)
{
    constexpr double half = 0.5 + 1e-3; // of even grids the nearest to the middle are so far off
    if (quality == DepthQuality::best)
        return;
    const auto is_left_out = [&](const DepthView& view) {
        const double x = std::fabs(view.shift.x), y = std::fabs(view.shift.y);
        const bool on_cross = std::min(x, y) < half,
                   on_diagonal = std::fabs(x - y) < half && quality == DepthQuality::good;
        return !on_cross && !on_diagonal;
    };
    views.others.erase(std::remove_if(views.others.begin(), views.others.end(), is_left_out),
                       views.others.end());
}

} // namespace integral
