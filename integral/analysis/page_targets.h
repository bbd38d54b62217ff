// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the four targets of a calibration page in a photograph, at any angle: a black dot within a
// white ring within a black disc.
#ifndef INTEGRAL_ANALYSIS_PAGE_TARGETS_H
#define INTEGRAL_ANALYSIS_PAGE_TARGETS_H

#include "integral/analysis/edge_response.h"

#include <array>

namespace integral {

/// Middles of the targets (photo pixels, to about half a pixel), clockwise, beginning with the one
/// that has the largest dot. Throws std::invalid_argument, with advice, if the photo shows fewer
/// targets, or more.
std::array<Vec2, 4> find_page_targets(const Plane& photo);

} // namespace integral

#endif
