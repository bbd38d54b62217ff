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
    /// Limits of the files that match; the document's null lifts one.
    struct Entry {
        std::string pattern;
        int line = 0; ///< of the document, from 1
        std::vector<std::pair<std::size_t, std::optional<double>>> limits; ///< by kind
    };
    std::vector<Entry> entries; ///< in the document's order
};

/// Reads the document. Throws std::invalid_argument: "line 3: " and what is wrong there, with the
/// legal words for an unknown one.
Tolerances tolerances_from_json(const std::string& text);

/// Whether a file's name, relative to the suite and with / between folders, is the pattern or
/// matches it as a glob: * any characters (/ too), ? one, [a-z] one of those.
bool matches(const std::string& pattern, const std::string& name);

/// A file's limits: the defaults, then every entry that matches, in order, a later one over an
/// earlier one. A file that is left without any must equal its reference: its largest difference is
/// limited to 0.
Limits limits_for(const Tolerances& tolerances, const std::string& name);

} // namespace integral

#endif
