// SPDX-License-Identifier: AGPL-3.0-or-later
// Comparison of two frames as eyes see them through their sheets: the request and the figures. The
// comparison itself is compare_seen of integral/replay.
#ifndef INTEGRAL_COMPARE_SEEN_H
#define INTEGRAL_COMPARE_SEEN_H

#include "integral/compare/compare.h"
#include "integral/compare/comparison_rules.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Differences of parallax and depth between two frames, over details that are found in the views
/// of all eyes in a row across the lenses. A detail's parallax is the distance that it moves on the
/// sheet from the view of the row's first eye to that of its last. A detail z mm behind the sheet
/// moves by B z/(D + z) for eyes B mm apart at the distance D, which gives its depth z.
struct ParallaxDifference {
    double greatest = 0;       ///< mm on the sheet
    Vec2 place;                ///< where `greatest` is: mm from the sheet's centre, y upwards
    double median = 0;         ///< mm on the sheet
    double greatest_depth = 0; ///< mm of depth, without sign
    double median_depth = 0;   ///< mm by which the result's details lie farther back
    int details = 0;           ///< number found
};

/// The figures of one eye's views.
struct SeenByEye {
    Vec3 eye; ///< mm from the sheet's centre; z: distance in front of it
    Comparison figures;
};

struct SeenFigures {
    std::vector<SeenByEye> eyes;
    std::size_t worst = 0; ///< the eye whose two views differ most, by FLIP if computed, else RMSE
    Vec2 place;            ///< where its views differ most, mm from the sheet's centre, y upwards
    Comparison overall;    ///< the worst of each figure over the eyes
    std::optional<ParallaxDifference> parallax; ///< empty with one eye, or where nothing was found
    Image reference, result;                    ///< the worst eye's views
};

/// Reads the eyes from words: one "CxR", or any number of "X,Y,DISTANCE". Throws
/// std::invalid_argument.
SeenEyes seen_eyes_of(const std::vector<std::string>& words);

/// Compares the eyes' views of two frames that have metadata.
using CompareSeen = std::function<SeenFigures(const Frame& reference, const Frame& result,
                                              const ComparisonRules& rules)>;

/// "20,0,400": an eye in words, in mm.
std::string eye_text(const Vec3& eye);

/// The lines of the eyes' views in the table of figures_text.
std::string seen_text(const SeenFigures& seen);

} // namespace integral

#endif
