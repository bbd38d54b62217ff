// SPDX-License-Identifier: AGPL-3.0-or-later
// Limits that the figures of a comparison must not pass.
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
    bool is_most; ///< whether the figure must not exceed its limit; else it must not fall below it
    double least, greatest;  ///< the range of limits that make sense
    const char* value_name;  ///< what stands for the value in the option's help
    const char* explanation; ///< the option's help
};

inline constexpr std::size_t limit_count = 5;
extern const std::array<LimitKind, limit_count> limit_kinds;

/// The limit of each kind; empty where there is none.
using Limits = std::array<std::optional<double>, limit_count>;

/// The figure that a kind limits; empty where a comparison does not have it: the worst micro-image
/// without geometry, all figures where no value is finite in both pictures.
std::optional<double> figure_of(const Comparison& comparison, std::size_t kind);

/// Whether a figure is within a limit.
bool keeps(double figure, std::size_t kind, double limit);

/// The limits that the figures miss, in words: "RMSE 0.2 is greater than 0.19". A figure that the
/// comparison does not have misses no limit. Unequal NaN and infinite values miss any limit.
std::vector<std::string> missed_limits(const Limits& limits, const Comparison& comparison);

} // namespace integral

#endif
