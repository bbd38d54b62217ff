// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the range, the ticks and the labels of a plot's axis.
#ifndef INTEGRAL_IO_PLOT_AXIS_H
#define INTEGRAL_IO_PLOT_AXIS_H

#include "integral/io/plot.h"

namespace integral {

/// A tick on an axis; a tick without a label is a minor tick.
struct PlotTick {
    double value = 0;
    std::string label;    ///< "250", "0.2", or with an exponent "10" or "2·10"
    std::string exponent; ///< superscript after the label; usually empty
};

struct PlotScale {
    double low = 0, high = 1; ///< low < high; both > 0 if logarithmic
    bool logarithmic = false;
    std::vector<PlotTick> ticks; ///< ascending, within low to high

    /// Position of a showable value along the axis: 0 at low, 1 at high.
    double part(double value) const;
    /// Whether a value has a position, inside the range or outside: finite, and > 0 if logarithmic.
    bool showable(double value) const;
    /// Whether a value is within the range, up to rounding.
    bool contains(double value) const;
};

/// The scale for the showable values among `values`. Ticks are at 1-2-5 steps, at most
/// `most_labels` (>= 2) of them; on a logarithmic axis they are at decades and, if there is room,
/// between decades. Throws std::invalid_argument if the axis's given range is reversed, empty or
/// not showable.
PlotScale make_scale(const PlotAxis& axis, const std::vector<double>& values, int most_labels);

} // namespace integral

#endif
