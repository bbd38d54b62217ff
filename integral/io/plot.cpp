// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/plot.h"

#include "integral/base/file_bytes.h"
#include "integral/io/plot_axis.h"
#include "integral/io/plot_canvas.h"
#include "integral/io/plot_names.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr PlotInk black{0.13, 0.13, 0.13}, grey{0.42, 0.42, 0.42}, axis_ink{0.35, 0.35, 0.35};
constexpr PlotInk major_grid{0.88, 0.88, 0.88}, minor_grid{0.945, 0.945, 0.945};
// Okabe and Ito's colours, which colour-blind readers can distinguish, without their yellow, which
// is too pale on white.
constexpr PlotInk inks[] = {{0, 0.447, 0.698},   {0.835, 0.369, 0}, {0, 0.620, 0.451},
                            {0.8, 0.475, 0.655}, {0.902, 0.624, 0}, {0.337, 0.706, 0.914},
                            {0.25, 0.25, 0.25}};

constexpr double title_size = 17, subtitle_size = 13, label_size = 13.5, tick_size = 12.5,
                 name_size = 11.5;
constexpr double mark_radius = 4.5, sample_length = 30; // of the legend's lines
constexpr double margin = 18, pixels_per_label_x = 75, pixels_per_label_y = 42;

struct Point {
    double x, y;
};

class Drawing {
public:
    Drawing(const Plot& plot, PlotCanvas& canvas) : plot_(plot), canvas_(canvas) {}
    void draw();

private:
    using Style = PlotSeries::Style;
    void make_scales();
    void write_heading();
    void write_legend();
    void lay_out_area();
    void draw_grid();
    void label_axes();
    void draw_line(const PlotSeries& series, const PlotInk& ink);
    void draw_band(const PlotSeries& series, const PlotInk& ink);
    void draw_bars(const PlotSeries& series, const PlotInk& ink);
    void draw_marks(const PlotSeries& series, std::size_t index);
    void write_names();
    std::vector<PlotBox> obstacles() const;

    bool shows(const PlotSeries& s, std::size_t i) const
    {
        return x_.showable(s.x[i]) && y_.showable(s.y[i]);
    }
    bool within(const PlotSeries& s, std::size_t i) const
    {
        return x_.contains(s.x[i]) && y_.contains(s.y[i]);
    }
    double at_x(double x) const { return area_.left + x_.part(x) * (area_.right - area_.left); }
    double at_y(double y) const { return area_.bottom - y_.part(y) * (area_.bottom - area_.top); }
    /// The y pixel of an error bar's end; below the plot area if a logarithmic axis cannot show it.
    double bar_end(double y) const { return y_.showable(y) ? at_y(y) : area_.bottom + 100; }
    /// The colour of the series at `index`.
    PlotInk ink_of(std::size_t index) const
    {
        return inks[plot_.series[index].colour.value_or(int(index)) % std::size(inks)];
    }
    double tick_width(const PlotTick& tick);
    void write_tick(const PlotTick& tick, double left, double baseline);

    const Plot& plot_;
    PlotCanvas& canvas_;
    PlotScale x_, y_;
    PlotBox area_;   // where points are drawn
    double top_ = 0; // lower edge of the text written so far
};

bool has_line(PlotSeries::Style style)
{
    return style != PlotSeries::Style::points && style != PlotSeries::Style::none;
}
bool has_marks(PlotSeries::Style style)
{
    return style == PlotSeries::Style::points || style == PlotSeries::Style::line_and_points;
}

void Drawing::make_scales()
{
    std::vector<double> all_x, all_y;
    for (const PlotSeries& s : plot_.series)
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (!std::isfinite(s.x[i]) || !std::isfinite(s.y[i]) ||
                (plot_.x.logarithmic && !(s.x[i] > 0)))
                continue;
            all_x.push_back(s.x[i]);
            all_y.push_back(s.y[i]);
            if (!s.low.empty()) {
                all_y.push_back(s.low[i]);
                all_y.push_back(s.high[i]);
            }
        }
    x_ = make_scale(plot_.x, all_x, std::max(2, int(plot_.width / pixels_per_label_x)));
    y_ = make_scale(plot_.y, all_y, std::max(2, int(plot_.height / pixels_per_label_y)));
}

