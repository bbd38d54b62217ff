// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lattice_search.h"

#include "integral/base/constants.h"
#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"

namespace integral {
namespace {

/// A map in a message: "600.1 x 600.3 dpi, turned 0.12 degrees, its middle at 612.0, 409.9"
std::string described(const ScanMap& map)
{
    return with_decimals(mm_per_inch * map.scale.x, 1) + " x " +
           with_decimals(mm_per_inch * map.scale.y, 1) + " dpi, turned " +
           with_decimals(map.rotation / radians_per_degree, 2) + " degrees, its middle at " +
           with_decimals(map.middle.x, 1) + "," + with_decimals(map.middle.y, 1);
}

/// Throws InputError if a second lattice fits as well, or if the scan's parts are too few or
/// disagree.
void check_agreement(const std::string& input, const LatticeSearch& search,
                     const FoundLattice& found)
{
    const std::string help = search.frame
                                 ? "; scan more of the print, or finer, and check --pitch"
                                 : "; give the printed frame as --sheet with --middle, scan more "
                                   "of the print, and check --pitch";
    if (found.rival_share > most_rival_share)
        throw InputError(input + ": two lattices fit it equally well (the second has " +
                         with_decimals(100 * found.rival_share, 0) +
                         "% of the first one's edge): " + described(found.map) + ", and " +
                         described(found.rival) + help);
    if (found.parts < fewest_parts)
        throw InputError(input + ": only " + std::to_string(found.parts) +
                         " parts of it show borders between micro-images by themselves, and " +
                         std::to_string(fewest_parts) + " are required to check " +
                         described(found.map) + help);
    if (found.agreeing_parts < least_agreement * found.parts)
        throw InputError(input + ": its parts disagree: " + std::to_string(found.agreeing_parts) +
                         " of " + std::to_string(found.parts) +
                         " show by themselves the lattice of the others (" + described(found.map) +
                         ")" + help);
}

} // namespace

FoundLattice find_sure_lattice(const std::string& input, const Image& scan,
                               const LatticeSearch& search, int threads, const Progress& progress)
{
    std::optional<FoundLattice> found;
    try {
        found = find_lattice(scan, search, threads, progress);
    } catch (const std::invalid_argument& error) {
        throw InputError(input + ": " + error.what());
    }
    if (!found)
        throw Interrupted();
    if (!(found->significance >= least_significance))
        throw InputError(input + ": no micro-images of lenses " +
                         with_digits(search.sheet.pitch, 6) +
                         " mm apart are found in it, within 4% of " +
                         with_digits(mm_per_inch * search.about.scale.x, 6) +
                         " dpi and 10 degrees of upright (the likeliest stand out by " +
                         with_decimals(found->significance, 1) + " deviations, " +
                         with_decimals(least_significance, 0) +
                         " are required); check --pitch, --scan-dpi and --turn");
    check_agreement(input, search, *found);
    return *found;
}

} // namespace integral
