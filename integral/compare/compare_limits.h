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
    bool is_most; ///< true: a figure above its limit fails; false: one below it fails
    double least, greatest;  ///< the range of valid limits
    const char* value_name;  ///< placeholder of the value in the option's help
    const char* explanation; ///< the option's help
    bool is_share = false;   ///< a share of the pixels: may be given, and is shown, as a percentage
};

inline constexpr std::size_t limit_count = 7;
/// Indices in limit_kinds of the limits for the worst micro-image and for FLIP.
inline constexpr std::size_t micro_image_limit = 4, flip_limit = 6;
extern const std::array<LimitKind, limit_count> limit_kinds;

/// The limit of each kind; empty where there is none.
using Limits = std::array<std::optional<double>, limit_count>;

/// The figure that a kind limits: the eyes' views' if the comparison has them, else the pixels';
/// the micro-images' figure is always of pixels. Empty if the comparison lacks it: the worst
/// micro-image without geometry, FLIP unless requested, all figures if no value is finite in both
/// pictures.
std::optional<double> figure_of(const Comparison& comparison, std::size_t kind);

/// Reads a share of the pixels: "0.1%", or a number without %. Empty if the text is neither.
std::optional<double> share_of(const std::string& text);

/// A figure or limit of that kind in words, with `digits` significant digits: "0.19", "0.1%".
std::string limit_text(std::size_t kind, double value, int digits);

/// Whether a figure is within a limit.
bool keeps(double figure, std::size_t kind, double limit);

/// The limits that the figures miss, in words: "RMSE 0.2 is greater than 0.19". A figure that the
/// comparison lacks misses no limit. Unequal NaN and infinite values miss any limit.
std::vector<std::string> missed_limits(const Limits& limits, const Comparison& comparison);

} // namespace integral

#endif
