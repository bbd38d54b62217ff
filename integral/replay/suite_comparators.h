// SPDX-License-Identifier: AGPL-3.0-or-later
// Adds interactive comparisons of two frames to the report of a suite.
#ifndef INTEGRAL_REPLAY_SUITE_COMPARATORS_H
#define INTEGRAL_REPLAY_SUITE_COMPARATORS_H

#include "integral/compare/suite_report.h"

#include <cstddef>

namespace integral {

/// The pairs' own data for all comparators of a report have at most this many bytes.
constexpr std::size_t comparators_limit = 32 << 20;

/// Adds a comparator to each pair that failed and can be read, in the order of the report, as long
/// as the pairs' data (pictures as text, and geometry) are within `limit` bytes together. Each
/// further pair gets the command that shows its comparison. Reads the pictures again, one pair at a
/// time. To be called after the comparison. Throws Interrupted.
void add_comparators(Suite& suite, std::size_t limit = comparators_limit);

} // namespace integral

#endif
