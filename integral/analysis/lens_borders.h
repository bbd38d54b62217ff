// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the borders of the micro-images on a film.
#ifndef INTEGRAL_ANALYSIS_LENS_BORDERS_H
#define INTEGRAL_ANALYSIS_LENS_BORDERS_H

#include "integral/optics/lens_mapping.h"

#include <vector>

namespace integral {

/// Points (mm, sheet frame) spread over the borders of the micro-images within `half` (mm, each way
/// from the sheet's centre), as the optics give them: the places along the rows and the columns of
/// a raster of `step` (mm) where film points begin to belong to another lens. A dark gap between
/// lenses gives its middle if it is narrower than `step`, else both its sides. At most about `most`
/// points. step > 0.
std::vector<Vec2> lens_borders(const SheetOptics& optics, LensMapping mapping, Vec2 half,
                               double step, int most, int threads);

/// The borders on a frame's film, where each pixel belongs to one lens or is dark: the edges
/// between pixels of different lenses, or between lit and dark ones.
std::vector<Vec2> lens_borders_of_pixels(const SheetOptics& optics, LensMapping mapping,
                                         const Film& film, int most, int threads);

} // namespace integral

#endif
