// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/placement_settings.h"

#include "integral/frame/geometry_json.h"
#include "integral/optics/film.h"
#include "integral/sheet/camera_words.h"
#include "integral/sheet/depth_advice.h"
#include "integral/sheet/known_sheets.h"
#include "integral/sheet/sheet_figures.h"
#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace integral {
namespace {

constexpr double least_length = 1e-6, largest_length = 1e9;
constexpr double largest_parallax = 100;

std::optional<double> optional_number(const JsonObject& object, const char* field, double least,
                                      double greatest)
{
    if (!object.has(field) || object.at(field).is_null())
        return std::nullopt;
    return number_at(object, field, least, greatest);
}

int pixels_of(double mm, double pitch)
{
    const double pixels = std::round(mm / pitch);
    if (!(pixels >= 1 && pixels <= largest_side))
        throw_field_error("print_mm", "gives " + std::to_string(pixels) + " pixels; from 1 to " +
                                          std::to_string(largest_side) + " are possible");
    return int(pixels);
}

/// The frame of a print without its placement.
FrameMetadata print_of(const PlacementSettings& settings)
{
    FrameMetadata frame;
    frame.sheet = settings.sheet;
    const double pitch = mm_per_inch / settings.dpi;
    frame.film = {
        pixels_of(settings.print.x, pitch), pixels_of(settings.print.y, pitch), {pitch, pitch}};
    check_ranges(frame.sheet, frame.film);
    const auto aperture = filling_aperture(frame.sheet, settings.viewing_distance);
    if (!aperture)
        throw_field_error("sheet", "has lenses that no aperture, however wide, fills; take a "
                                   "thicker sheet");
    frame.aperture = *aperture;
    return frame;
}

/// The placement of a sheet at another distance from the same eye. `scale`: the new scene units per
/// mm divided by the old ones.
Placement moved_to(const Placement& old, double sheet_distance, double scale)
{
    Placement moved = old;
    const Vec3 forwards = (1 / old.units_per_mm) * old.z; // a scene unit into the scene
    moved.origin = old.origin + (sheet_distance - old.sheet_distance) * forwards;
    moved.x = scale * old.x;
    moved.y = scale * old.y;
    moved.z = scale * old.z;
    moved.units_per_mm = scale * old.units_per_mm;
    moved.sheet_distance = sheet_distance;
    return moved;
}

/// Fields whose value is infinite become null.
Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// The distance (scene units from the scene's eye plane) of surfaces that are seen at `depth`, mm
/// behind the sheet; infinite if all of the scene is seen nearer.
double distance_seen_at(const FrameMetadata& frame, double depth)
{
    if (depth <= -viewer_distance(frame))
        return 0;
    const auto z = preimage_depth(relief_of(frame), depth);
    return z ? (scene_distance(frame) + *z) * frame.placement->units_per_mm : HUGE_VAL;
}

Json json_of(const DepthShares& shares)
{
    return {{"sharp", shares.sharp}, {"soft", shares.soft}, {"beyond", shares.beyond}};
}

} // namespace

PlacementSettings first_settings()
{
    PlacementSettings settings;
    settings.sheet = *sheet_of_lpi(60);
    return settings;
}

Vec2 print_of_aspect(double aspect)
{
    constexpr double longer_side = 150;
    return aspect >= 1 ? Vec2{longer_side, longer_side / aspect}
                       : Vec2{longer_side * aspect, longer_side};
}

PlacementSettings settings_from_json(const std::string& text)
{
    Json document;
    try {
        document = parse_json(text);
    } catch (const JsonError& error) {
        throw std::invalid_argument(error.what());
    }
    if (!document.is_object())
        throw std::invalid_argument("the settings must be an object");
    const JsonObject object{document, ""};
    throw_on_unknown_fields(object, {"panel", "sheet", "dpi", "print_mm", "viewing_distance_mm",
                                     "sheet_distance", "parallax", "budgets"});
    PlacementSettings settings;
    if (object.has("panel") && !object.at("panel").is_null())
        settings.panel = panel_from_json(object.at("panel").dump());
    if (settings.panel && std::any_of(settings.panel->name.begin(), settings.panel->name.end(),
                                      [](unsigned char c) { return std::iscntrl(c); }))
        throw_field_error("panel", "has a name with line ends or other control characters");
    settings.sheet = sheet_from(object_at(object, "sheet"));
    settings.dpi = number_at(object, "dpi", 1, 1e6);
    settings.print = vec2_at(object, "print_mm", least_length, largest_length);
    settings.viewing_distance = number_at(object, "viewing_distance_mm", least_distance,
                                          largest_distance);
    settings.sheet_distance = optional_number(object, "sheet_distance", 1e-9, 1e9);
    settings.parallax = optional_number(object, "parallax", 0, largest_parallax);
    settings.budgets = number_at(object, "budgets", 1e-3, 1e3);
    return settings;
}

