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
        settings.filter = {3, 3, 0.12};
        settings.median = {2, 2, 0.12};
    } else if (quality == DepthQuality::best) {
        settings.step = 0.16;
        settings.filter = {7, 7, 0.12};
    }
    return settings;
}

bool is_kept(Vec2 shift, DepthQuality quality)
{
    const bool on_diagonal = std::fabs(std::fabs(shift.x) - std::fabs(shift.y)) < 0.51;
    return is_in_cross(shift) || (quality != DepthQuality::draft && on_diagonal);
}

void keep_views(ViewSet& views, DepthQuality quality)
{
    const auto is_left_out = [&](const DepthView& view) { return !is_kept(view.shift, quality); };
    views.others.erase(std::remove_if(views.others.begin(), views.others.end(), is_left_out),
                       views.others.end());
}

} // namespace integral
