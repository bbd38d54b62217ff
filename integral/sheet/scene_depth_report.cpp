// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/scene_depth_report.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/base/text_columns.h"
#include "integral/sheet/depth_advice.h"
#include "integral/sheet/sheet_figures.h"
#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {
namespace {

constexpr double mm_per_m = 1000;
constexpr double countless = 10000; // mm: depths beyond are "more than 10 m"

struct Judged {
    DepthFrame depths;            ///< as the scene's eye sees them
    std::optional<double> budget; ///< mm
    DepthRange range;
    std::optional<DepthAdvice> advice; ///< none without a budget or without a surface
};

Judged judge(const DepthFrame& depths)
{
    Judged j{as_scene_eye_sees(depths), seen_budget(depths.metadata), {}, {}};
    j.range = depth_range(j.depths, j.budget);
    if (j.budget && j.range.surfaces > 0)
        j.advice = depth_advice(j.depths, *j.budget);
    return j;
}

std::string percent(double part) { return with_decimals(100 * part, 1) + "%"; }

/// "12 mm before", "1.25 m behind", "more than 10 m behind".
std::string place_text(double depth)
{
    const std::string side = depth < 0 ? " before" : " behind";
    if (std::fabs(depth) > countless)
        return "more than 10 m" + side;
    if (std::fabs(depth) >= mm_per_m)
        return with_digits(std::fabs(depth) / mm_per_m, 3) + " m" + side;
    return with_digits(std::fabs(depth), 3) + " mm" + side;
}

std::string shares_text(const DepthShares& shares)
{
    return percent(shares.sharp) + " sharp, " + percent(shares.soft) + " soft, " +
           percent(shares.beyond) + " beyond";
}

/// The camera's words for a fit. If the scene gives units_per_mm, a new sheet_distance alone would
/// also move the viewer, so viewing_distance is added.
std::string words_of(const SceneFit& fit, const FrameMetadata& metadata)
{
    return "sheet_distance " + with_digits(fit.sheet_distance, 6) + " parallax " +
           with_digits(fit.parallax, 6) +
           (metadata.placement->scale_is_given
                ? " viewing_distance " + with_digits(viewer_distance(metadata), 6)
                : "");
}

/// Describes pixels without a surface, and surfaces that a parallax over 1 puts beyond the viewer's
/// infinity.
std::string backdrop_text(const Judged& j)
{
    const std::vector<float>& distances = j.depths.eye_distances;
    const auto part = [&](double number) { return percent(number / double(j.range.pixels)); };
    const double infinite = double(j.range.pixels - j.range.surfaces),
                 open = distances.empty()
                            ? infinite
                            : double(std::count_if(distances.begin(), distances.end(),
                                                   [](float d) { return std::isinf(d); }));
    if (infinite == 0)
        return "closed: every pixel shows a surface";
    std::string text;
    if (open > 0) {
        const SceneFit fit = fit_of(j.depths.metadata);
        text = "open: " + part(open) + " of the picture show no surface, ";
        const double seen = viewer_distance(j.depths.metadata) *
                            seen_depth(fit, std::numeric_limits<double>::infinity());
        text += std::isinf(seen) ? "as if it were infinitely far"
                                 : "seen " + place_text(seen) + " the sheet";
        if (seen > soft_budgets * *j.budget)
            text +=
                "; that is never sharp, so keep it plain, or close it by a wall behind the scene";
    }
    if (infinite > open)
        text += std::string(open > 0 ? "; " : "") + part(infinite - open) +
                " of the picture are beyond the viewer's infinity, where no eyes can see them as "
                "one; a parallax of at most 1 brings them back";
    return text;
}

/// The resolution at a depth, as text: (4-6), but at most the lenses' own resolution.
std::string resolution_at(const DepthFrame& depths, double depth)
{
    const auto sheet_only = observer_resolution(depths.metadata.sheet.pitch,
                                                depths.metadata.aperture.distance, 0);
    const auto pixels = depth_resolution(depths.metadata.sheet, counted(depths.metadata).pixel,
                                         std::max(1e-9, std::fabs(depth)));
    return pixels ? with_digits(std::min(*pixels, sheet_only), 4) : std::string("-");
}

} // namespace

