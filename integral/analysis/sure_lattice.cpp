// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lattice_search.h"

#include "integral/base/constants.h"
#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"

namespace integral {

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
                         " are wanted); check --pitch, --scan-dpi and --turn");
    return *found;
}

} // namespace integral
