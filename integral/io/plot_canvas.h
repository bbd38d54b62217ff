// SPDX-License-Identifier: AGPL-3.0-or-later
// The drawing surface of plots: lines, marks and text on a white PNG or SVG, by cairo.
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

/// Functions throw std::invalid_argument if a text is not UTF-8 and std::runtime_error if cairo
/// fails, as for lack of memory.
class PlotCanvas {
public:
    PlotCanvas(int width, int height, PlotFormat format);
    ~PlotCanvas();

    void stroke(const std::vector<PlotPosition>& line, PlotInk ink, double width,
                bool dashed = false);
    void fill_polygon(const std::vector<PlotPosition>& corners, PlotInk ink, double opacity);
    /// Draws one of six marks (circle, square, triangle, ...) of about equal area, with a white
    /// edge.
    void mark(double x, double y, double radius, int kind, PlotInk ink);

    void set_font(double size, bool bold);
    double text_width(const std::string& text);
    void write(const std::string& text, double left, double baseline, PlotInk ink);
    /// Writes with a white outline, so that the text is legible over lines.
    void write_with_halo(const std::string& text, double left, double baseline, PlotInk ink);
    /// Writes upwards from `bottom`, rotated 90 degrees to the left.
    void write_upwards(const std::string& text, double baseline, double bottom, PlotInk ink);

    /// Restricts drawing to the box until unclip().
    void clip(const PlotBox& box);
    void unclip();

    /// Returns the file's bytes; nothing may be drawn afterwards. `title` becomes the accessible
    /// name of an SVG.
    std::string finish(const std::string& title);

private:
    struct Cairo;
    std::unique_ptr<Cairo> cairo_;
};

} // namespace integral

#endif
