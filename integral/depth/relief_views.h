// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws the views of a relief from eyes that are spread over a viewing zone, for quilts and panels.
#ifndef INTEGRAL_DEPTH_RELIEF_VIEWS_H
#define INTEGRAL_DEPTH_RELIEF_VIEWS_H

#include "integral/depth/relief_frame.h"
#include "integral/frame/view_grid.h"

#include <vector>

namespace integral {

/// Views by number, and the counts of their lines of sight.
struct ReliefViews {
    std::vector<Image> views;
    ReliefFigures figures;
};

/// The views of eyes, each of `size` pixels and in the form of `form`. A view shows a rectangle of
/// the image plane around the middle, `shown` mm; outside of the relief's pictures it is black.
/// `directions`: numbers of views across and up (directions_of). Throws
/// Interrupted.
ReliefViews views_of_relief(const Relief& relief, const EyeGrid& eyes, ViewGrid directions,
                            Vec2 shown, PixelSize size, const Image& form, int threads,
                            const Progress& progress);

} // namespace integral

#endif
