// SPDX-License-Identifier: AGPL-3.0-or-later
// Quilts: the views of a grid in one picture, view 0 at the bottom left, named as light-field
// displays expect.
#ifndef INTEGRAL_OUTPUT_QUILT_H
#define INTEGRAL_OUTPUT_QUILT_H

#include "integral/lightfield/image.h"
#include "integral/lightfield/view_grid.h"

#include <optional>
#include <string>

namespace integral {

/// The columns and rows that a quilt's file name says, which ends in _qs<columns>x<rows>a<aspect>
/// before the extension; nothing if it does not.
std::optional<ViewGrid> grid_in_name(const std::string& path);

/// The path with such an end; as it is if it has one already. `aspect`: a view's width by its
/// height, as it is to be seen.
std::string quilt_name(const std::string& path, ViewGrid grid, double aspect);

/// Views by number, grid.count() of one size and form, as one picture; and back. The quilt has a
/// pixel for each view at least; where its sides are no whole multiples of the grid's (displays ask
/// for 5 x 9 views in 4096 x 4096 pixels), the rest is at the right and at the top. Throws
/// std::invalid_argument as `tiled` does.
Image quilt_of_views(std::vector<Image> views, ViewGrid grid);
std::vector<Image> views_of_quilt(const Image& quilt, ViewGrid grid);

} // namespace integral

#endif
