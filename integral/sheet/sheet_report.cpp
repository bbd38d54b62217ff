// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/sheet_report.h"

#include "integral/base/json.h"
#include "integral/frame/names.h"
#include "integral/optics/coverage.h"
#include "integral/optics/visual_pitch.h"
#include "integral/sheet/sampling_forecast.h"
#include "integral/sheet/sheet_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace integral {
namespace {

/// One line of the report.
struct Figure {
    const char* group;
    const char* key; ///< name in JSON
    const char* label;
    std::optional<double> value;
    const char* unit;
    const char* equation;
};

std::optional<double> times(double factor, std::optional<double> value)
{
    if (value)
        *value *= factor;
    return value;
}

/// How many equal parts of a zone are wider than a ghost on either side.
std::optional<double> alone(std::optional<double> ghost, std::optional<double> zone)
{
    if (!ghost || !zone)
        return std::nullopt;
    return std::max(0.0, std::ceil(*zone / (2 * *ghost)) - 1);
}

std::vector<Figure> figures_of(const FrameMetadata& g, const Viewer& viewer)
{
    const LensSheet& s = g.sheet;
    const LensRowGeometry c = counted(g);
    const double d = g.aperture.distance;
    const std::optional<double> none;
    const auto width = c.pixels > 0 ? std::optional<double>(c.pixels * c.pixel) : none;
    const bool limited = std::isfinite(c.aperture);
    const double image = micro_image_width(s, d, c.aperture);
    const double half = c.cell / 2;
    const auto filling = filling_width(s, d, c.cell);
    const auto angle = pixel_angle(s, c.pixel);
    std::optional<WholePicture> whole;
    if (filling && width)
        whole = whole_picture(d, *filling, *width);
    const auto budget = depth_budget(s, c.pixel);
    const char *sheet = "Sheet", *pair = "Two of it back to back", *film = "Film",
               *view = "Viewer and aperture", *depth = "Depth";
    std::vector<Figure> figures = {
        {sheet, "lenses_per_inch", "lenses per inch", mm_per_inch / s.pitch, "", ""},
        {sheet, "surface_radius_mm", "radius of the lens surface", surface_radius(s), "mm",
         "t(n-1)/n"},
        {sheet, "greatest_angle_degrees", "greatest angle to the axis", greatest_angle(s), "deg",
         "(2-1)"},
        {sheet, "viewing_angle_degrees", "viewing angle", times(2, greatest_angle(s)), "deg",
         "2 x (2-1)"},
        {pair, "afocal_half_lost_degrees", "half of the light is in side lobes at",
         half_lost_angle(s), "deg", "2.4.1"},
        {pair, "afocal_all_lost_degrees", "  all of it from", greatest_angle(s), "deg", "(2-1)"},
        {pair, "field_lens_focus_mm", "field lenses against that, focal length",
         field_lens_focus(s), "mm", "figure 2-11"},
        {film, "pixel_pitch_mm", "pixel pitch", c.pixel, "mm", "(4-3)"},
        {film, "pixels_per_lens", "pixels per lens", c.period / c.pixel, "", ""},
        {film, "film_width_mm", "width of the film", width, "mm", ""},
        {film, "lenses_across", "lenses across it", times(1 / c.period, width), "", ""},
        {film, "pixel_angle_degrees", "angle of a pixel", angle, "deg", "(4-4)"},
        {view, "distance_mm", "viewing distance", d, "mm", ""},
        {view, "aperture_width_mm", "capture aperture",
         limited ? std::optional<double>(c.aperture) : none, "mm", ""},
        {view, "filling_aperture_mm", "aperture that fills a lens", filling, "mm", "(3-5), exact"},
        {view, "jump_mm", "  beyond its half the picture jumps", times(0.5, filling), "mm", ""},
        {view, "whole_from_mm", "the whole picture without a jump, from",
         whole ? std::optional<double>(whole->nearest) : none, "mm", ""},
        {view, "whole_to_mm", "  to", whole ? whole->farthest : none, "mm", ""},
        {view, "filling_sine", "  its sine outside, n sin(atan(cell/2t))",
         s.ior * half / std::hypot(half, s.thickness), "", "optics.md 5"},
        {view, "filling_distance_mm", "distance at which the aperture fills",
         limited ? std::optional<double>(filling_distance(s, c.aperture, c.cell)) : none, "mm",
         "(3-5)"},
        {view, "micro_image_width_mm", "micro-image of the aperture",
         std::isfinite(image) ? std::optional<double>(image) : none, "mm", "(3-9)"},
        {view, "pinhole_spread_mm", "  by the simple pinhole",
         limited ? std::optional<double>(pinhole_spread(s, d, c.aperture)) : none, "mm", "(3-8)"},
        {view, "fill", "fill, micro-image / lens",
         std::isfinite(image) ? std::optional<double>(image / c.cell) : none, "", ""},
        {view, "pixel_spread_mm", "a pixel's spread at the viewer",
         angle ? std::optional<double>(pixel_spread(*angle, d)) : none, "mm", "(4-5)"},
        {view, "pixels_seen", "pixels of a lens that an eye sees",
         pixels_seen(s, c.pixel, viewer.pupil, d), "", "(4-1)"},
        {view, "ghost_mm", "a flip's ghost on either side of a change", viewer.ghost, "mm", ""},
        {view, "pictures_seen_alone", "  pictures that are seen alone, at most",
         alone(viewer.ghost, limited ? std::optional(c.aperture) : filling), "", ""},
        {view, "visual_pitch_mm", "pitch of the eye's images on the film",
         visual_pitch(c.period, s, d), "mm", ""},
        {view, "moire_pitch_mm", "moire pitch, lenses against pixels",
         moire_pitch(c.period, s, c.pixel, d), "mm", "5.3"},
        {view, "discrete_view_distance_mm", "one pixel of all lenses is seen from",
         width ? std::optional<double>(discrete_view_distance(s, c.pixel, *width)) : none, "mm",
         "(5-1)"},
        {depth, "depth_budget_mm", "depth budget, either side of the sheet", budget, "mm",
         "(4-6) = lenses"},
        {depth, "lens_resolution_lp_per_mm", "resolution of the lenses themselves",
         observer_resolution(s.pitch, d, 0), "lp/mm", "(4-7) at 0"},
    };
    if (const auto macro = viewer.macro_lens) {
        const char* tiers = "Two tiers: macro-lenses before two of it back to back";
        figures.push_back({tiers, "macro_lens_depth_mm", "depth of the image of 300 mm to infinity",
                           macro_lens_depth(*macro, nearest_in_two_tiers), "mm", "2.4.2"});
        figures.push_back(
            {tiers, "macro_lens_nearest_mm", "the depth budgets hold infinity to",
             budget ? std::optional<double>(macro_lens_nearest(*macro, 2 * *budget)) : none, "mm",
             "(4-6)"});
    }
    return figures;
}

/// Figures at one depth: mm, line pairs per mm.
struct DepthFigures {
    double depth;
    std::optional<double> resolution, spread, observer_front; ///< (4-6), (4-5), (4-7)
    double observer_back;
};

std::vector<DepthFigures> depths_of(const FrameMetadata& g, const Viewer& viewer)
{
    const LensRowGeometry c = counted(g);
    const auto angle = pixel_angle(g.sheet, c.pixel);
    const double d = g.aperture.distance;
    std::vector<DepthFigures> rows;
    for (const double depth : viewer.depths) {
        DepthFigures row;
        row.depth = depth;
        row.resolution = depth_resolution(g.sheet, c.pixel, depth);
        if (angle)
            row.spread = pixel_spread(*angle, depth);
        if (depth < d)
            row.observer_front = observer_resolution(g.sheet.pitch, d, depth);
        row.observer_back = observer_resolution(g.sheet.pitch, d, -depth);
        rows.push_back(row);
    }
    return rows;
}

/// The camera of a geometry with the default lens model. A film without a size gets a size that
/// covers some lenses.
IntegralCamera camera_of(const FrameMetadata& g, LensMapping mapping)
{
    Film film = g.film;
    film.subpixels = Subpixels::none;
    if (film.width == 0) {
        const Vec2 cell = cell_extent(g.sheet);
        film.width = film.height = static_cast<int>(
            std::min(1e6, 1 + 9 * std::max(cell.x, cell.y) /
                                  std::min(film.pixel_pitch.x, film.pixel_pitch.y)));
    }
    return {SheetOptics(g.sheet, g.aperture), film, {}, mapping, {}, 1, 1, false};
}

/// Predicted cost of a render, and its predicted difference from the reference.
struct Sampling {
    std::optional<double> imaged, imaged_by_closest; ///< share of the film that gets rays
    std::vector<SamplingForecast> settings;

