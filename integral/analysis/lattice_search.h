// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the lattice of a print's micro-images in its scan: rotation, scale and offset.
//
// The spectrum of the scan's edges gives candidates, to a lens or so over the whole scan. Around
// each, all scales, turns and places of the lattice are compared by the edge that the whole picture
// shows on the borders between micro-images, as the optics predict them: what repeats from lens to
// lens, such as a horizon, has edges too, but not along all borders, and they drift. The strongest
// few are fitted (an M-estimator), from the scan's middle outwards and with less and less blur. The
// prediction includes that micro-images lie farther apart than their lenses, so the result is the
// scan's scale by the lenses' pitch.
#ifndef INTEGRAL_ANALYSIS_LATTICE_SEARCH_H
#define INTEGRAL_ANALYSIS_LATTICE_SEARCH_H

#include "integral/analysis/scan_map.h"
#include "integral/base/parallel.h"
#include "integral/lightfield/frame_metadata.h"
#include "integral/lightfield/image.h"

namespace integral {

/// What is known before the search.
struct LatticeSearch {
    LensSheet sheet;
    Aperture aperture;
    LensMapping mapping = LensMapping::automatic;
    std::optional<Film> frame; ///< the film of the frame that was printed, if it is known and
                               ///< about.middle is the middle of that frame
    ScanMap about; ///< where to search: the middle to half a lens, or any if which lens does not
                   ///< matter
    double scale_range = 0.04;  ///< either way, relative
    double turn_range = 0.1745; ///< either way, radians
};

struct FoundLattice {
    ScanMap map;
    // Standard errors, by how the scan's parts, each fitted by itself, scatter, and by how far the
    // edges of the picture itself displaced the fit before most of that was removed:
    bool errors_known = false; ///< false: too few parts show borders; the errors are 0
    Vec2 scale_error; ///< relative, of map.scale; for lenticular sheets one for both, as their scan
                      ///< is assumed to have one scale
    double rotation_error = 0; ///< radians
    Vec2 offset_error; ///< scan pixels, of map.middle; of lenticular sheets only across the lenses
    double contrast = 0; ///< how much stronger edges are on the borders than elsewhere, relative
    double significance = 0; ///< the same compared with random lattices, in standard deviations of
                             ///< those
    int borders = 0;         ///< points of borders that were used
    double rival_share = 0;  ///< edge of the next best lattice, relative; 0: there is none
    ScanMap rival;           ///< that lattice
    int parts = 0;           ///< of the scan, that show a lattice by themselves
    int agreeing_parts = 0;  ///< that show this one, as fitted without them
};

/// A scan of less significance has no lattice of these lenses; photographs and noise reach half of
/// it.
constexpr double least_significance = 8;
/// Two lattices fit the scan equally well where the share of the weaker one is above this.
constexpr double most_rival_share = 0.8;
/// At least this share of the parts must agree with a fit in which they had no share.
constexpr double least_agreement = 0.5;
constexpr int fewest_parts = 4; ///< without which agreement means little

/// The lattice of the scan; if there is none, its significance is low. Nothing: `progress` stopped
/// it. Throws std::invalid_argument if the scan is too small or too coarse for the sheet.
std::optional<FoundLattice> find_lattice(const Image& scan, const LatticeSearch& search,
                                         int threads = 0, const Progress& progress = {});

/// The same of the scan that messages call `name`. Throws InputError where the lattice is too small
/// or too coarse, where no lattice stands out, where two fit equally well or where the scan's parts
/// disagree; Interrupted.
FoundLattice find_sure_lattice(const std::string& name, const Image& scan,
                               const LatticeSearch& search, int threads, const Progress& progress);

} // namespace integral

#endif