void Drawing::write_heading()
{
    top_ = margin - 4;
    const auto write = [&](std::string text, double size, bool bold, PlotInk ink) {
        canvas_.set_font(size, bold);
        while (!text.empty()) { // put as many words on a line as fit
            std::size_t end = text.size();
            while (canvas_.text_width(text.substr(0, end)) > plot_.width - 2 * margin) {
                const std::size_t space = text.rfind(' ', end - 1);
                if (space == std::string::npos || space == 0)
                    break;
                end = space;
            }
            top_ += 1.4 * size;
            canvas_.write(text.substr(0, end), margin, top_ - 0.2 * size, ink);
            text.erase(0, end + 1);
        }
    };
    write(plot_.title, title_size, true, black);
    write(plot_.subtitle, subtitle_size, false, grey);
}

void Drawing::write_legend()
{
    canvas_.set_font(label_size, false);
    double left = margin, baseline = 0;
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
        const PlotSeries& s = plot_.series[i];
        if (s.label.empty())
            continue;
        const double sample = has_line(s.style) || s.band ? sample_length : 2 * mark_radius;
        const double wide = sample + 6 + canvas_.text_width(s.label);
        if (baseline == 0 || (left > margin && left + wide > plot_.width - margin)) {
            left = margin;
            top_ += (baseline == 0 ? 1.9 : 1.55) * label_size;
            baseline = top_ - 0.35 * label_size;
        }
        const double middle = baseline - 0.36 * label_size;
        if (s.band)
            canvas_.fill_polygon({{left, middle - 5.5},
                                  {left + sample, middle - 5.5},
                                  {left + sample, middle + 5.5},
                                  {left, middle + 5.5}},
                                 ink_of(i), 0.2);
        if (has_line(s.style))
            canvas_.stroke({{left, middle}, {left + sample, middle}}, ink_of(i), 2,
                           s.style == Style::dashed);
        if (has_marks(s.style))
            canvas_.mark(left + sample / 2, middle, mark_radius, int(i), ink_of(i));
        canvas_.write(s.label, left + sample + 6, baseline, black);
        left += wide + 22;
    }
}

double Drawing::tick_width(const PlotTick& tick)
{
    canvas_.set_font(tick_size, false);
    double width = canvas_.text_width(tick.label);
    if (!tick.exponent.empty()) {
        canvas_.set_font(0.75 * tick_size, false);
        width += canvas_.text_width(tick.exponent);
    }
    return width;
}

void Drawing::write_tick(const PlotTick& tick, double left, double baseline)
{
    canvas_.set_font(tick_size, false);
    canvas_.write(tick.label, left, baseline, black);
    if (tick.exponent.empty())
        return;
    left += canvas_.text_width(tick.label);
    canvas_.set_font(0.75 * tick_size, false);
    canvas_.write(tick.exponent, left, baseline - 0.4 * tick_size, black);
}

void Drawing::lay_out_area()
{
    double labels = 0;
    for (const PlotTick& tick : y_.ticks)
        labels = std::max(labels, tick_width(tick));
    area_.left = margin + (plot_.y.label.empty() ? 0 : 1.6 * label_size) + labels + 8;
    double last = 0;
    for (const PlotTick& tick : x_.ticks)
        if (!tick.label.empty())
            last = tick_width(tick);
    area_.right = plot_.width - std::max(margin, 0.5 * last + 6);
    area_.top = top_ + 14;
    area_.bottom = plot_.height - margin - 1.3 * tick_size -
                   (plot_.x.label.empty() ? 0 : 1.5 * label_size);
    if (!(area_.right > area_.left && area_.bottom > area_.top))
        throw std::invalid_argument("the plot's legend and labels leave no room for its points");
}

void Drawing::draw_grid()
{
    const auto lines = [&](const PlotScale& scale, bool upright, bool major) {
        for (const PlotTick& tick : scale.ticks) {
            if (tick.label.empty() == major)
                continue;
            // the middle of a pixel, for a sharp line
            const double at = std::floor(upright ? at_x(tick.value) : at_y(tick.value)) + 0.5;
            const PlotPosition from = upright ? PlotPosition{at, area_.top}
                                              : PlotPosition{area_.left, at};
            const PlotPosition to = upright ? PlotPosition{at, area_.bottom}
                                            : PlotPosition{area_.right, at};
            canvas_.stroke({from, to}, major ? major_grid : minor_grid, 1);
        }
    };
    for (const bool major : {false, true}) {
        lines(x_, true, major);
        lines(y_, false, major);
    }
}

