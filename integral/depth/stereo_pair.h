// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures the depth of a stereo pair, in which either picture shows what the other one hides.
#ifndef INTEGRAL_DEPTH_STEREO_PAIR_H
#define INTEGRAL_DEPTH_STEREO_PAIR_H

#include "integral/depth/disparity_search.h"

namespace integral {

/// The disparities of both pictures' pixels, row by row: pixels by which a point moves to the left
/// from the left picture to the right one. A pixel that the other picture hides has the disparity
/// of the farther surface next to it in its row.
struct PairDisparity {
    int width = 0, height = 0;
    std::vector<float> left, right;
    DisparityRange range;  ///< of nine tenths of the pixels that both pictures show
    double matched = 0;    ///< share of the pixels whose match in the other picture matches them
};

/// Measures a pair of pictures of one size, whose rows are the same in both. Searches disparities
/// up to a fifth of the width. Throws std::invalid_argument if the sizes differ, Interrupted.
PairDisparity pair_disparity(const Image& left, const Image& right, int threads,
                             const Progress& progress);

} // namespace integral

#endif
