// SPDX-License-Identifier: AGPL-3.0-or-later
// Fits a scan's map so that the borders of the micro-images, as the optics predict them, lie on the
// scan's edges.
#ifndef INTEGRAL_ANALYSIS_BORDER_FIT_H
#define INTEGRAL_ANALYSIS_BORDER_FIT_H

#include "integral/analysis/edge_response.h"
#include "integral/analysis/scan_map.h"
#include "integral/optics/lens_sheet.h"

#include <array>
#include <vector>

namespace integral {

/// A change of a ScanMap: of the logarithms of both scales, of the rotation, and of the middle's x
/// and y.
using MapChange = std::array<double, 5>;

/// The changes that a sheet's borders can tell: all five; of a lenticular sheet both scales
/// together, the rotation, and the middle across the lenses.
std::vector<MapChange> free_directions(const LensSheet& sheet, const ScanMap& map);

/// The map after a change.
ScanMap changed(const ScanMap& map, const MapChange& change);

/// The mean edge at `points` (mm) on borders, less the mean of the whole plane. Points outside the
/// scan count as that mean.
double edge_on_borders(const Plane& edges, const std::vector<Vec2>& points, const ScanMap& map);

/// The map near `map` with the most edge on the borders, by damped Newton steps.
ScanMap fit_borders(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                    ScanMap map);

/// The same with the ratio of both scales kept.
ScanMap fit_borders_with_ratio(const Plane& edges, const std::vector<Vec2>& points, ScanMap map);

/// The points in those parts of the film (16 x 16) in which the borders show under this map: not
/// where there is blank paper or an even picture.
std::vector<Vec2> where_borders_show(const Plane& edges, const std::vector<Vec2>& points,
                                     const LensSheet& sheet, const ScanMap& map);

} // namespace integral

#endif