std::string scene_verdict_text(const std::string& scene, const DepthFrame& depths)
{
    const Judged j = judge(depths);
    std::string text = "Verdict on " + scene + "\n";
    if (j.range.surfaces == 0)
        return text + "  no pixel shows a surface: there is nothing whose depth could be judged\n";
    if (!j.advice)
        return text +
               "  the lenses are too wide for the sheet's thickness to have a depth budget\n";
    const DepthShares& now = j.advice->now;
    for (const FitAdvice& fit : j.advice->fits)
        text += "  Fit " + with_digits(fit.budgets, 2) + ":    " + words_of(fit.fit, depths.metadata) + ": " +
                shares_text(fit.shares) + "  (Integral_Fit=" + with_digits(fit.budgets, 2) + ")\n";
    text += "  As it is: " + shares_text(now) + "; sharp: up to " + with_digits(*j.budget, 3) +
            " mm before and behind the sheet, soft: up to " +
            with_digits(soft_budgets * *j.budget, 3) + " mm\n";
    text += "  Depth:    nine tenths lie from " + place_text(j.range.twentieth) + " to " +
            place_text(j.range.last_twentieth) + " the sheet\n";
    if (j.advice->dpi)
        text += "  Film:     film { dpi " + with_digits(j.advice->dpi->value, 6) +
                " }: " + percent(j.advice->dpi->sharp) + " sharp\n";
    text += "  Backdrop: " + backdrop_text(j) + "\n";
    return text;
}

std::string scene_depth_text(const DepthFrame& depths)
{
    const Judged j = judge(depths);
    const DepthRange& r = j.range;
    if (r.surfaces == 0)
        return "";
    std::string text = "\nDepths of the scene\n"
                       "                mm behind  lp/mm there\n"
                       "                the sheet  (at most the lenses')\n";
    const auto row = [&](const char* label, double depth) {
        std::string line = std::string("  ") + label;
        line.resize(14, ' ');
        const std::string place = depth > countless    ? "> 10 m"
                                  : depth < -countless ? "< -10 m"
                                                       : with_digits(depth, 4);
        text += line + right_aligned(place, 11) + right_aligned(resolution_at(depths, depth), 13) +
                "\n";
    };
    row("nearest", r.nearest);
    row("1 in 20", r.twentieth);
    row("middle", r.median);
    row("19 in 20", r.last_twentieth);
    row("farthest", r.farthest);
    if (j.budget)
        text += "  within the budget " + percent(1 - r.before - r.behind) + ", before it " +
                percent(r.before) + ", behind it " + percent(r.behind) + "\n";
    return text;
}

Json scene_depth_json(const std::string& scene, const DepthFrame& depths)
{
    const Judged j = judge(depths);
    const DepthRange& r = j.range;
    const auto or_null = [&](std::optional<double> v) {
        return v && r.surfaces > 0 ? Json(*v) : Json(nullptr);
    };
    Json json = {{"scene", scene},
                 {"pixels", r.pixels},
                 {"surfaces", r.surfaces},
                 {"nearest_mm", or_null(r.nearest)},
                 {"twentieth_mm", or_null(r.twentieth)},
                 {"median_mm", or_null(r.median)},
                 {"last_twentieth_mm", or_null(r.last_twentieth)},
                 {"farthest_mm", or_null(r.farthest)},
                 {"budget_mm", or_null(j.budget)}};
    if (!j.advice)
        return json;
    const DepthAdvice& a = *j.advice;
    json["sharp"] = a.now.sharp;
    json["soft"] = a.now.soft;
    json["beyond"] = a.now.beyond;
    json["before_budget"] = r.before;
    json["behind_budget"] = r.behind;
    for (const FitAdvice& fit : a.fits)
        json["fits"].push_back({{"budgets", fit.budgets},
                                {"sheet_distance", fit.fit.sheet_distance},
                                {"parallax", fit.fit.parallax},
                                {"sharp", fit.shares.sharp},
                                {"soft", fit.shares.soft},
                                {"beyond", fit.shares.beyond}});
    json["dpi"] = a.dpi ? Json({{"value", a.dpi->value}, {"sharp", a.dpi->sharp}}) : Json(nullptr);
    return json;
}

} // namespace integral
