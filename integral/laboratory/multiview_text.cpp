// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/multiview_text.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/base/text_columns.h"

namespace integral {
namespace {

std::string padded(const std::string& text, std::size_t width)
{
    return text + std::string(text.size() < width ? width - text.size() : 0, ' ');
}

std::string mm(std::optional<double> value)
{
    return value ? with_decimals(*value, 2) + " mm" : "-";
}

std::string percent(std::optional<double> part)
{
    return part ? with_decimals(100 * *part, 1) + "%" : "-";
}

std::string line(const std::string& label, const std::string& value)
{
    return "  " + padded(label, 55) + value + "\n";
}

Json json_of(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

std::string seen_line(const SeenFrame& seen)
{
    std::optional<double> crosstalk, at_once, step;
    if (seen.switching) {
        crosstalk = seen.switching->crosstalk;
        at_once = seen.switching->at_once;
        step = seen.switching->step;
    }
    const auto figure = [](double value) { return right_aligned(with_decimals(value, 4), 10); };
    return padded("  " + seen.name, 25) + right_aligned(percent(crosstalk), 10) +
           right_aligned(percent(at_once), 11) + right_aligned(mm(step), 12) +
           figure(seen.greatest_jump) + figure(seen.mean_jump) + figure(seen.mean_error) +
           figure(seen.worst_error) + "\n";
}

} // namespace

std::string multiview_text(const MultiviewResult& result)
{
    const ViewFigures& f = result.figures;
    std::string text = std::to_string(result.views) + " views for eyes " +
                       with_digits(f.distance, 5) + " mm from the sheet, in a zone " + mm(f.zone) +
                       " wide\n\nBy closed forms\n";
    text += line("flipping period: an eye's way from view to view", mm(f.step)) +
            line("  from pixel to pixel behind a lens", mm(f.pixel_step)) +
            line("pixels to a lens", with_digits(f.pixels_per_lens, 5)) +
            line("views are a lens apart, in front of the sheet", mm(f.depth.front)) +
            line("  behind it", mm(f.depth.back)) +
            line("crosstalk, mean over a view's part of the zone", percent(f.crosstalk)) +
            line("keystone: outer converging cameras differ at a corner",
                 mm(std::fabs(f.keystone.x)) + " across, " + mm(std::fabs(f.keystone.y)) + " up") +
            line("moire, lenses against pixels", mm(f.moire)) +
            line("  found in replay of a flat field", mm(result.moire)) +
            line("interleaved to infinity, one view is seen from", mm(f.one_view_from));
    text += "\nAs " + std::to_string(result.eyes) + " eyes across the zone's middle see it\n" +
            std::string(25, ' ') +
            " crosstalk    changes     view to      jump (RMSE)     "
            "error (RMSE)\n" +
            std::string(25, ' ') +
            "              at once        view  greatest      mean      mean     worst\n";
    for (const SeenFrame& seen : result.seen)
        text += seen_line(seen);
    return text;
}

Json multiview_json(const MultiviewResult& result)
{
    const ViewFigures& f = result.figures;
    Json json = {{"views", result.views},
                 {"eyes", result.eyes},
                 {"distance_mm", f.distance},
                 {"zone_mm", f.zone},
                 {"flipping_period_mm", f.step},
                 {"pixel_step_mm", f.pixel_step},
                 {"pixels_per_lens", f.pixels_per_lens},
                 {"lens_apart_front_mm", f.depth.front},
                 {"lens_apart_behind_mm", json_of(f.depth.back)},
                 {"crosstalk", json_of(f.crosstalk)},
                 {"keystone_mm", {f.keystone.x, f.keystone.y}},
                 {"moire_pitch_mm", json_of(f.moire)},
                 {"moire_pitch_found_mm", json_of(result.moire)},
                 {"one_view_from_mm", f.one_view_from}};
    for (const SeenFrame& seen : result.seen) {
        Json entry = {{"name", seen.name}};
        if (seen.switching) {
            entry["crosstalk"] = seen.switching->crosstalk;
            entry["changes_at_once"] = seen.switching->at_once;
            entry["flipping_period_found_mm"] = seen.switching->step;
        }
        entry["greatest_jump"] = seen.greatest_jump;
        entry["mean_jump"] = seen.mean_jump;
        entry["mean_error"] = seen.mean_error;
        entry["worst_error"] = seen.worst_error;
        json["seen"].push_back(entry);
    }
    return json;
}

} // namespace integral
