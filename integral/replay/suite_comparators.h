// SPDX-License-Identifier: AGPL-3.0-or-later
// The comparison of two frames, with an eye that is moved, in the report of a suite.
#ifndef INTEGRAL_REPLAY_SUITE_COMPARATORS_H
#define INTEGRAL_REPLAY_SUITE_COMPARATORS_H

#include "integral/compare/suite_report.h"

#include <cstddef>

namespace integral {

/// All comparators of a report together have at most this many bytes.
constexpr std::size_t comparators_limit = 32 << 20;

/// Adds a comparator to each pair that failed and can be read, in the order of the report, as long
/// as their pictures' files together are within `limit` bytes; each further pair gets the command
/// that shows it. Reads the pictures again, one pair at a time. To be called after the comparison.
/// Throws Interrupted.
void add_comparators(Suite& suite, std::size_t limit = comparators_limit);

} // namespace integral

#endif
