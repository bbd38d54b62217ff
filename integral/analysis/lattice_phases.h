// SPDX-License-Identifier: AGPL-3.0-or-later
// Searches scales, rotations and places of a lattice together, over a whole scan, so that no part
// of the picture alone decides.
#ifndef INTEGRAL_ANALYSIS_LATTICE_PHASES_H
#define INTEGRAL_ANALYSIS_LATTICE_PHASES_H

#include "integral/analysis/edge_response.h"
#include "integral/analysis/lattice_search.h"

#include <vector>

namespace integral {

/// Range of the changes of a map that are searched, either way.
struct PhaseRange {
    double scale = 0; ///< relative, for each axis
    double turn = 0;  ///< radians
};

/// A map, and the mean edge strength on the borders between micro-images under this map.
struct ScoredMap {
    ScanMap map;
    double edge = 0; ///< less its mean over all shifts of the lattice
};

/// The maps near `base` with the strongest edges on the borders at `points` (mm, on the film that
/// the scan holds), best first, at most `count`. Any two are at least 0.2 apart by lenses_apart.
/// Scales and rotations are tried in steps that move the borders by 1.5 pixels at most: `edges`
/// should be blurred about that far.
std::vector<ScoredMap> strongest_phases(const Plane& edges, const std::vector<Vec2>& points,
                                        const LensSheet& sheet, const ScanMap& base,
                                        const PhaseRange& range, int count, int threads);

/// Distance between the borders of two maps, in lens pitches, ignoring whole cells of the lattice:
/// the root mean square over the corners, sides' middles and centre of a raster of width x height
/// pixels.
double lenses_apart(const LensSheet& sheet, const ScanMap& a, const ScanMap& b, int width,
                    int height);

} // namespace integral

#endif
