// SPDX-License-Identifier: AGPL-3.0-or-later
// The tolerances of a suite of pictures: a JSON file of limits for all files and for some of them.
//
//     { "defaults": { "max_rmse": 0.002, "min_ssim": 0.99 },
//       "files": { "glass/*": { "max_rmse": 0.01, "ignore": ["0,0,100x20"] },
//                  "glass/ball.png": { "min_ssim": null, "mask": "ball-mask.png" } } }
#ifndef INTEGRAL_COMPARE_TOLERANCES_H
#define INTEGRAL_COMPARE_TOLERANCES_H

#include "integral/compare/compare_limits.h"
#include "integral/compare/comparison_rules.h"
#include "integral/compare/seen.h"

#include <string>
#include <utility>
#include <vector>

namespace integral {

/// Changes that an object of the document makes.
struct ToleranceChanges {
    /// Limits by kind. An empty one (null in the document) removes a limit.
    std::vector<std::pair<std::size_t, std::optional<double>>> limits;
    std::optional<double> channel_tolerance, ppd;
    std::vector<Region> regions;     ///< these add up
    std::optional<std::string> mask; ///< relative to the document's folder
    std::optional<bool> seen;
    std::optional<SeenEyes> eyes;
};

struct Tolerances {
    Limits defaults;
    ComparisonRules default_rules;
    /// Changes for the files that a pattern matches.
    struct Entry : ToleranceChanges {
        std::string pattern;
        int line = 0; ///< the entry's line in the document, from 1
    };
    std::vector<Entry> entries; ///< in the document's order
};

/// Reads the document. Throws std::invalid_argument with the line, its error and, for an unknown
/// word, the legal words.
Tolerances tolerances_from_json(const std::string& text);

/// Whether a file's name, relative to the suite and with / between folders, is the pattern itself
/// or matches it as a glob: * stands for any characters, also /, ? for one, [a-z] for one of those.
bool matches(const std::string& pattern, const std::string& name);

/// A file's limits: the defaults, changed by every entry that matches, in order, so that later
/// entries take the place of earlier ones. A file without any limit must equal its reference: its
/// largest difference is limited to 0.
Limits limits_for(const Tolerances& tolerances, const std::string& name);

/// Rules for comparing a file: the defaults with the changes of every entry that matches, in order.
/// FLIP is computed if the file has a limit for it, or if the defaults enable it. Paths of masks
/// are relative to the document's folder.
ComparisonRules rules_for(const Tolerances& tolerances, const std::string& name);

} // namespace integral

#endif
