// SPDX-License-Identifier: AGPL-3.0-or-later
// The tolerances of a suite of pictures: a JSON file of limits for all files and for some of them.
//
//     { "defaults": { "max_rmse": 0.002, "min_ssim": 0.99 },
//       "files": { "glass/*": { "max_rmse": 0.01 }, "glass/ball.png": { "min_ssim": null } } }
#ifndef INTEGRAL_COMPARE_TOLERANCES_H
#define INTEGRAL_COMPARE_TOLERANCES_H

#include "integral/compare/compare_limits.h"

#include <string>
#include <utility>
#include <vector>

namespace integral {

struct Tolerances {
    Limits defaults;
    /// Limits of the files that a pattern matches. An empty limit, the document's null, lifts one.
    struct Entry {
        std::string pattern;
        int line = 0; ///< where the entry stands in the document, from 1
        std::vector<std::pair<std::size_t, std::optional<double>>> limits; ///< by kind
    };
    std::vector<Entry> entries; ///< in the document's order
};

/// Reads the document. Throws std::invalid_argument, which says the line and what is wrong in it,
/// and the legal words where one is unknown.
Tolerances tolerances_from_json(const std::string& text);

/// Whether a file's name, relative to the suite and with / between folders, is the pattern itself
/// or matches it as a glob: * stands for any characters, also /, ? for one, [a-z] for one of those.
bool matches(const std::string& pattern, const std::string& name);

/// A file's limits: the defaults, changed by every entry that matches, in order, so that later
/// entries take the place of earlier ones. A file without any limit must equal its reference: its
/// largest difference is limited to 0.
Limits limits_for(const Tolerances& tolerances, const std::string& name);

} // namespace integral

#endif
