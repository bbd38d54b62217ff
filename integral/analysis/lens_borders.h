// SPDX-License-Identifier: AGPL-3.0-or-later
// Where on a film the borders of its micro-images are.
#ifndef INTEGRAL_ANALYSIS_LENS_BORDERS_H
#define INTEGRAL_ANALYSIS_LENS_BORDERS_H

#include "integral/optics/lens_mapping.h"

#include <vector>

namespace integral {

/// Points (mm, sheet frame) spread over the borders of the micro-images within `half` (mm, each way
/// from the sheet's centre), from the optics themselves: the places along the rows and the columns
/// of a raster where the lens changes that a film point belongs to; the middle of a dark gap that
/// is narrower than `step`, both sides of a wider one. At most about `most` points. step > 0.
std::vector<Vec2> lens_borders(const SheetOptics& optics, LensMapping mapping, Vec2 half,
                               double step, int most, int threads);

/// The same on the film of a frame, whose pixels are of one lens each: the edges between the pixels
/// of different lenses, and of dark ones.
std::vector<Vec2> lens_borders_of_pixels(const SheetOptics& optics, LensMapping mapping,
                                         const Film& film, int most, int threads);

} // namespace integral

#endif
