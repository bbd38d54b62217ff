// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds candidates for the rotation and scale of the lattice of micro-images from the spectrum of a
// scan's edges.
#ifndef INTEGRAL_ANALYSIS_LATTICE_CANDIDATES_H
#define INTEGRAL_ANALYSIS_LATTICE_CANDIDATES_H

#include "integral/analysis/lattice_search.h"
#include "integral/analysis/spectrum.h"

#include <vector>

namespace integral {

/// A map from film to scan, and the evidence for it.
struct LatticeCandidate {
    ScanMap map;
    double score = 0; ///< higher where the spectrum is stronger at the lattice's frequencies
};

/// The three likeliest rotations and scales in the range of the search, best first. `about` is
/// search.about in pixels of the spectrum's plane; the candidates have its middle.
std::vector<LatticeCandidate> candidates_of(const Spectrum& spectrum, const LatticeSearch& search,
                                            const ScanMap& about);

} // namespace integral

#endif
