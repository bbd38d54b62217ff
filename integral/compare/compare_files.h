// SPDX-License-Identifier: AGPL-3.0-or-later
// Two pictures compared while they are read, and their difference and FLIP map written.
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

/// Compares two pictures of which no row has been read; only some rows of each are in memory at a
/// time. `name_of_b` is its file's, for messages. Throws InputError, OutputError,
/// std::invalid_argument as settings_of does, and Interrupted.
Comparison compare_files(FrameReader& a, FrameReader& b, const std::string& name_of_b,
                         const ComparisonRules& rules, const ComparisonOutputs& outputs);

} // namespace integral

#endif
