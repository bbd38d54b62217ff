// SPDX-License-Identifier: AGPL-3.0-or-later
// Collects the largest errors that the unit tests measure in a run. They are written as the table
// of doc/numerics.md (`make numerics`); numerics_table.cpp compares them with that table.
#ifndef TESTS_UNIT_NUMERICS_TABLE_H
#define TESTS_UNIT_NUMERICS_TABLE_H

#include <string>

namespace numerics {

/// Records an error in the table's row of `what` and `quantity`. `error` and `allowed` have the
/// same unit: relative, or of a unit vector. The columns: `usual` sheets, and the others by
/// `allowed`: 1e-12, up to 1e-6, up to 0.1 (above that nothing is recorded).
void record(const std::string& what, const std::string& quantity, bool usual, double error,
            double allowed);

} // namespace numerics

#endif
