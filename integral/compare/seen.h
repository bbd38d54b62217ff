// SPDX-License-Identifier: AGPL-3.0-or-later
// What eyes see of two frames through their sheets, compared: the request and the figures. The
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

/// Parallax of a frame: how far a detail's place on the sheet moves from the first to the last of
/// the eyes on a way across the lenses. A detail z mm behind the sheet moves by B z/(D + z) for
/// eyes B mm apart at the distance D, which gives its depth z. How much both differ between the
/// frames, over the details that are found in the views of all eyes on the way.
struct ParallaxDifference {
    double greatest = 0;       ///< mm on the sheet
    Vec2 place;                ///< of the greatest: mm from the sheet's centre, y upwards
    double median = 0;         ///< mm on the sheet
    double greatest_depth = 0; ///< mm of depth, without sign
    double median_depth = 0;   ///< mm by which the result's details lie farther back
    int details = 0;           ///< that were found
};

/// The figures of one eye's views.
struct SeenByEye {
    Vec3 eye; ///< mm from the sheet's centre; z: distance in front of it
    Comparison figures;
};

struct SeenFigures {
    std::vector<SeenByEye> eyes;
    std::size_t worst = 0; ///< the eye whose views differ most, by FLIP if computed, else by RMSE
    Vec2 place;            ///< where they differ most, mm from the sheet's centre, y upwards
    Comparison overall;    ///< of each figure the worst over the eyes
    std::optional<ParallaxDifference> parallax; ///< empty with one eye, or where nothing was found
    Image reference, result;                    ///< the worst eye's views
};

/// Reads the eyes from words: one "CxR", or any number of "X,Y,DISTANCE". Throws
/// std::invalid_argument.
SeenEyes seen_eyes_of(const std::vector<std::string>& words);

/// Compares what eyes see of two frames that have metadata.
using CompareSeen = std::function<SeenFigures(const Frame& reference, const Frame& result,
                                              const ComparisonRules& rules)>;

/// "20,0,400": an eye in words, in mm.
std::string eye_text(const Vec3& eye);

/// The lines of a table of what eyes see.
std::string seen_text(const SeenFigures& seen);

} // namespace integral

#endif
