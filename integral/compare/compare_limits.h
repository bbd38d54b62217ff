// SPDX-License-Identifier: AGPL-3.0-or-later
// Limits that the figures of a comparison have to keep.
#ifndef INTEGRAL_COMPARE_COMPARE_LIMITS_H
#define INTEGRAL_COMPARE_COMPARE_LIMITS_H

#include "integral/compare/compare.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// One figure that can be limited.
struct LimitKind {
    const char* word; ///< in files of tolerances: max_rmse; as an option: --max-rmse
    const char* name; ///< in messages
    bool is_most;     ///< the figure must not exceed its limit; else it must not fall below it
    double least, greatest; ///< limits that make sense
    const char* value_name; ///< the option's, in its help
    const char* explanation;
};

inline constexpr std::size_t limit_count = 5;
extern const std::array<LimitKind, limit_count> limit_kinds;

/// The limit of each kind, where there is one.
using Limits = std::array<std::optional<double>, limit_count>;

/// The figure that a kind limits; none where a comparison has none: the worst micro-image, without
/// geometry.
std::optional<double> figure_of(const Comparison& comparison, std::size_t kind);

/// Whether a figure keeps a limit. NaN keeps none.
bool keeps(double figure, std::size_t kind, double limit);

/// The limits that the figures miss, in words: "RMSE 0.2 is greater than 0.19". A figure that is
/// not there misses none.
std::vector<std::string> missed_limits(const Limits& limits, const Comparison& comparison);

} // namespace integral

#endif