void Drawing::label_axes()
{
    const double left = std::floor(area_.left) + 0.5, bottom = std::floor(area_.bottom) + 0.5;
    canvas_.stroke({{left, area_.top}, {left, bottom}, {area_.right, bottom}}, axis_ink, 1);
    for (const PlotTick& tick : x_.ticks)
        if (!tick.label.empty()) {
            const double x = std::floor(at_x(tick.value)) + 0.5;
            canvas_.stroke({{x, bottom}, {x, bottom + 4}}, axis_ink, 1);
            write_tick(tick, x - 0.5 * tick_width(tick), bottom + 7 + 0.9 * tick_size);
        }
    for (const PlotTick& tick : y_.ticks)
        if (!tick.label.empty()) {
            const double y = std::floor(at_y(tick.value)) + 0.5;
            canvas_.stroke({{left - 4, y}, {left, y}}, axis_ink, 1);
            write_tick(tick, left - 7 - tick_width(tick), y + 0.36 * tick_size);
        }
    canvas_.set_font(label_size, false);
    canvas_.write(plot_.x.label,
                  0.5 * (area_.left + area_.right - canvas_.text_width(plot_.x.label)),
                  plot_.height - margin + 2, black);
    canvas_.write_upwards(plot_.y.label, margin + 0.75 * label_size,
                          0.5 * (area_.top + area_.bottom + canvas_.text_width(plot_.y.label)),
                          black);
}

void Drawing::draw_line(const PlotSeries& s, const PlotInk& ink)
{
    std::vector<PlotPosition> piece;
    const auto finish = [&] {
        canvas_.stroke(piece, ink, 2, s.style == Style::dashed);
        piece.clear();
    };
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        if (shows(s, i))
            piece.push_back({at_x(s.x[i]), at_y(s.y[i])});
        else
            finish();
    }
    finish();
}

void Drawing::draw_band(const PlotSeries& s, const PlotInk& ink)
{
    std::vector<PlotPosition> outline, lower;
    const auto finish = [&] {
        outline.insert(outline.end(), lower.rbegin(), lower.rend());
        canvas_.fill_polygon(outline, ink, 0.2);
        outline.clear();
        lower.clear();
    };
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        if (x_.showable(s.x[i]) && y_.showable(s.high[i])) {
            outline.push_back({at_x(s.x[i]), at_y(s.high[i])});
            lower.push_back({at_x(s.x[i]), bar_end(s.low[i])});
        } else
            finish();
    }
    finish();
}

void Drawing::draw_bars(const PlotSeries& s, const PlotInk& ink)
{
    for (std::size_t i = 0; i < s.low.size(); ++i) {
        if (!shows(s, i) || !x_.contains(s.x[i]) || !y_.showable(s.high[i]))
            continue;
        const double x = at_x(s.x[i]), top = at_y(s.high[i]), bottom = bar_end(s.low[i]);
        canvas_.stroke({{x, top}, {x, bottom}}, ink, 1.3);
        for (const double end : {top, bottom})
            canvas_.stroke({{x - 3.5, end}, {x + 3.5, end}}, ink, 1.3);
    }
}

void Drawing::draw_marks(const PlotSeries& s, std::size_t index)
{
    for (std::size_t i = 0; i < s.x.size(); ++i)
        if (within(s, i))
            canvas_.mark(at_x(s.x[i]), at_y(s.y[i]), mark_radius, int(index), ink_of(index));
}

