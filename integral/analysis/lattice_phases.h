// SPDX-License-Identifier: AGPL-3.0-or-later
// Searches scales, turns and places of a lattice together, over a whole scan, so that no part of
// the picture alone decides.
#ifndef INTEGRAL_ANALYSIS_LATTICE_PHASES_H
#define INTEGRAL_ANALYSIS_LATTICE_PHASES_H

#include "integral/analysis/edge_response.h"
#include "integral/analysis/lattice_search.h"

#include <vector>

namespace integral {

/// Changes of a map that are searched, either way.
struct PhaseRange {
    double scale = 0; ///< relative, of each axis by itself
    double turn = 0;  ///< radians
};

/// A map and the mean edge on the borders between micro-images under it.
struct ScoredMap {
    ScanMap map;
    double edge = 0; ///< less the mean over all places of the lattice
};

/// The maps near `base` with the most edge on the borders at `points` (mm, on the film that the
/// scan holds), best first, at most `count`. Any two put the borders at least a seventh of a lens
/// apart somewhere in the scan. Scales and turns are tried in steps that move the borders by 1.5
/// pixels at most: `edges` should be blurred about that far.
std::vector<ScoredMap> strongest_phases(const Plane& edges, const std::vector<Vec2>& points,
                                        const LensSheet& sheet, const ScanMap& base,
                                        const PhaseRange& range, int count, int threads);

/// How far apart two maps put the borders, in lenses: the greatest distance over the corners and
/// the middle of a raster of these pixels. Whole lenses do not count.
double lenses_apart(const LensSheet& sheet, const ScanMap& a, const ScanMap& b, int width,
                    int height);

} // namespace integral

#endif
