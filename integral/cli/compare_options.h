// SPDX-License-Identifier: AGPL-3.0-or-later
// The options of integral compare.
#ifndef INTEGRAL_CLI_COMPARE_OPTIONS_H
#define INTEGRAL_CLI_COMPARE_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/cli/thread_options.h"
#include "integral/compare/compare_limits.h"
#include "integral/compare/comparison_rules.h"

#include <array>

namespace integral {

struct CompareOptions : CommonOptions {
    std::optional<std::string> output, gain, sheet, flip_map, ppd, channel_tolerance, mask, html;
    std::optional<Arguments> ignore, weight, eyes;
    bool json = false, flip = false, seen = false;
    std::array<std::optional<std::string>, limit_count> limits; ///< in the order of limit_kinds
    // With --suite:
    std::optional<std::string> suite, references, tolerances, junit, summary;
    std::optional<Arguments> accept;
    bool create = false, approve = false, no_browser = false;
    std::optional<int> port;
    ThreadOptions threads;
};

/// Adds the options of `integral compare`.
void declare(options::options_description& all, CompareOptions& o);

/// The limits on the line. Throws UsageError.
Limits limits_of(const CompareOptions& o);

/// Applies the line's options to `rules`. Throws UsageError.
void change_rules(ComparisonRules& rules, const CompareOptions& o, const Limits& limits);

/// Compares the pictures of two folders, or accepts some. Returns an ExitStatus.
int run_suite(const CompareOptions& o);

} // namespace integral

#endif
