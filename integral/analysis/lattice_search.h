// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the lattice of a print's micro-images in its scan: rotation, scale and offset.
//
// The spectrum of the scan's edges gives candidates. Each is then fitted: the map from film to scan
// is changed until the borders between micro-images, as the optics predict them, lie on the
// strongest edges (an M-estimator), from the scan's middle outwards and with less and less blur.
// The prediction includes that micro-images lie farther apart than their lenses, so the result is
// the scan's scale by the lenses' pitch.
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
    // Standard errors, by how well the scan's parts (up to 64) agree; with a frame also by how far
    // the edges of the picture itself displaced the fit before most of that was removed:
    bool errors_known = false; ///< false: the fit is at no clear maximum
    Vec2 scale_error; ///< relative, of map.scale; for lenticular sheets one for both, as their scan
                      ///< is assumed to have one scale
    double rotation_error = 0; ///< radians
    Vec2 offset_error; ///< scan pixels, of map.middle; of lenticular sheets only across the lenses
    double contrast = 0; ///< how much stronger edges are on the borders than elsewhere, relative
    double significance = 0; ///< the same compared with random lattices, in standard deviations of
                             ///< those
    int borders = 0;         ///< points of borders that were used
};

/// A scan of less significance has no lattice of these lenses; photographs and noise reach half of
/// it.
constexpr double least_significance = 8;

/// The lattice of the scan; if there is none, its significance is low. Nothing: `progress` stopped
/// it. Throws std::invalid_argument if the scan is too small or too coarse for the sheet.
std::optional<FoundLattice> find_lattice(const Image& scan, const LatticeSearch& search,
                                         int threads = 0, const Progress& progress = {});

/// The same of the scan that messages call `name`. Throws InputError where the lattice is too small
/// or too coarse, or is less significant than least_significance; Interrupted.
FoundLattice find_sure_lattice(const std::string& name, const Image& scan,
                               const LatticeSearch& search, int threads, const Progress& progress);

} // namespace integral

#endif
