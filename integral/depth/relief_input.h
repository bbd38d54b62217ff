// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes reliefs from a frame, from views or from one photograph, with depth that is measured in
// them or given in a file.
#ifndef INTEGRAL_DEPTH_RELIEF_INPUT_H
#define INTEGRAL_DEPTH_RELIEF_INPUT_H

#include "integral/depth/depth_input.h"
#include "integral/depth/depth_quality.h"
#include "integral/depth/relief.h"
#include "integral/frame/picture_fit.h"

#include <functional>
#include <string>

namespace integral {

/// The depths of a grey picture's white and black, mm behind the sheet.
struct GreyDepths {
    double white = 0, black = 0;
};

struct ReliefRequest {
    DepthRequest input;
    std::string depth_file;                    ///< "": depth is measured
    std::optional<GreyDepths> grey;            ///< needed if depth_file is a grey picture
    DepthQuality quality = DepthQuality::good; ///< of measuring
    Vec2 size;           ///< rectangle in the image plane that a photograph covers, mm; the middle
                         ///< of the rectangle is in front of the photograph's eye
    double distance = 0; ///< of a photograph's eye from the image plane, mm
    Fit fit = Fit::contain; ///< of a depth_file whose shape differs from the pictures'
    /// Takes notices about the depth_file for the user, a line each.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// A relief, and the form of the pictures that it was made from.
struct ReliefInput {
    Relief relief;
    Image form;
};

/// Reads the inputs as read_depth_input does; but one picture that is neither frame nor quilt is,
/// with a depth_file, a photograph. The depth_file is a depth frame (for a frame); a .pfm, or an
/// .exr without a frame's geometry, of mm behind the sheet; or a grey picture, in which equal steps
/// are equal steps of parallax. Maps other than depth frames cover the rectangle of the views and
/// give depth for the middle view alone; depth frames and measured depth also give it for the
/// outermost eyes. Throws as read_depth_input does, and std::invalid_argument if the depth_file
/// does not fit, or if the views have no record of their eyes: then their scale in mm is unknown.
ReliefInput read_relief(const std::vector<std::string>& inputs, const ReliefRequest& request,
                        int threads, const Progress& progress);

/// Measures the depth of an input that has been read, and makes its relief.
Relief measured_relief(const DepthInput& input, DepthQuality quality, int threads,
                       const Progress& progress);

} // namespace integral

#endif
