// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/plot_series.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

// Okabe and Ito's colours, which colour-blind readers can distinguish, without their yellow, which
// is too pale on white.
constexpr PlotInk inks[] = {{0, 0.447, 0.698},   {0.835, 0.369, 0}, {0, 0.620, 0.451},
                            {0.8, 0.475, 0.655}, {0.902, 0.624, 0}, {0.337, 0.706, 0.914},
                            {0.25, 0.25, 0.25}};
constexpr double name_size = 11.5;

void draw_line(PlotCanvas& canvas, const PlotArea& area, const PlotSeries& s, const PlotInk& ink)
{
    std::vector<PlotPosition> piece;
    const auto finish = [&] {
        canvas.stroke(piece, ink, 2, s.style == PlotSeries::Style::dashed);
        piece.clear();
    };
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        if (area.shows(s, i))
            piece.push_back({area.at_x(s.x[i]), area.at_y(s.y[i])});
        else
            finish();
    }
    finish();
}

/// The y pixel of an error bar's lower end; below the area if a logarithmic axis cannot show it.
double bar_end(const PlotArea& area, double y)
{
    return area.y.showable(y) ? area.at_y(y) : area.box.bottom + 100;
}

void draw_band(PlotCanvas& canvas, const PlotArea& area, const PlotSeries& s, const PlotInk& ink)
{
    std::vector<PlotPosition> outline, lower;
    const auto finish = [&] {
        outline.insert(outline.end(), lower.rbegin(), lower.rend());
        canvas.fill_polygon(outline, ink, 0.2);
        outline.clear();
        lower.clear();
    };
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        if (area.x.showable(s.x[i]) && area.y.showable(s.high[i])) {
            outline.push_back({area.at_x(s.x[i]), area.at_y(s.high[i])});
            lower.push_back({area.at_x(s.x[i]), bar_end(area, s.low[i])});
        } else
            finish();
    }
    finish();
}

void draw_bars(PlotCanvas& canvas, const PlotArea& area, const PlotSeries& s, const PlotInk& ink)
{
    for (std::size_t i = 0; i < s.low.size(); ++i) {
        if (!area.shows(s, i) || !area.x.contains(s.x[i]) || !area.y.showable(s.high[i]))
            continue;
        const double x = area.at_x(s.x[i]), top = area.at_y(s.high[i]),
                     bottom = bar_end(area, s.low[i]);
        canvas.stroke({{x, top}, {x, bottom}}, ink, 1.3);
        for (const double end : {top, bottom})
            canvas.stroke({{x - 3.5, end}, {x + 3.5, end}}, ink, 1.3);
    }
}

/// Boxes around marks and pieces of lines, which names should not cover.
std::vector<PlotBox> obstacles(const Plot& plot, const PlotArea& area)
{
    std::vector<PlotBox> boxes;
    const auto add = [&](double x, double y, double r) {
        boxes.push_back({x - r, y - r, x + r, y + r});
    };
    for (const PlotSeries& s : plot.series)
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (!area.shows(s, i))
                continue;
            const double x = area.at_x(s.x[i]), y = area.at_y(s.y[i]);
            if (has_marks(s.style))
                add(x, y, plot_mark_radius);
            if (!has_line(s.style) || i == 0 || !area.shows(s, i - 1))
                continue;
            const double from_x = area.at_x(s.x[i - 1]), from_y = area.at_y(s.y[i - 1]);
            const int pieces = std::min(200, 1 + int(std::hypot(x - from_x, y - from_y) / 6));
            for (int piece = 0; piece < pieces; ++piece)
                add(from_x + (x - from_x) * piece / pieces, from_y + (y - from_y) * piece / pieces,
                    1.5);
        }
    return boxes;
}

} // namespace

bool has_line(PlotSeries::Style style)
{
    return style != PlotSeries::Style::points && style != PlotSeries::Style::none;
}

bool has_marks(PlotSeries::Style style)
{
    return style == PlotSeries::Style::points || style == PlotSeries::Style::line_and_points;
}

PlotInk ink_of(const Plot& plot, std::size_t index)
{
    return inks[plot.series[index].colour.value_or(int(index)) % std::size(inks)];
}

void draw_lines(PlotCanvas& canvas, const Plot& plot, const PlotArea& area)
{
    canvas.clip(area.box);
    for (std::size_t i = 0; i < plot.series.size(); ++i)
        if (plot.series[i].band)
            draw_band(canvas, area, plot.series[i], ink_of(plot, i));
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const PlotSeries& s = plot.series[i];
        if (!s.band)
            draw_bars(canvas, area, s, ink_of(plot, i));
        if (has_line(s.style))
            draw_line(canvas, area, s, ink_of(plot, i));
    }
    canvas.unclip();
}

void draw_marks(PlotCanvas& canvas, const Plot& plot, const PlotArea& area)
{
    for (std::size_t index = 0; index < plot.series.size(); ++index) {
        const PlotSeries& s = plot.series[index];
        if (!has_marks(s.style))
            continue;
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (area.contains(s, i))
                canvas.mark(area.at_x(s.x[i]), area.at_y(s.y[i]), plot_mark_radius, int(index),
                            ink_of(plot, index));
    }
}

void write_names(PlotCanvas& canvas, const Plot& plot, const PlotArea& area)
{
    canvas.set_font(name_size, false);
    std::vector<PlotName> names;
    std::vector<std::pair<const std::string*, PlotInk>> texts;
    for (std::size_t index = 0; index < plot.series.size(); ++index) {
        const PlotSeries& s = plot.series[index];
        for (std::size_t i = 0; i < s.names.size(); ++i)
            if (area.contains(s, i) && !s.names[i].empty()) {
                const double width = canvas.text_width(s.names[i]) + 2;
                names.push_back(
                    {area.at_x(s.x[i]), area.at_y(s.y[i]), width, name_size, {}, false});
                texts.emplace_back(&s.names[i], ink_of(plot, index));
            }
    }
    if (names.empty())
        return;
    place_names(names, area.box, obstacles(plot, area));
    for (const PlotName& name : names)
        if (name.far)
            canvas.stroke({{name.x, name.y},
                           {std::clamp(name.x, name.box.left, name.box.right),
                            std::clamp(name.y, name.box.top, name.box.bottom)}},
                          plot_grey, 0.7);
    for (std::size_t i = 0; i < names.size(); ++i)
        canvas.write_with_halo(*texts[i].first, names[i].box.left + 1,
                               names[i].box.bottom - 0.16 * name_size,
                               texts[i].second.darker(0.75));
}

} // namespace integral
