// SPDX-License-Identifier: AGPL-3.0-or-later
// Lays foretold borders of micro-images on a scan's edges.
#ifndef INTEGRAL_ANALYSIS_BORDER_FIT_H
#define INTEGRAL_ANALYSIS_BORDER_FIT_H

#include "integral/analysis/edge_response.h"
#include "integral/analysis/scan_map.h"
#include "integral/optics/lens_sheet.h"

#include <array>
#include <vector>

namespace integral {

/// What of a ScanMap can be changed: the logarithms of both scales, the rotation, the middle's x
/// and y.
using MapChange = std::array<double, 5>;

/// The directions in which a sheet lets its map be found: all five; for a lenticular sheet both
/// scales together, the rotation, and the middle across the lenses.
std::vector<MapChange> free_directions(const LensSheet& sheet, const ScanMap& map);

ScanMap changed(const ScanMap& map, const MapChange& change);

/// The mean edge on the borders of `points` (mm) less the whole plane's; points that lie outside
/// count as that.
double edge_on_borders(const Plane& edges, const std::vector<Vec2>& points, const ScanMap& map);

/// The map near `map` with the most edge on the borders, by damped Newton steps.
ScanMap fit_borders(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                    ScanMap map);

/// Those points in whose part of the film (16 x 16) a fit's borders do show: no margins of paper,
/// no blank parts.
std::vector<Vec2> where_borders_show(const Plane& edges, const std::vector<Vec2>& points,
                                     const LensSheet& sheet, const ScanMap& map);

/// How sure a fit is.
struct FitErrors {
    MapChange deviation{}; ///< standard errors; 0 for what is not free
    double across = 0;     ///< of the middle, pixels, across a lenticular sheet's lenses
    int borders = 0;       ///< points that lie in the scan
    bool known = false; ///< false: the fit is at no clear maximum, and the deviations say nothing
};

/// At the optimum, from how 8 x 8 parts of the film agree: the sandwich of the Hessian and the
/// parts' gradients.
FitErrors errors_of_fit(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                        const ScanMap& map);

} // namespace integral

#endif
