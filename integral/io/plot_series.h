// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws the series of a plot into the plot area: bands, error bars, lines, marks and names.
#ifndef INTEGRAL_IO_PLOT_SERIES_H
#define INTEGRAL_IO_PLOT_SERIES_H

#include "integral/io/plot_axis.h"
#include "integral/io/plot_canvas.h"
#include "integral/io/plot_names.h"

namespace integral {

constexpr double plot_mark_radius = 4.5; // pixels
constexpr PlotInk plot_grey{0.42, 0.42, 0.42};

/// The part of the picture where points are drawn, and the scales of its axes.
struct PlotArea {
    PlotScale x, y;
    PlotBox box; ///< pixels of the picture

    double at_x(double value) const { return box.left + x.part(value) * (box.right - box.left); }
    double at_y(double value) const { return box.bottom - y.part(value) * (box.bottom - box.top); }
    /// Whether a series' point has a position, inside the area or outside.
    bool shows(const PlotSeries& series, std::size_t point) const
    {
        return x.showable(series.x[point]) && y.showable(series.y[point]);
    }
    /// Whether a series' point lies in the area.
    bool contains(const PlotSeries& series, std::size_t point) const
    {
        return x.contains(series.x[point]) && y.contains(series.y[point]);
    }
};

bool has_line(PlotSeries::Style style);
bool has_marks(PlotSeries::Style style);

/// The colour of the series at `index`.
PlotInk ink_of(const Plot& plot, std::size_t index);

/// Draws bands, error bars and lines, cut off at the area's border.
void draw_lines(PlotCanvas& canvas, const Plot& plot, const PlotArea& area);

/// Draws the marks of the points that lie in the area.
void draw_marks(PlotCanvas& canvas, const Plot& plot, const PlotArea& area);

/// Writes the names of the points that lie in the area. If there is room, they cover no mark and no
/// line.
void write_names(PlotCanvas& canvas, const Plot& plot, const PlotArea& area);

} // namespace integral

#endif
