// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/plot.h"

#include "integral/base/file_bytes.h"
#include "integral/io/plot_axis.h"
#include "integral/io/plot_canvas.h"
#include "integral/io/plot_series.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr PlotInk black{0.13, 0.13, 0.13}, axis_ink{0.35, 0.35, 0.35};
constexpr PlotInk major_grid{0.88, 0.88, 0.88}, minor_grid{0.945, 0.945, 0.945};

constexpr double title_size = 17, subtitle_size = 13, label_size = 13.5, tick_size = 12.5;
constexpr double sample_length = 30; // of the legend's lines
constexpr double margin = 18, pixels_per_label_x = 75, pixels_per_label_y = 42;

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
    double tick_width(const PlotTick& tick);
    void write_tick(const PlotTick& tick, double left, double baseline);

    const Plot& plot_;
    PlotCanvas& canvas_;
    PlotArea area_;
    double top_ = 0; // lower edge of the text written so far
};

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
    area_.x = make_scale(plot_.x, all_x, std::max(2, int(plot_.width / pixels_per_label_x)));
    area_.y = make_scale(plot_.y, all_y, std::max(2, int(plot_.height / pixels_per_label_y)));
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
    write(plot_.subtitle, subtitle_size, false, plot_grey);
}

void Drawing::write_legend()
{
    canvas_.set_font(label_size, false);
    double left = margin, baseline = 0;
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
        const PlotSeries& s = plot_.series[i];
        if (s.label.empty())
            continue;
        const double sample = has_line(s.style) || s.band ? sample_length : 2 * plot_mark_radius;
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
                                 ink_of(plot_, i), 0.2);
        if (has_line(s.style))
            canvas_.stroke({{left, middle}, {left + sample, middle}}, ink_of(plot_, i), 2,
                           s.style == Style::dashed);
        if (has_marks(s.style))
            canvas_.mark(left + sample / 2, middle, plot_mark_radius, int(i), ink_of(plot_, i));
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
    for (const PlotTick& tick : area_.y.ticks)
        labels = std::max(labels, tick_width(tick));
    area_.box.left = margin + (plot_.y.label.empty() ? 0 : 1.6 * label_size) + labels + 8;
    double last = 0;
    for (const PlotTick& tick : area_.x.ticks)
        if (!tick.label.empty())
            last = tick_width(tick);
    area_.box.right = plot_.width - std::max(margin, 0.5 * last + 6);
    area_.box.top = top_ + 14;
    area_.box.bottom = plot_.height - margin - 1.3 * tick_size -
                       (plot_.x.label.empty() ? 0 : 1.5 * label_size);
    if (!(area_.box.right > area_.box.left && area_.box.bottom > area_.box.top))
        throw std::invalid_argument("the plot's legend and labels leave no room for its points");
}

void Drawing::draw_grid()
{
    const auto lines = [&](const PlotScale& scale, bool upright, bool major) {
        for (const PlotTick& tick : scale.ticks) {
            if (tick.label.empty() == major)
                continue;
            // the middle of a pixel, for a sharp line
            const double at = std::floor(upright ? area_.at_x(tick.value)
                                                 : area_.at_y(tick.value)) +
                              0.5;
            const PlotPosition from = upright ? PlotPosition{at, area_.box.top}
                                              : PlotPosition{area_.box.left, at};
            const PlotPosition to = upright ? PlotPosition{at, area_.box.bottom}
                                            : PlotPosition{area_.box.right, at};
            canvas_.stroke({from, to}, major ? major_grid : minor_grid, 1);
        }
    };
    for (const bool major : {false, true}) {
        lines(area_.x, true, major);
        lines(area_.y, false, major);
    }
}

void Drawing::label_axes()
{
    const double left = std::floor(area_.box.left) + 0.5,
                 bottom = std::floor(area_.box.bottom) + 0.5;
    canvas_.stroke({{left, area_.box.top}, {left, bottom}, {area_.box.right, bottom}}, axis_ink, 1);
    for (const PlotTick& tick : area_.x.ticks)
        if (!tick.label.empty()) {
            const double x = std::floor(area_.at_x(tick.value)) + 0.5;
            canvas_.stroke({{x, bottom}, {x, bottom + 4}}, axis_ink, 1);
            write_tick(tick, x - 0.5 * tick_width(tick), bottom + 7 + 0.9 * tick_size);
        }
    for (const PlotTick& tick : area_.y.ticks)
        if (!tick.label.empty()) {
            const double y = std::floor(area_.at_y(tick.value)) + 0.5;
            canvas_.stroke({{left - 4, y}, {left, y}}, axis_ink, 1);
            write_tick(tick, left - 7 - tick_width(tick), y + 0.36 * tick_size);
        }
    canvas_.set_font(label_size, false);
    canvas_.write(plot_.x.label,
                  0.5 * (area_.box.left + area_.box.right - canvas_.text_width(plot_.x.label)),
                  plot_.height - margin + 2, black);
    canvas_.write_upwards(
        plot_.y.label, margin + 0.75 * label_size,
        0.5 * (area_.box.top + area_.box.bottom + canvas_.text_width(plot_.y.label)), black);
}

void Drawing::draw()
{
    make_scales();
    write_heading();
    write_legend();
    lay_out_area();
    draw_grid();
    draw_lines(canvas_, plot_, area_);
    label_axes();
    draw_marks(canvas_, plot_, area_);
    write_names(canvas_, plot_, area_);
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
