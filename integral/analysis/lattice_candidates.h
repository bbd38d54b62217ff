// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds by the spectrum of a scan's edges at which rotation and scale the lattice of the
// micro-images may lie.
#ifndef INTEGRAL_ANALYSIS_LATTICE_CANDIDATES_H
#define INTEGRAL_ANALYSIS_LATTICE_CANDIDATES_H

#include "integral/analysis/lattice_search.h"
#include "integral/analysis/spectrum.h"

#include <vector>

namespace integral {

/// A map from film to scan, and the evidence for it.
struct LatticeCandidate {
    ScanMap map;
    double score = 0; ///< the higher, the stronger the spectrum at the lattice's frequencies
};

/// The three likeliest rotations and scales in the range of the search, best first. `about` is
/// search.about in pixels of the plane that the spectrum is of; the candidates have its middle.
std::vector<LatticeCandidate> candidates_of(const Spectrum& spectrum, const LatticeSearch& search,
                                            const ScanMap& about);

} // namespace integral

#endif
