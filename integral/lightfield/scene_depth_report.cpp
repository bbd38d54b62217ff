// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/scene_depth_report.h"

#include "integral/lightfield/sheet_figures.h"
#include "integral/lightfield/sheet_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace integral {
namespace {

/// How a scene that reaches beyond its budget could be brought within it.
struct Remedy {
    double shift;  ///< how far back the sheet would move into the middle of the depths, mm
    double needed; ///< the budget that would then be enough, mm
    std::optional<double> pixel; ///< the pixel pitch that gives this budget, mm
};

struct Judged {
    std::optional<double> budget; ///< mm
    DepthRange range;
    Remedy remedy;
};

Judged judge(const DepthFrame& depths)
{
    const LensSheet& sheet = depths.metadata.sheet;
    Judged j;
    j.budget = depth_budget(sheet, counted(depths.metadata).pixel);
    j.range = depth_range(depths, j.budget);
    j.remedy.shift = 0.5 * (j.range.low + j.range.high);
    j.remedy.needed = 0.5 * (j.range.high - j.range.low);
    if (j.remedy.needed > 0)
        j.remedy.pixel = pixel_for_budget(sheet, j.remedy.needed);
    return j;
}

template <class... Values> std::string line(const char* format, Values... values)
{
    char text[300];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

/// The resolution at a depth, (4-6) or the lenses' own where that is less, as a column of text.
std::string resolution_at(const DepthFrame& depths, double depth)
{
    const auto sheet_only = observer_resolution(depths.metadata.sheet.pitch,
                                                depths.metadata.aperture.distance, 0);
    const auto lpi = depth_resolution(depths.metadata.sheet, counted(depths.metadata).pixel,
                                      std::max(1e-9, std::fabs(depth)));
    return lpi ? line("%10.4g", std::min(*lpi, sheet_only)) : std::string("         -");
}

} // namespace

std::string scene_depth_text(const std::string& scene, const DepthFrame& depths)
{
    const Judged j = judge(depths);
    const DepthRange& r = j.range;
    std::string text = "\nDepths of " + scene + "\n";
    if (r.surfaces == 0)
        return text + "  no pixel shows a surface\n";
    text += "                mm behind     lpi there\n"
            "                the sheet  (at most lenses)\n";
    const auto row = [&](const char* label, double depth) {
        text += line("  %-12s%11.4g", label, depth) + resolution_at(depths, depth) + "\n";
    };
    row("nearest", r.nearest);
    row("1 in 100", r.low);
    row("middle", r.median);
    row("99 in 100", r.high);
    row("farthest", r.farthest);
    text += line("  no surface: %.1f%% of the pixels\n",
                 100 * (1 - double(r.surfaces) / double(r.pixels)));
    if (!j.budget)
        return text + "  depth budget: (4-6) has none for this sheet\n";
    text += line("  depth budget %.4g mm either side: %.1f%% of the surfaces are within it, %.1f%% "
                 "before it, %.1f%% behind it\n",
                 *j.budget, 100 * (1 - r.before - r.behind), 100 * r.before, 100 * r.behind);
    if (std::max(-r.low, r.high) <= *j.budget)
        return text + "  all but a hundredth at either end is sharp\n";
    if (j.remedy.needed <= *j.budget)
        return text + line("  all but a hundredth at either end would be sharp with the sheet %.4g "
                           "mm farther %s\n",
                           std::fabs(j.remedy.shift), j.remedy.shift > 0 ? "back" : "forward");
    text += line(
        "  beyond it details get coarser. Sharp as a whole with the sheet %.4g mm farther %s",
        std::fabs(j.remedy.shift), j.remedy.shift > 0 ? "back" : "forward");
    if (j.remedy.pixel)
        text += line(" and %.0f dpi", std::ceil(mm_per_inch / *j.remedy.pixel));
    return text + line(", or a scene %.3g times as shallow\n", j.remedy.needed / *j.budget);
}

nlohmann::ordered_json scene_depth_json(const std::string& scene, const DepthFrame& depths)
{
    const Judged j = judge(depths);
    const DepthRange& r = j.range;
    const auto or_null = [&](std::optional<double> v) {
        return v && r.surfaces > 0 ? nlohmann::ordered_json(*v) : nlohmann::ordered_json(nullptr);
    };
    return {{"scene", scene},
            {"pixels", r.pixels},
            {"surfaces", r.surfaces},
            {"nearest_mm", or_null(r.nearest)},
            {"low_mm", or_null(r.low)},
            {"median_mm", or_null(r.median)},
            {"high_mm", or_null(r.high)},
            {"farthest_mm", or_null(r.farthest)},
            {"budget_mm", or_null(j.budget)},
            {"before_budget", or_null(j.budget ? std::optional<double>(r.before) : std::nullopt)},
            {"behind_budget", or_null(j.budget ? std::optional<double>(r.behind) : std::nullopt)},
            {"shift_mm", or_null(j.remedy.shift)},
            {"needed_budget_mm", or_null(j.remedy.needed)},
            {"needed_pixel_pitch_mm", or_null(j.remedy.pixel)}};
}

} // namespace integral
