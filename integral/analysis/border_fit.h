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

/// Change of a ScanMap: the logarithms of both scales, the rotation, and the middle's x and y.
using MapChange = std::array<double, 5>;

/// The changes that a sheet's borders determine: all five; for a lenticular sheet both scales
/// together, the rotation, and the middle across the lenses.
std::vector<MapChange> free_directions(const LensSheet& sheet, const ScanMap& map);

/// The map after a change.
ScanMap changed(const ScanMap& map, const MapChange& change);

/// Mean edge strength at the border points `points` (mm), less the plane's mean. Points outside the
/// scan count as the plane's mean.
double edge_on_borders(const Plane& edges, const std::vector<Vec2>& points, const ScanMap& map);

/// The map near `map` with the greatest edge strength on the borders, by damped Newton steps.
ScanMap fit_borders(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                    ScanMap map);

/// Fits like fit_borders, with the ratio of both scales fixed.
ScanMap fit_borders_with_ratio(const Plane& edges, const std::vector<Vec2>& points, ScanMap map);

/// Divides the film into 16 x 16 parts, and returns the points in the parts where borders show
/// under this map. Parts with blank paper or uniform areas of the picture are left out.
std::vector<Vec2> where_borders_show(const Plane& edges, const std::vector<Vec2>& points,
                                     const LensSheet& sheet, const ScanMap& map);

} // namespace integral

#endif
