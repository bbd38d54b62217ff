// SPDX-License-Identifier: AGPL-3.0-or-later
// Line and scatter plots of measured and computed figures, as SVG or PNG (drawn by cairo).
#ifndef INTEGRAL_IO_PLOT_H
#define INTEGRAL_IO_PLOT_H

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Points of one kind, joined by a line, marked, or both. A line is broken where points are left
/// out.
struct PlotSeries {
    enum class Style {
        line,
        points,
        line_and_points,
        dashed,
        none
    };                              ///< none: its bars or band alone
    std::string label;              ///< in the legend; empty: not there
    std::vector<double> x, y;       ///< equally many; those not finite are left out
    std::vector<double> low, high;  ///< error bars in y, as many again, or none
    std::vector<std::string> names; ///< a short text beside each point, or none
    Style style = Style::line;
    bool band = false;         ///< low to high as a shaded band instead of bars
    std::optional<int> colour; ///< in a palette of 7 that ends in grey, >= 0; default: the series'
                               ///< place
};

/// An axis; a range that is not given holds all points, rounded outwards to its ticks.
struct PlotAxis {
    std::string label;               ///< quantity and unit, as in "distance (mm)"
    bool logarithmic = false;        ///< points that are not greater than 0 are left out
    std::optional<double> low, high; ///< points beyond are not drawn
};

struct Plot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotSeries> series;
    int width = 900, height = 600; ///< pixels; 200 to 10000
    std::string subtitle;          ///< under the title: what the figures hold for
};

enum class PlotFormat { svg, png };

/// The format that a file's name asks for. Throws std::invalid_argument where it ends in neither
/// .svg nor .png.
PlotFormat plot_format(const std::string& file);

/// The plot as the bytes of a file: the same ones for the same plot, fonts and cairo. The legend
/// stands above the points and so covers none. Text is UTF-8; in SVG it is drawn as outlines, which
/// look alike everywhere. The series differ by mark and by colours that the colour-blind can tell
/// apart. Throws std::invalid_argument where the plot contradicts itself (a range upside down,
/// lists of unequal length).
std::string plot_bytes(const Plot& plot, PlotFormat format);

/// Writes plot_bytes to FILE.svg or FILE.png, whole or not at all. Throws as plot_format and
/// plot_bytes do, and OutputError (file_bytes.h), a std::runtime_error, where the file cannot be
/// written.
void write_plot(const Plot& plot, const std::string& file);

} // namespace integral

#endif
