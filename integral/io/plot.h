// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws line and scatter plots as SVG or PNG with cairo.
#ifndef INTEGRAL_IO_PLOT_H
#define INTEGRAL_IO_PLOT_H

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// One series of points, drawn as a line, as marks or both. The line has a gap where a point is
/// left out.
struct PlotSeries {
    enum class Style {
        line,
        points,
        line_and_points,
        dashed,
        none ///< only error bars or band
    };
    std::string label;              ///< in the legend; empty: no entry
    std::vector<double> x, y;       ///< of equal length; points that are not finite are left out
    std::vector<double> low, high;  ///< ends of error bars in y, one per point; may be empty
    std::vector<std::string> names; ///< a short text for each point; may be empty
    Style style = Style::line;
    bool band = false;         ///< draw low to high as a shaded band instead of bars
    std::optional<int> colour; ///< index >= 0 in a palette of 7, whose last is grey; default: the
                               ///< series' index
};

/// An axis. If an end of the range is not given, it is chosen so that all points fit, and rounded
/// outwards to a tick.
struct PlotAxis {
    std::string label;               ///< quantity and unit, as in "distance (mm)"
    bool logarithmic = false;        ///< then points <= 0 are left out
    std::optional<double> low, high; ///< points outside this range are not drawn
};

struct Plot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotSeries> series;
    int width = 900, height = 600; ///< pixels; 200 to 10000
    std::string subtitle;          ///< under the title: the conditions of the figures
};

enum class PlotFormat { svg, png };

/// The format for a file name. Throws std::invalid_argument if it ends in neither .svg nor .png.
PlotFormat plot_format(const std::string& file);

/// The plot as the bytes of a file, which depend only on the plot, the fonts and cairo's version.
/// The legend is above the plot area. Text is UTF-8; in SVG it is drawn as outlines and looks the
/// same everywhere. Series have different marks, and colours that colour-blind readers can
/// distinguish. Throws std::invalid_argument if the plot is inconsistent (low > high, lists of
/// unequal length).
std::string plot_bytes(const Plot& plot, PlotFormat format);

/// Writes plot_bytes to FILE.svg or FILE.png; the file appears only when it is complete. Throws as
/// plot_format and plot_bytes do, and OutputError (file_bytes.h) if the file cannot be written.
void write_plot(const Plot& plot, const std::string& file);

} // namespace integral

#endif
