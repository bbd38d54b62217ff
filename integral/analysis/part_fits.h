// SPDX-License-Identifier: AGPL-3.0-or-later
// Fits the parts of a scan, each by itself: for the errors of the whole fit, and to confirm it.
#ifndef INTEGRAL_ANALYSIS_PART_FITS_H
#define INTEGRAL_ANALYSIS_PART_FITS_H

#include "integral/analysis/border_fit.h"

namespace integral {

/// How sure a fit is.
struct FitErrors {
    MapChange deviation{}; ///< standard errors; 0 for what is not free
    double across = 0;     ///< of the middle, pixels, across a lenticular sheet's lenses
    int borders = 0;       ///< points that lie in the scan
    bool known = false;    ///< false: too few parts show borders
};

/// Fits each of 8 x 8 parts of the film by itself and measures how far they scatter around the
/// changes of the map that they have in common. Parts, rows of parts and columns of parts are taken
/// as independent in turn, and the greatest error counts: what repeats from lens to lens, such as a
/// far horizon, errs alike in a whole row.
FitErrors errors_of_fit(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                        const ScanMap& map);

/// Parts of the film (of 8 x 8) that have no share in a fit.
struct LeftOutParts {
    int parts = 0;    ///< that show a lattice by themselves, wherever
    int agreeing = 0; ///< that show it where the other parts do, to a seventh of a lens
};

/// Fits every other part, as on a chess board, and searches each of the rest by itself over a whole
/// lens.
LeftOutParts check_left_out_parts(const Plane& edges, const std::vector<Vec2>& points,
                                  const LensSheet& sheet, const ScanMap& map);

} // namespace integral

#endif
