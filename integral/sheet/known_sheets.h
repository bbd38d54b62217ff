// SPDX-License-Identifier: AGPL-3.0-or-later
// The lens sheets with names: the thesis's and common commercial ones.
#ifndef INTEGRAL_SHEET_KNOWN_SHEETS_H
#define INTEGRAL_SHEET_KNOWN_SHEETS_H

#include "integral/optics/lens_sheet.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// A sheet with a macro in include/integral.inc, Integral_Sheet_NAME().
struct KnownSheet {
    const char* name;
    LensSheet sheet;
    bool of_thesis = false; ///< Appendix E; else a nominal commercial one, named by its lenses per
                            ///< inch
};

/// The thesis's sheets in the order of its Appendix E, then the commercial ones from coarse to
/// fine. A test compares them with include/integral.inc.
const std::vector<KnownSheet>& known_sheets();

/// The thesis's sheets alone: one lenticular, four square.
std::vector<LensSheet> thesis_sheets();

/// The commercial sheet sold with that many lenses per inch, to half a per cent; empty for other
/// numbers.
std::optional<LensSheet> sheet_of_lpi(double lenses_per_inch);

} // namespace integral

#endif
