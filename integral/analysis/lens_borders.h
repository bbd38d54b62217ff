// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the borders of the micro-images on a film.
#ifndef INTEGRAL_ANALYSIS_LENS_BORDERS_H
#define INTEGRAL_ANALYSIS_LENS_BORDERS_H

#include "integral/optics/lens_mapping.h"

#include <vector>

namespace integral {

/// Points (mm, sheet frame) on the borders of the micro-images, within `half` (mm) of the sheet's
/// centre each way, computed from the optics. Lines along rows and columns are followed in steps of
/// `step` (mm, > 0), as far from each other as gives about `most` points. Where the lens changes
/// between two steps, the exact place is found. A dark gap between lenses gives its middle if it is
/// narrower than `step`, else both its sides.
std::vector<Vec2> lens_borders(const SheetOptics& optics, LensMapping mapping, Vec2 half,
                               double step, int most, int threads);

/// The borders on a frame's film, where each pixel belongs to one lens or is dark: the edges
/// between pixels of different lenses, or between lit and dark ones.
std::vector<Vec2> lens_borders_of_pixels(const SheetOptics& optics, LensMapping mapping,
                                         const Film& film, int most, int threads);

} // namespace integral

#endif
