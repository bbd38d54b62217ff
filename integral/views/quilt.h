// SPDX-License-Identifier: AGPL-3.0-or-later
// Quilts: the views of a grid in one picture, in the order of the Looking Glass quilt standard
// (lookingglassfactory.com/tutorial/what-is-a-quilt). The bottom left tile is view 0, from the far
// left; the top right tile is the last view, from the far right (for lenses that lie across: from
// below, and from above).
#ifndef INTEGRAL_VIEWS_QUILT_H
#define INTEGRAL_VIEWS_QUILT_H

#include "integral/frame/image.h"
#include "integral/frame/quilt_name.h"
#include "integral/frame/view_grid.h"

#include <functional>
#include <vector>

namespace integral {

/// Combines grid.count() views of one size and form, by number, to one picture; views_of_quilt is
/// the inverse. A quilt has at least a pixel for each view. If its sides are no multiples of the
/// grid's (some displays use 5 x 9 views in 4096 x 4096 pixels), the unused pixels are at the right
/// and at the top. Throws std::invalid_argument as `tiled` does.
Image quilt_of_views(std::vector<Image> views, ViewGrid grid);
std::vector<Image> views_of_quilt(const Image& quilt, ViewGrid grid);

/// The views of a quilt that is not in memory. `form`: its size and sample type. read(band) fills
/// the band with the quilt's next rows, from the top on.
std::vector<Image> views_of_quilt(const Image& form, ViewGrid grid,
                                  const std::function<void(Image&)>& read);

} // namespace integral

#endif
