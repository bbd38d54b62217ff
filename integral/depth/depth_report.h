// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the true depth against which a map is scored, and reports the figures of a measurement.
#ifndef INTEGRAL_DEPTH_DEPTH_REPORT_H
#define INTEGRAL_DEPTH_DEPTH_REPORT_H

#include "integral/base/json.h"
#include "integral/depth/depth_input.h"
#include "integral/depth/depth_scores.h"

namespace integral {

/// Reads the true disparities of the middle view from the depth frame (.exr) of the frame that the
/// views come from, or from a map of disparities (.pfm). Throws InputError, and
/// std::invalid_argument if the file does not fit the views.
std::vector<float> read_truth(const std::string& path, const DepthInput& input);

struct DepthFigures {
    std::size_t views = 0;
    int width = 0, height = 0; ///< of the map, pixels
    DisparityRange range;      ///< searched
    double seconds = 0;
    std::optional<DepthScores> scores; ///< if the truth is known
};

std::string figures_text(const DepthFigures& figures);
Json figures_json(const DepthFigures& figures);

} // namespace integral

#endif
