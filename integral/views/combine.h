// SPDX-License-Identifier: AGPL-3.0-or-later
// Merges frames of one sheet and film by their depth frames: at each pixel the nearer frame covers
// the farther ones (thesis 6.1).
#ifndef INTEGRAL_VIEWS_COMBINE_H
#define INTEGRAL_VIEWS_COMBINE_H

#include "integral/base/parallel.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

struct CombineRequest {
    std::vector<std::string> frames; ///< at least 2
    std::vector<std::string> depths; ///< a depth frame for each; empty: depth_beside() of each
                                     ///< frame
    std::string output;
    std::string depth_output; ///< the merged depth frame; empty: none is written
    std::optional<int> bits;  ///< 8, 16 or 32; nothing: the most bits of any frame
    int threads = 0;          ///< 0: one per core
};

/// Default name of a frame's depth frame, in the same folder: FRAME-depth.exr for FRAME.EXTENSION.
std::string depth_beside(const std::string& frame);

/// For each frame, the share (0 to 1) of the imaged pixels whose merged depth is its depth.
using CombinedShares = std::vector<double>;

/// Writes the merged frame, and its depth frame if requested. At a pixel the frames are ordered by
/// their depths, at equal depths as they are given; each covers those behind it by its alpha, in
/// linear light. Frames without alpha are opaque. A pixel gets the depth of the nearest frame
/// whose alpha there is at least 1/2 or, if there is none, the nearest depth. The new document
/// contains neither placement nor parallax, and of render only what lines of sight depend on.
/// Throws std::invalid_argument for frames of different geometry, InputError, OutputError, and
/// Interrupted if `progress` stops the work.
CombinedShares write_combined(const CombineRequest& request, const Progress& progress);

} // namespace integral

#endif