    std::optional<double> rays(const FrameMetadata& g, const SamplingForecast& setting) const
    {
        return times(double(g.film.width) * g.film.height * setting.rays(), imaged);
    }
};

Sampling sampling_of(const FrameMetadata& g, const Viewer& viewer)
{
    constexpr int samples = 20000;
    Sampling sampling;
    const IntegralCamera camera = camera_of(g, LensMapping::automatic);
    if (g.film.width > 0) {
        sampling.imaged = coverage(camera, samples).imaged;
        sampling.imaged_by_closest = coverage(camera_of(g, LensMapping::closest), samples).imaged;
    }
    sampling.settings = sampling_ladder();
    forecast_errors(camera, viewer.depths, viewer.detail, sampling.settings);
    return sampling;
}

/// The PSNR in dB, with full scale from black to white. Empty for no error.
std::optional<double> psnr(double rms)
{
    if (!(rms > 0))
        return std::nullopt;
    return -20 * std::log10(rms);
}

std::string shown(std::optional<double> value)
{
    if (!value)
        return "-";
    char text[40];
    std::snprintf(text, sizeof text, "%.5g", *value);
    return text;
}

std::string line(const char* format, ...) __attribute__((format(printf, 1, 2)));

std::string line(const char* format, ...)
{
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

Json json_of(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

std::string sampling_text(const FrameMetadata& g, const Viewer& viewer)
{
    const Sampling sampling = sampling_of(g, viewer);
    std::string text = "\nSampling\n";
    if (sampling.imaged)
        text += line("  film imaged: %.1f%% by lens_mapping auto, %.1f%% by closest\n",
                     100 * *sampling.imaged, 100 * *sampling.imaged_by_closest);
    text += line(
        "  RMS error and PSNR (dB) to expect of black-white edges %s mm apart, linear light:\n",
        shown(viewer.detail).c_str());
    const auto row = [&](const char* label, auto figure) {
        text += line("  %-13s", label);
        for (const SamplingForecast& setting : sampling.settings)
            text += line("%13s", std::string(figure(setting)).c_str());
        text += "\n";
    };
    row("beam_samples", [](const auto& s) { return std::to_string(s.beam_samples); });
    row("pixel_samples", [](const auto& s) { return std::to_string(s.pixel_samples); });
    row("rays a pixel", [](const auto& s) { return std::to_string(s.rays()); });
    if (sampling.imaged)
        row("million rays", [&](const auto& s) { return shown(times(1e-6, sampling.rays(g, s))); });
    for (std::size_t k = 0; k < viewer.depths.size(); ++k)
        row(line("%s mm deep", shown(viewer.depths[k]).c_str()).c_str(), [&](const auto& s) {
            return s.rms.empty() || !psnr(s.rms[k]) ? "-"
                                                    : line("%.3f %5.1f", s.rms[k], *psnr(s.rms[k]));
        });
    return text;
}

Json sampling_json(const FrameMetadata& g, const Viewer& viewer)
{
    const Sampling sampling = sampling_of(g, viewer);
    Json json = {{"detail_mm", viewer.detail},
                 {"imaged", json_of(sampling.imaged)},
                 {"imaged_by_closest", json_of(sampling.imaged_by_closest)}};
    for (const SamplingForecast& setting : sampling.settings) {
        Json entry = {{"beam_samples", setting.beam_samples},
                      {"pixel_samples", setting.pixel_samples},
                      {"rays_per_pixel", setting.rays()},
                      {"rays", json_of(sampling.rays(g, setting))}};
        for (std::size_t k = 0; k < setting.rms.size(); ++k)
            entry["errors"].push_back({{"depth_mm", viewer.depths[k]},
                                       {"rms", setting.rms[k]},
                                       {"psnr_db", json_of(psnr(setting.rms[k]))}});
        json["settings"].push_back(entry);
    }
    return json;
}

} // namespace

LensRowGeometry counted(const FrameMetadata& g)
{
    const Vec2 cell = cell_extent(g.sheet);
    if (lenses_lie_across(g.sheet))
        return {cell.y, cell.y, g.film.pixel_pitch.y, g.aperture.height, g.film.height};
    const double period = g.sheet.arrangement == Arrangement::lenticular ? cell.x : g.sheet.pitch;
    return {period, cell.x, g.film.pixel_pitch.x, g.aperture.width, g.film.width};
}

std::optional<double> seen_budget(const FrameMetadata& g)
{
    const auto budget = depth_budget(g.sheet, counted(g).pixel);
    return budget && g.projection ? std::optional(*budget * g.projection->image().depth) : budget;
}

std::string sheet_report_text(const FrameMetadata& g, const Viewer& viewer)
{
    std::string text = line("%s sheet, pitch %g mm, thickness %g mm, ior %g",
                            name_of(g.sheet.arrangement), g.sheet.pitch, g.sheet.thickness,
                            g.sheet.ior);
    if (g.sheet.slant != 0)
        text += line(", slant %g degrees", g.sheet.slant);
    text += line("; film %g x %g dpi", mm_per_inch / g.film.pixel_pitch.x,
                 mm_per_inch / g.film.pixel_pitch.y);
    if (g.film.width > 0)
        text += line(", %d x %d pixels", g.film.width, g.film.height);
    text += "\n";

    const char* group = "";
    for (const Figure& f : figures_of(g, viewer)) {
        if (std::string(group) != f.group)
            text += line("\n%s\n", group = f.group);
        text += line("  %-40s%12s %-5s  %s", f.label, shown(f.value).c_str(), f.value ? f.unit : "",
                     f.equation);
        text.erase(text.find_last_not_of(' ') + 1); // no blanks at the line's end
        text += "\n";
    }

    text += "\n  depth   resolution  pixel's spread  observer's resolution, lp/mm (4-7)\n"
            "     mm  lp/mm (4-6)        mm (4-5)     before the sheet    behind it\n";
    for (const DepthFigures& row : depths_of(g, viewer))
        text += line("%7s %12s %15s %20s %12s\n", shown(row.depth).c_str(),
                     shown(row.resolution).c_str(), shown(row.spread).c_str(),
                     shown(row.observer_front).c_str(), shown(row.observer_back).c_str());
    return text + sampling_text(g, viewer);
}

Json sheet_report_json(const FrameMetadata& g, const Viewer& viewer)
{
    Json json = parse_json(to_json(g));
    for (const Figure& f : figures_of(g, viewer))
        json["figures"][f.key] = json_of(f.value);
    for (const DepthFigures& row : depths_of(g, viewer))
        json["depths"].push_back({{"depth_mm", row.depth},
                                  {"resolution_lp_per_mm", json_of(row.resolution)},
                                  {"pixel_spread_mm", json_of(row.spread)},
                                  {"observer_front_lp_per_mm", json_of(row.observer_front)},
                                  {"observer_back_lp_per_mm", row.observer_back}});
    json["sampling"] = sampling_json(g, viewer);
    return json;
}

} // namespace integral
