// SPDX-License-Identifier: AGPL-3.0-or-later
// Where the names of a plot's points stand so that they can be read.
#ifndef INTEGRAL_IO_PLOT_NAMES_H
#define INTEGRAL_IO_PLOT_NAMES_H

#include <vector>

namespace integral {

/// A rectangle of the picture, pixels; y grows downwards.
struct PlotBox {
    double left = 0, top = 0, right = 0, bottom = 0;
};

/// The area that two boxes share; 0 if none.
double shared_area(const PlotBox& a, const PlotBox& b);

/// A text to be placed beside a point.
struct PlotName {
    double x = 0, y = 0;          ///< the point
    double width = 0, height = 0; ///< of the text
    PlotBox box;                  ///< result: where the text stands
    bool far = false;             ///< result: not right beside its point, which a line should show
};

/// Chooses each name's box: beside its point, inside `area`, off the others' boxes and off
/// `obstacles` (marks and pieces of lines) as far as there is room. Always the same for the same
/// input.
void place_names(std::vector<PlotName>& names, const PlotBox& area,
                 const std::vector<PlotBox>& obstacles);

} // namespace integral

#endif
