// SPDX-License-Identifier: AGPL-3.0-or-later
// Quilts: the views of a grid in one picture. Their order is that of the Looking Glass quilt
// standard (lookingglassfactory.com/tutorial/what-is-a-quilt): the bottom left tile is view 0, from
// the far left, the top right one the last, from the far right (of lenses that lie across: from
// below, and from above).
#ifndef INTEGRAL_OUTPUT_QUILT_H
#define INTEGRAL_OUTPUT_QUILT_H

#include "integral/lightfield/image.h"
#include "integral/lightfield/quilt_name.h"
#include "integral/lightfield/view_grid.h"

#include <functional>
#include <vector>

namespace integral {

/// Views by number, grid.count() of one size and form, as one picture; and back. The quilt has a
/// pixel for each view at least; where its sides are no whole multiples of the grid's (displays ask
/// for 5 x 9 views in 4096 x 4096 pixels), the rest is at the right and at the top. Throws
/// std::invalid_argument as `tiled` does.
Image quilt_of_views(std::vector<Image> views, ViewGrid grid);
std::vector<Image> views_of_quilt(const Image& quilt, ViewGrid grid);

/// The views of a quilt of that form which is not in memory: read(band) reads its next rows, from
/// the top.
std::vector<Image> views_of_quilt(const Image& form, ViewGrid grid,
                                  const std::function<void(Image&)>& read);

} // namespace integral

#endif
