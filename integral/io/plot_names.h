// SPDX-License-Identifier: AGPL-3.0-or-later
// Places the names of a plot's points so that they are legible.
#ifndef INTEGRAL_IO_PLOT_NAMES_H
#define INTEGRAL_IO_PLOT_NAMES_H

#include <vector>

namespace integral {

/// A rectangle of the picture, in pixels; y grows downwards.
struct PlotBox {
    double left = 0, top = 0, right = 0, bottom = 0;
};

/// The area of the intersection of two boxes, in square pixels.
double shared_area(const PlotBox& a, const PlotBox& b);

/// A text to place next to a point.
struct PlotName {
    double x = 0, y = 0;          ///< the point
    double width = 0, height = 0; ///< of the text
    PlotBox box;                  ///< result: where to write the text
    bool far = false;             ///< result: not next to its point, so draw a line to the point
};

/// Chooses a box for each name near its point and inside `area`. If there is room, no box covers
/// another or an obstacle (marks and pieces of lines). The result depends only on the input.
void place_names(std::vector<PlotName>& names, const PlotBox& area,
                 const std::vector<PlotBox>& obstacles);

} // namespace integral

#endif
