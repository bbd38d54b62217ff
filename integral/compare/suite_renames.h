// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds pictures of a suite that were renamed.
#ifndef INTEGRAL_COMPARE_SUITE_RENAMES_H
#define INTEGRAL_COMPARE_SUITE_RENAMES_H

#include "integral/compare/suite_report.h"

namespace integral {

/// Finds results without a reference that have the pixels of the reference of a missing result, and
/// adds each one's name to the other's faults. Reads only pictures without a counterpart. To be
/// called after the comparison.
void note_renames(Suite& suite);

} // namespace integral

#endif
