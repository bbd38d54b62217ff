// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds pictures of a suite that were renamed.
#ifndef INTEGRAL_COMPARE_SUITE_RENAMES_H
#define INTEGRAL_COMPARE_SUITE_RENAMES_H

#include "integral/compare/suite_report.h"

namespace integral {

/// Adds to the faults of each missing result the name of a result without a reference that has the
/// same pixels, and the other way round. Reads only pictures without a counterpart. To be called
/// after the comparison.
void note_renames(Suite& suite);

} // namespace integral

#endif
