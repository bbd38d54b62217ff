// SPDX-License-Identifier: AGPL-3.0-or-later
// Fits parts of a scan separately: for the errors of the whole fit, and to confirm it.
#ifndef INTEGRAL_ANALYSIS_PART_FITS_H
#define INTEGRAL_ANALYSIS_PART_FITS_H

#include "integral/analysis/border_fit.h"

namespace integral {

/// Uncertainty of a fit.
struct FitErrors {
    MapChange deviation{}; ///< standard errors; 0 along directions that are not free
    double across = 0;     ///< of the middle, pixels, across a lenticular sheet's lenses
    int borders = 0;       ///< points that lie in the scan
    bool known = false;    ///< false: too few parts show borders
};

/// Fits each of 8 x 8 parts of the film by itself and measures the scatter of these fits around the
/// change of the map that they have in common. In turn, single parts, rows of parts and columns of
/// parts are taken as independent; the greatest of the three errors counts: a pattern that repeats
/// from lens to lens, such as a far horizon, has the same error in a whole row.
FitErrors errors_of_fit(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                        const ScanMap& map);

/// Parts of the film (of 8 x 8), each compared with a fit made without it.
struct LeftOutParts {
    int parts = 0;    ///< parts that show a lattice by themselves, at any place
    int agreeing = 0; ///< parts that show it where the other parts do, to a seventh of a lens
};

/// Fits the parts on the black squares of a chess board together, and searches each part on a white
/// square by itself over a whole lens; then exchanges black and white.
LeftOutParts check_left_out_parts(const Plane& edges, const std::vector<Vec2>& points,
                                  const LensSheet& sheet, const ScanMap& map);

} // namespace integral

#endif
