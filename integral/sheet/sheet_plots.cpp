// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/sheet_plots.h"

#include "integral/frame/names.h"
#include "integral/optics/lens_surface.h"
#include "integral/sampling/lens_profile.h"
#include "integral/sheet/known_sheets.h"
#include "integral/sheet/sheet_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace integral {
namespace {

using Style = PlotSeries::Style;
constexpr double gap = std::numeric_limits<double>::quiet_NaN(); // a point that breaks a line

std::string written(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.5g", value);
    return text;
}

std::string description(const LensSheet& sheet)
{
    return std::string(name_of(sheet.arrangement)) + ", pitch " + written(sheet.pitch) +
           " mm, thickness " + written(sheet.thickness) + " mm, ior " + written(sheet.ior);
}

PlotSeries series(const std::string& label, Style style)
{
    PlotSeries s;
    s.label = label;
    s.style = style;
    return s;
}

void add(PlotSeries& s, double x, std::optional<double> y)
{
    s.x.push_back(x);
    s.y.push_back(y.value_or(gap));
}

/// A line across the plot at the height y; with both_sides another one at -y.
PlotSeries level(const std::string& label, double from, double to, double y,
                 bool both_sides = false)
{
    PlotSeries s = series(label, Style::dashed);
    s.x = {from, to};
    s.y = {y, y};
    if (both_sides) {
        s.x.insert(s.x.end(), {gap, from, to});
        s.y.insert(s.y.end(), {gap, -y, -y});
    }
    return s;
}

/// Number of rays across a lens for a smooth curve.
int points_across(const LensSheet& sheet)
{
    return sheet.arrangement == Arrangement::lenticular ? 1000 : 100;
}

void demand_surface(const LensSheet& sheet, const std::string& kind)
{
    if (has_surface(sheet))
        return;
    throw std::invalid_argument(
        "--plot " + kind + ": a spherical lens of radius " + written(surface_radius(sheet)) +
        " mm, t(n-1)/n, is not as wide as the sheet's; a thicker sheet or a smaller "
        "pitch is needed");
}

Plot spread_plot(const FrameMetadata& g)
{
    const LensSheet& sheet = g.sheet;
    demand_surface(sheet, "spread");
    const LensRowGeometry c = counted(g);
    if (!(c.aperture > 0 && std::isfinite(c.aperture)))
        throw std::invalid_argument(
            "--plot spread: the capture aperture has no width; give --aperture W");
    const double nearest = 0.5 * g.aperture.distance, farthest = 4 * g.aperture.distance;

    Plot plot;
    plot.title = "Micro-image width against distance (figure 3-26)";
    plot.subtitle = description(sheet) + "; aperture " + written(c.aperture) + " mm wide";
    plot.x.label = "distance of the aperture (mm)";
    plot.y.label = "width of its micro-image (mm)";
    plot.y.low = 0;
    PlotSeries pinhole = series("pinhole (3-8)", Style::line);
    PlotSeries extended = series("extended pinhole (3-9)", Style::line);
    PlotSeries full = series("real lens, at half intensity (bars: at 9/10 and 1/10)",
                             Style::points);
    constexpr int steps = 140, measured_every = 7;
    for (int i = 0; i <= steps; ++i) {
        const double distance = nearest + (farthest - nearest) * i / steps;
        add(pinhole, distance, pinhole_spread(sheet, distance, c.aperture));
        add(extended, distance, micro_image_width(sheet, distance, c.aperture));
        if (i % measured_every != 0)
            continue;
        if (const auto width = full_image_width(sheet, distance, c.aperture,
                                                points_across(sheet))) {
            add(full, distance, width->at_half);
            full.low.push_back(width->at_least);
            full.high.push_back(width->at_most);
        }
    }
    plot.series = {pinhole, extended, full, level("one lens", nearest, farthest, c.period)};
    return plot;
}

Plot lens_plot(const FrameMetadata& g)
{
    const LensSheet& sheet = g.sheet;
    demand_surface(sheet, "lens");
    const double margin = 0.5 * sheet.pitch;
    Plot plot;
    plot.title = "A real lens against the extended pinhole, axis to margin";
    plot.subtitle = description(sheet);
    plot.x.label = "film point's distance from the lens's axis (mm)";
    plot.y.label = "direction less the extended pinhole's (degrees)";
    plot.x.low = 0;
    plot.x.high = margin;
    PlotSeries mean = series("mean of the lens's beam", Style::line);
    PlotSeries spread = series("root mean square about it", Style::none);
    PlotSeries all = series("98% of its rays", Style::none);
    spread.band = all.band = true;
    mean.colour = spread.colour = 0;
    all.colour = 6;
    constexpr int steps = 60;
    for (int i = 0; i <= steps; ++i) {
        const auto beam = full_beam_direction(sheet, margin * i / steps, points_across(sheet));
        if (!beam)
            continue;
        add(mean, beam->film, beam->mean);
        spread.low.push_back(beam->mean - beam->spread);
        spread.high.push_back(beam->mean + beam->spread);
        all.low.push_back(beam->lower);
        all.high.push_back(beam->upper);
    }
    spread.x = all.x = mean.x;
    spread.y = all.y = mean.y;
    plot.series = {mean, spread, all};
    if (const auto angle = pixel_angle(sheet, counted(g).pixel)) {
        plot.series.push_back(level("half a pixel (4-4)", 0, margin, 0.5 * *angle, true));
        plot.series.back().colour = 1;
    }
    return plot;
}

Plot sheets_plot()
{
    Plot plot;
    plot.title = "Real lenses against the extended pinhole: the thesis's sheets";
    plot.subtitle =
        "root mean square of the directions of a film point's rays less the extended pinhole's";
    plot.x.label = "film point's place in its lens, from axis (0) to margin (1)";
    plot.y.label = "direction error (degrees)";
    plot.x.low = 0;
    plot.x.high = 1;
    plot.y.logarithmic = true;
    for (const LensSheet& sheet : thesis_sheets()) {
        PlotSeries errors = series(description(sheet), Style::line_and_points);
        constexpr int steps = 20;
        for (int i = 0; i <= steps; ++i)
            if (const auto beam = full_beam_direction(sheet, 0.5 * sheet.pitch * i / steps,
                                                      points_across(sheet)))
                add(errors, double(i) / steps, beam->error());
        plot.series.push_back(errors);
    }
    return plot;
}

Plot resolution_plot(const FrameMetadata& g, const Viewer& viewer)
{
    const LensSheet& sheet = g.sheet;
    const double pixel = counted(g).pixel, d = g.aperture.distance;
    const auto budget = depth_budget(sheet, pixel);
    if (!budget)
        throw std::invalid_argument(
            "--plot resolution: (4-6) has no value for lenses that wide on a sheet that thin");
    const double deepest = *std::max_element(viewer.depths.begin(), viewer.depths.end());
    Plot plot;
    plot.title = "Resolution against depth (figures 4-12 and 4-15)";
    plot.subtitle = description(sheet) + "; " + written(mm_per_inch / pixel) + " dpi, seen from " +
                    written(d) + " mm; depth budget " + written(*budget) + " mm";
    plot.x.label = "distance from the sheet (mm)";
    plot.y.label = "resolution (line pairs per mm)";
    plot.x.low = 0;
    plot.x.high = deepest;
    plot.y.logarithmic = true;
    PlotSeries pixels = series("pixels (4-6)", Style::line);
    PlotSeries front = series("lenses, object before the sheet (4-7)", Style::line);
    PlotSeries behind = series("lenses, behind it (4-7)", Style::line);
    constexpr int steps = 200;
    for (int i = 0; i <= steps; ++i) {
        const double depth = deepest * i / steps;
        if (i > 0)
            add(pixels, depth, depth_resolution(sheet, pixel, depth));
        if (depth <= 0.9 * d)
            add(front, depth, observer_resolution(sheet.pitch, d, depth));
        add(behind, depth, observer_resolution(sheet.pitch, d, -depth));
    }
    plot.series = {pixels, front, behind};
    return plot;
}

Plot pixels_seen_plot(const FrameMetadata& g, const Viewer& viewer)
{
    const LensSheet& sheet = g.sheet;
    const double pixel = counted(g).pixel, far = std::max(1000.0, 1.25 * g.aperture.distance);
    Plot plot;
    plot.title = "Pixels of each lens that an eye sees at once (figure 4-8)";
    plot.subtitle = description(sheet) + "; " + written(mm_per_inch / pixel) + " dpi";
    plot.x.label = "distance of the eye (mm)";
    plot.y.label = "pixels";
    plot.x.low = 0;
    plot.x.high = far;
    plot.y.low = 0;
    PlotSeries seen = series("pupil " + written(viewer.pupil) + " mm (4-1)", Style::line);
    constexpr int first = 10, steps = 200; // nearer distances would flatten the curve
    for (int i = first; i <= steps; ++i)
        add(seen, far * i / steps, pixels_seen(sheet, pixel, viewer.pupil, far * i / steps));
    plot.series.push_back(seen);
    plot.series.push_back(level("one pixel", 0, far, 1));
    return plot;
}

Plot pixel_spread_plot(const FrameMetadata& g)
{
    const LensSheet& sheet = g.sheet;
    const double pixel = counted(g).pixel;
    const auto angle = pixel_angle(sheet, pixel);
    if (!angle)
        throw std::invalid_argument("--plot pixel-spread: light from the edge of a pixel that wide "
                                    "is totally reflected in a sheet that thin");
    constexpr double far = 300; // mm
    Plot plot;
    plot.title = "What one pixel covers, against distance (figure 4-11)";
    plot.subtitle = description(sheet) + "; " + written(mm_per_inch / pixel) + " dpi; " +
                    written(*angle) + " degrees, " + written(pixel_spread(*angle, far)) +
                    " mm at " + written(far) + " mm";
    plot.x.label = "distance from the sheet (mm)";
    plot.y.label = "width (mm)";
    plot.x.low = 0;
    plot.x.high = far;
    plot.y.low = 0;
    PlotSeries spread = series("pixel (4-5)", Style::line),
               beam = series("with its lens's width", Style::line);
    for (const double distance : {0.0, far}) {
        add(spread, distance, pixel_spread(*angle, distance));
        add(beam, distance, sheet.pitch + pixel_spread(*angle, distance));
    }
    plot.series = {spread, beam};
    return plot;
}

/// The place on the film that an eye on the lens's axis, at the distance d before the lens, sees at
/// each place on the lens. The film lies `film_gap` behind the lens's focus (negative: before).
PlotSeries film_seen(const LensSheet& sheet, double d, double film_gap)
{
    const double margin = 0.5 * sheet.pitch;
    PlotSeries seen = series(film_gap == 0 ? "film at the focus"
                                           : "film " + written(std::fabs(film_gap)) + " mm " +
                                                 (film_gap < 0 ? "nearer" : "farther"),
                             Style::line);
    const Medium medium(sheet.thickness + film_gap, sheet.ior);
    constexpr int steps = 100;
    for (int i = 0; i <= steps; ++i) {
        const double v = margin * (2.0 * i / steps - 1);
        const auto plane = tangent_plane(surface_radius(sheet), v);
        if (!plane)
            continue;
        const Vec3 to_eye{-v, 0, -(d + plane->height)};
        if (const auto way = way_refracted_into(medium, *plane, (1 / length(to_eye)) * to_eye))
            add(seen, v, v - way->x);
    }
    return seen;
}

Plot film_plot(const FrameMetadata& g)
{
    const LensSheet& sheet = g.sheet;
    demand_surface(sheet, "film");
    const LensRowGeometry c = counted(g);
    const double d = g.aperture.distance, margin = 0.5 * sheet.pitch;
    Plot plot;
    plot.title = "What of the film a lens shows, near its focus and beside it (figures 4-3 to 4-6)";
    plot.subtitle = description(sheet) + "; the lens on the axis, an eye " + written(d) +
                    " mm before it; rising: upright, falling: inverted";
    plot.x.label = "place on the lens (mm)";
    plot.y.label = "place on the film that the eye sees there (mm)";
    plot.x.low = -margin;
    plot.x.high = margin;
    const double image = micro_image_width(sheet, d, c.aperture);
    for (const double part : {-0.3, -0.15, 0.0, 0.15, 0.3}) // parts of the thickness
        plot.series.push_back(film_seen(sheet, d, part * sheet.thickness));
    if (std::isfinite(image)) {
        plot.series.push_back(
            level("the capture aperture's micro-image", -margin, margin, 0.5 * image, true));
        plot.series.back().colour = 6;
    }
    return plot;
}

struct PlotKind {
    const char* word;
    Plot (*plot)(const FrameMetadata& geometry, const Viewer& viewer);
};

const PlotKind plot_kinds[] = {
    {"spread", [](const FrameMetadata& g, const Viewer&) { return spread_plot(g); }},
    {"lens", [](const FrameMetadata& g, const Viewer&) { return lens_plot(g); }},
    {"sheets", [](const FrameMetadata&, const Viewer&) { return sheets_plot(); }},
    {"resolution", resolution_plot},
    {"pixels-seen", pixels_seen_plot},
    {"pixel-spread", [](const FrameMetadata& g, const Viewer&) { return pixel_spread_plot(g); }},
    {"film", [](const FrameMetadata& g, const Viewer&) { return film_plot(g); }},
};

} // namespace

std::string sheet_plot_kinds()
{
    std::string text;
    for (const PlotKind& kind : plot_kinds)
        text += (text.empty()                        ? ""
                 : &kind == std::end(plot_kinds) - 1 ? " or "
                                                     : ", ") +
                std::string(kind.word);
    return text;
}

Plot sheet_plot(const std::string& word, const FrameMetadata& g, const Viewer& viewer)
{
    for (const PlotKind& kind : plot_kinds)
        if (word == kind.word)
            return kind.plot(g, viewer);
    throw std::invalid_argument("--plot " + word + ": " + sheet_plot_kinds() + " is expected");
}

} // namespace integral
