// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the lattice of a print's micro-images in its scan: rotation, scale and offset.
//
// A coarse place comes from the spectrum of the scan's edges. Then the map from film to scan is
// sought under which the borders between micro-images, as the optics foretell them, lie on the most
// edge (an M-estimator), from the scan's middle outwards and from a wide blur to a narrow one. So
// what is fitted is the micro-images' own pitch, displaced outwards as they are, and what comes out
// is the scan's scale on the lenses' pitch.
#ifndef INTEGRAL_ANALYSIS_LATTICE_SEARCH_H
#define INTEGRAL_ANALYSIS_LATTICE_SEARCH_H

#include "integral/analysis/scan_map.h"
#include "integral/base/parallel.h"
#include "integral/lightfield/frame_metadata.h"
#include "integral/lightfield/image.h"

namespace integral {

/// What is known beforehand.
struct LatticeSearch {
    LensSheet sheet;
    Aperture aperture;
    LensMapping mapping = LensMapping::automatic;
    std::optional<Film> frame; ///< the film of the frame that was printed, where it is known and
                               ///< about.middle is that frame's
    ScanMap about; ///< roughly: the middle to half a lens, or any place if that does not matter
    double scale_range = 0.04;  ///< either way, relative
    double turn_range = 0.1745; ///< either way, radians
};

struct FoundLattice {
    ScanMap map;
    // Standard errors: from how the scan's parts agree (up to 64), and, with a frame, how far the
    // picture's own edges pulled before what could be told of their pull was removed:
    bool errors_known = false; ///< false: the fit is at no clear maximum
    Vec2 scale_error; ///< relative, of map.scale; equal for lenticular sheets, whose scan is taken
                      ///< to have one scale
    double rotation_error = 0; ///< radians
    Vec2 offset_error; ///< scan pixels, of map.middle; of lenticular sheets only across the lenses
    double contrast = 0; ///< how much more edge there is on the borders than elsewhere, relative
    double significance = 0; ///< the same against lattices laid at random, in their standard
                             ///< deviations
    int borders = 0;         ///< points of borders that were used
};

/// Below this there is no lattice: photographs and noise reach half of it.
constexpr double least_significance = 8;

/// Throws std::invalid_argument with a sentence where the scan is too small or too coarse for the
/// sheet; a lattice that is not there comes back with little significance. Nothing: `progress`
/// stopped it.
std::optional<FoundLattice> find_lattice(const Image& scan, const LatticeSearch& search,
                                         int threads = 0, const Progress& progress = {});

} // namespace integral

#endif
