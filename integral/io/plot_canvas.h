// SPDX-License-Identifier: AGPL-3.0-or-later
// What plots are drawn on: a white picture, PNG or SVG, by the same strokes (cairo's).
#ifndef INTEGRAL_IO_PLOT_CANVAS_H
#define INTEGRAL_IO_PLOT_CANVAS_H

#include "integral/io/plot.h"
#include "integral/io/plot_names.h"

#include <memory>

namespace integral {

struct PlotInk {
    double red, green, blue; ///< sRGB, 0 to 1
    PlotInk darker(double factor) const { return {factor * red, factor * green, factor * blue}; }
};

struct PlotPosition {
    double x, y; ///< pixels, y downwards
};

/// Everything throws std::invalid_argument where a text is not UTF-8, std::runtime_error where
/// memory is short.
class PlotCanvas {
public:
    PlotCanvas(int width, int height, PlotFormat format);
    ~PlotCanvas();

    void stroke(const std::vector<PlotPosition>& line, PlotInk ink, double width,
                bool dashed = false);
    void fill_polygon(const std::vector<PlotPosition>& corners, PlotInk ink, double opacity);
    /// One of six marks (circle, square, triangle, ...), of about the same area, edged in white.
    void mark(double x, double y, double radius, int kind, PlotInk ink);

    void set_font(double size, bool bold);
    double text_width(const std::string& text);
    void write(const std::string& text, double left, double baseline, PlotInk ink);
    /// The same on a white outline, so that it can be read upon lines.
    void write_with_halo(const std::string& text, double left, double baseline, PlotInk ink);
    /// Turned a quarter to the left: it begins at `bottom` and runs upwards.
    void write_upwards(const std::string& text, double baseline, double bottom, PlotInk ink);

    /// From here on only inside of the box, until unclip.
    void clip(const PlotBox& box);
    void unclip();

    /// The file's bytes; nothing may be drawn after this. An SVG has `title` as its accessible
    /// name.
    std::string finish(const std::string& title);

private:
    struct Cairo;
    std::unique_ptr<Cairo> cairo_;
};

} // namespace integral

#endif
