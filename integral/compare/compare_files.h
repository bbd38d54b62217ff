// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares two pictures while they are read, and writes their difference and FLIP map.
#ifndef INTEGRAL_COMPARE_COMPARE_FILES_H
#define INTEGRAL_COMPARE_COMPARE_FILES_H

#include "integral/compare/comparison_rules.h"
#include "integral/io/image_file.h"

#include <string>

namespace integral {

/// Files that a comparison writes; an empty path: none.
struct ComparisonOutputs {
    std::string difference; ///< |a - b| of each channel, times `gain`
    double gain = 1;
    std::string flip_map; ///< needs FLIP; an .exr holds its values, others show it in colours
};

/// Compares two pictures, with only some rows of each in memory at a time. No row of either may
/// have been read before. `name_of_b` is the name of b's file, for messages. Throws InputError,
/// OutputError, std::invalid_argument as settings_of does, and Interrupted.
Comparison compare_files(FrameReader& a, FrameReader& b, const std::string& name_of_b,
                         const ComparisonRules& rules, const ComparisonOutputs& outputs);

} // namespace integral

#endif
