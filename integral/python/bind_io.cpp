// SPDX-License-Identifier: AGPL-3.0-or-later
// Plots, for Python.
#include "integral/io/plot.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"

#include <pybind11/stl.h>

#include <map>

namespace integral {
namespace {

PlotSeries::Style style_named(const std::string& name)
{
    static const std::map<std::string, PlotSeries::Style> styles = {
        {"line", PlotSeries::Style::line},
        {"points", PlotSeries::Style::points},
        {"both", PlotSeries::Style::line_and_points},
        {"dashed", PlotSeries::Style::dashed}};
    const auto style = styles.find(name);
    if (style == styles.end())
        throw std::invalid_argument("style " + name + ": line, points, both or dashed is expected");
    return style->second;
}

/// A curve: label, x, y and style.
using Curve = std::tuple<std::string, std::vector<double>, std::vector<double>, std::string>;

/// Label, whether the axis is logarithmic, and the ends of its range, None for those that fit.
using Axis = std::tuple<std::string, bool, std::optional<double>, std::optional<double>>;

PlotAxis axis_of(const Axis& axis)
{
    return {std::get<0>(axis), std::get<1>(axis), std::get<2>(axis), std::get<3>(axis)};
}

void plot(const std::string& path, const std::vector<Curve>& curves, const Axis& x, const Axis& y,
          const std::string& title, const std::string& subtitle)
{
    Plot made;
    made.title = title;
    made.subtitle = subtitle;
    made.x = axis_of(x);
    made.y = axis_of(y);
    for (const auto& [label, at, values, style] : curves) {
        PlotSeries series;
        series.label = label;
        series.x = at;
        series.y = values;
        series.style = style_named(style);
        made.series.push_back(std::move(series));
    }
    run_long(py::none(), [&](const Progress&) { write_plot(made, path); });
}

} // namespace

void declare_io(py::module_& module) { module.def("plot", plot); }

} // namespace integral
