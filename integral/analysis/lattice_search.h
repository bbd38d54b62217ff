// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the lattice of a print's micro-images in its scan: rotation, scale and offset.
//
// The spectrum of the scan's edges gives candidates that are right to about a lens over the whole
// scan. Around each candidate, all scales, rotations and places of the lattice are compared by the
// edge strength on the borders between micro-images, as the optics predict them, over the whole
// picture. A pattern that repeats from lens to lens, such as a horizon, has edges too, but not
// along all borders, and its edges drift away from them. The maps with the strongest edges are
// fitted (an M-estimator), from the scan's middle outwards and with less and less blur. The
// prediction includes that micro-images lie farther apart than their lenses, so the result is the
// scan's scale relative to the lenses' pitch.
#ifndef INTEGRAL_ANALYSIS_LATTICE_SEARCH_H
#define INTEGRAL_ANALYSIS_LATTICE_SEARCH_H

#include "integral/analysis/scan_map.h"
#include "integral/base/parallel.h"
#include "integral/frame/frame_metadata.h"
#include "integral/frame/image.h"

namespace integral {

/// Inputs of the search.
struct LatticeSearch {
    LensSheet sheet;
    Aperture aperture;
    LensMapping mapping = LensMapping::automatic;
    std::optional<Film> frame; ///< film of the printed frame, if it is known and about.middle is
                               ///< the middle of that frame
    ScanMap about; ///< where to search; to find the right lens, its middle must be right to half a
                   ///< lens
    double scale_range = 0.04;  ///< either way, relative
    double turn_range = 0.1745; ///< either way, radians
};

struct FoundLattice {
    ScanMap map;
    // Standard errors. They combine the scatter of separate fits to the scan's parts with the
    // displacement of the fit by the picture's own edges before most of it was removed:
    bool errors_known = false; ///< false: too few parts show borders; the errors are 0
    Vec2 scale_error; ///< relative, of map.scale; equal for lenticular sheets, whose scan is
                      ///< assumed to have one scale
    double rotation_error = 0; ///< radians
    Vec2 offset_error;       ///< scan pixels, of map.middle; across the lenses only, if lenticular
    double contrast = 0;     ///< relative excess of edge strength on the borders over the scan's
                             ///< mean
    double significance = 0; ///< excess over the mean for random lattices, in standard deviations
                             ///< of these lattices
    int borders = 0;         ///< number of border points used
    double rival_share = 0;  ///< relative edge strength of the next best lattice; 0: none
    ScanMap rival;           ///< that lattice
    int parts = 0;           ///< parts of the scan that show a lattice by themselves
    int agreeing_parts = 0;  ///< parts of these that show this lattice, fitted without them
};

/// A scan below this significance shows no lattice of these lenses. Photographs and noise reach
/// half of it.
constexpr double least_significance = 8;
/// Two lattices fit the scan equally well if the weaker one's share is above this.
constexpr double most_rival_share = 0.8;
/// Minimum share of the parts that must agree with a fit made without them.
constexpr double least_agreement = 0.5;
constexpr int fewest_parts = 4; ///< with fewer, agreement means little

/// Finds the lattice of the scan; if there is none, its significance is low. Returns nothing if
/// `progress` stopped it. Throws std::invalid_argument if the scan is too small or too coarse for
/// the sheet.
std::optional<FoundLattice> find_lattice(const Image& scan, const LatticeSearch& search,
                                         int threads = 0, const Progress& progress = {});

/// Calls find_lattice; messages call the scan `name`. Throws InputError if the scan is too small or
/// too coarse, if no lattice stands out, if two fit equally well, or if the scan's parts are too
/// few or disagree; Interrupted.
FoundLattice find_sure_lattice(const std::string& name, const Image& scan,
                               const LatticeSearch& search, int threads, const Progress& progress);

} // namespace integral

#endif