/// Boxes around marks and pieces of lines, which names should not cover.
std::vector<PlotBox> Drawing::obstacles() const
{
    std::vector<PlotBox> boxes;
    const auto add = [&](double x, double y, double r) {
        boxes.push_back({x - r, y - r, x + r, y + r});
    };
    for (const PlotSeries& s : plot_.series)
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (!shows(s, i))
                continue;
            const double x = at_x(s.x[i]), y = at_y(s.y[i]);
            if (has_marks(s.style))
                add(x, y, mark_radius);
            if (!has_line(s.style) || i == 0 || !shows(s, i - 1))
                continue;
            const double from_x = at_x(s.x[i - 1]), from_y = at_y(s.y[i - 1]);
            const int pieces = std::min(200, 1 + int(std::hypot(x - from_x, y - from_y) / 6));
            for (int piece = 0; piece < pieces; ++piece)
                add(from_x + (x - from_x) * piece / pieces, from_y + (y - from_y) * piece / pieces,
                    1.5);
        }
    return boxes;
}

void Drawing::write_names()
{
    canvas_.set_font(name_size, false);
    std::vector<PlotName> names;
    std::vector<std::pair<const std::string*, PlotInk>> texts;
    for (std::size_t index = 0; index < plot_.series.size(); ++index) {
        const PlotSeries& s = plot_.series[index];
        for (std::size_t i = 0; i < s.names.size(); ++i)
            if (within(s, i) && !s.names[i].empty()) {
                names.push_back({at_x(s.x[i]),
                                 at_y(s.y[i]),
                                 canvas_.text_width(s.names[i]) + 2,
                                 name_size,
                                 {},
                                 false});
                texts.emplace_back(&s.names[i], ink_of(index));
            }
    }
    if (names.empty())
        return;
    place_names(names, area_, obstacles());
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const PlotName& name = names[i]; name.far)
            canvas_.stroke({{name.x, name.y},
                            {std::clamp(name.x, name.box.left, name.box.right),
                             std::clamp(name.y, name.box.top, name.box.bottom)}},
                           grey, 0.7);
    for (std::size_t i = 0; i < names.size(); ++i)
        canvas_.write_with_halo(*texts[i].first, names[i].box.left + 1,
                                names[i].box.bottom - 0.16 * name_size,
                                texts[i].second.darker(0.75));
}

void Drawing::draw()
{
    make_scales();
    write_heading();
    write_legend();
    lay_out_area();
    draw_grid();
    canvas_.clip(area_);
    for (std::size_t i = 0; i < plot_.series.size(); ++i)
        if (plot_.series[i].band)
            draw_band(plot_.series[i], ink_of(i));
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
        const PlotSeries& s = plot_.series[i];
        if (!s.band)
            draw_bars(s, ink_of(i));
        if (has_line(s.style))
            draw_line(s, ink_of(i));
    }
    canvas_.unclip();
    label_axes();
    for (std::size_t i = 0; i < plot_.series.size(); ++i)
        if (has_marks(plot_.series[i].style))
            draw_marks(plot_.series[i], i);
    write_names();
}

void check(const Plot& plot)
{
    const auto demand = [](bool good, const std::string& what) {
        if (!good)
            throw std::invalid_argument(what);
    };
    for (const int side : {plot.width, plot.height})
        demand(side >= 200 && side <= 10000, "a plot is 200 to 10000 pixels wide and high");
    for (const PlotSeries& s : plot.series) {
        const std::size_t n = s.x.size();
        demand(s.y.size() == n && s.low.size() == s.high.size() &&
                   (s.low.empty() || s.low.size() == n) && (s.names.empty() || s.names.size() == n),
               "the plot's series " + s.label + " has lists of unequal length");
        demand(s.colour.value_or(0) >= 0, "the plot's series " + s.label + " has no such colour");
        demand(!s.band || s.low.size() == n,
               "the plot's series " + s.label + " has a band without ends");
    }
}

} // namespace

PlotFormat plot_format(const std::string& file)
{
    for (const auto& [ending, format] :
         {std::pair{".svg", PlotFormat::svg}, std::pair{".png", PlotFormat::png}})
        if (file.size() > 4 && file.compare(file.size() - 4, 4, ending) == 0)
            return format;
    throw std::invalid_argument(file + ": a plot is written to FILE.svg or FILE.png");
}

std::string plot_bytes(const Plot& plot, PlotFormat format)
{
    check(plot);
    PlotCanvas canvas(plot.width, plot.height, format);
    Drawing(plot, canvas).draw();
    return canvas.finish(plot.title);
}

void write_plot(const Plot& plot, const std::string& file)
{
    write_file(file, plot_bytes(plot, plot_format(file)));
}

} // namespace integral
