// SPDX-License-Identifier: AGPL-3.0-or-later
// An axis of a plot: which range it shows, and where it is marked and labelled.
#ifndef INTEGRAL_IO_PLOT_AXIS_H
#define INTEGRAL_IO_PLOT_AXIS_H

#include "integral/io/plot.h"

namespace integral {

/// A mark on an axis; one without a label is a minor one, between the others.
struct PlotTick {
    double value = 0;
    std::string label;    ///< "250", "0.2", or with an exponent "10" or "2·10"
    std::string exponent; ///< raised after the label; mostly empty
};

struct PlotScale {
    double low = 0, high = 1; ///< low < high; both > 0 if logarithmic
    bool logarithmic = false;
    std::vector<PlotTick> ticks; ///< ascending, all of them from low to high

    /// Where on the axis a value is: 0 at low, 1 at high. The value must be showable.
    double part(double value) const;
    /// Whether a value has a place on the axis or beyond its ends: finite, and > 0 if logarithmic.
    bool showable(double value) const;
    /// Whether it is on the axis itself, but for rounding.
    bool contains(double value) const;
};

/// The scale that shows those of `values` that are showable, with marks at 1-2-5 steps,
/// `most_labels` (>= 2) of them at most, and at decades and their parts on a logarithmic axis.
/// Throws std::invalid_argument where the axis's own range is upside down, empty or not showable.
PlotScale make_scale(const PlotAxis& axis, const std::vector<double>& values, int most_labels);

} // namespace integral

#endif