Json json_of(const PlacementSettings& settings)
{
    const auto number_or_null = [](const std::optional<double>& number) {
        return number ? Json(*number) : Json();
    };
    return {{"panel", settings.panel ? parse_json(to_json(*settings.panel)) : Json()},
            {"sheet", json_of(settings.sheet)},
            {"dpi", settings.dpi},
            {"print_mm", list(settings.print)},
            {"viewing_distance_mm", settings.viewing_distance},
            {"sheet_distance", number_or_null(settings.sheet_distance)},
            {"parallax", number_or_null(settings.parallax)},
            {"budgets", settings.budgets}};
}

FrameMetadata frame_of_settings(const PlacementSettings& settings, const DepthFrame* probe)
{
    FrameMetadata frame = settings.panel ? frame_geometry(*settings.panel) : print_of(settings);
    if (!probe || !probe->metadata.placement)
        return frame;

    const FrameMetadata& scene = probe->metadata;
    const double width = size_of(frame.film).x,
                 eye_distance = scene_distance(scene) * width / size_of(scene.film).x;
    SceneFit fit{settings.sheet_distance.value_or(scene.placement->sheet_distance),
                 settings.parallax.value_or(1)};
    const auto ends = depth_ends({probe->eye_distances.begin(), probe->eye_distances.end()});
    const auto budget = seen_budget(frame);
    if (!(settings.sheet_distance && settings.parallax) && ends && budget)
        fit = fit_to_budget(*ends, {settings.budgets * *budget / frame.aperture.distance,
                                    settings.sheet_distance, settings.parallax});
    frame.parallax = Parallax{fit.parallax, eye_distance};
    frame.placement = moved_to(*scene.placement, fit.sheet_distance,
                               fit.sheet_distance / eye_distance / scene.placement->units_per_mm);
    return frame;
}

std::string words_of_settings(const PlacementSettings& settings, const FrameMetadata& frame)
{
    const auto number = [](double value) { return Json(value).dump(); };
    std::string words = camera_words(frame);
    if (!settings.panel)
        words += " print_size <" + number(settings.print.x) + ", " + number(settings.print.y) + ">";
    if (frame.placement)
        words += " sheet_distance " + number(frame.placement->sheet_distance) + " parallax " +
                 number(frame.parallax->factor);
    return words;
}

Json settings_figures(const PlacementSettings& settings, const DepthFrame* probe)
{
    const FrameMetadata frame = frame_of_settings(settings, probe);
    const LensRowGeometry row = counted(frame);
    const auto budget = seen_budget(frame);
    Json figures = {{"geometry", parse_json(to_json(frame))},
                    {"budget_mm", budget ? Json(*budget) : Json()},
                    {"pixels_per_lens", row.period / row.pixel},
                    {"lenses", row.pixels * row.pixel / row.period},
                    {"zone_mm", list(viewing_zone(frame.sheet, frame.aperture))}};
    if (!frame.placement)
        return figures;
    figures["placement"] = {{"sheet_distance", frame.placement->sheet_distance},
                            {"parallax", frame.parallax->factor},
                            {"scene_distance_mm", frame.parallax->scene_distance}};
    if (!budget)
        return figures;
    Json bands = Json::array();
    for (const double budgets : {1.0, soft_budgets})
        bands.push_back({finite_or_null(distance_seen_at(frame, -budgets * *budget)),
                         finite_or_null(distance_seen_at(frame, budgets * *budget))});
    figures["bands"] = bands;
    const DepthAdvice advice = depth_advice({{}, {}, frame, probe->eye_distances}, *budget);
    figures["shares"] = json_of(advice.now);
    figures["fits"] = Json::array();
    for (const FitAdvice& fit : advice.fits)
        figures["fits"].push_back({{"budgets", fit.budgets},
                                   {"sheet_distance", fit.fit.sheet_distance},
                                   {"parallax", fit.fit.parallax},
                                   {"shares", json_of(fit.shares)}});
    return figures;
}

} // namespace integral
