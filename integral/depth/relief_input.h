// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes reliefs of what a user has: a frame or views, or one photograph, with depth that is
// measured in them or given in a file.
#ifndef INTEGRAL_DEPTH_RELIEF_INPUT_H
#define INTEGRAL_DEPTH_RELIEF_INPUT_H

#include "integral/depth/depth_input.h"
#include "integral/depth/depth_quality.h"
#include "integral/depth/relief.h"
#include "integral/lightfield/picture_fit.h"

#include <functional>
#include <string>

namespace integral {

/// The depths that a grey picture's white and black stand for, mm behind the sheet.
struct GreyDepths {
    double white = 0, black = 0;
};

struct ReliefRequest {
    DepthRequest input;
    std::string depth_file;                    ///< "": depth is measured
    std::optional<GreyDepths> grey;            ///< which a grey picture needs as depth_file
    DepthQuality quality = DepthQuality::good; ///< of measuring
    Vec2 size;           ///< the larger rectangle of a photograph's shape and this place is its
                         ///< size in the image plane, mm; its eye is before its middle
    double distance = 0; ///< of a photograph's eye from the image plane, mm
    Fit fit = Fit::contain; ///< of a depth_file on pictures of another shape
    /// Is told, in a line each, what was done with the depth_file.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// A relief, and the form of the pictures that it was made of.
struct ReliefInput {
    Relief relief;
    Image form;
};

/// Reads the inputs as read_depth_input does; one picture that is no frame and no quilt, and has a
/// depth_file, is a photograph. The file is a depth frame (for a frame), a .pfm or an .exr without
/// geometry of mm behind the sheet, or a grey picture, between whose black and white equal steps
/// are equal steps of parallax. Of the latter three, the rectangle of the views, seen by the middle
/// one. Measured depth and depth frames tell the depth seen by the middle and the outermost eyes.
/// Throws as read_depth_input, and std::invalid_argument where the file does not fit, or mm are not
/// known.
ReliefInput read_relief(const std::vector<std::string>& inputs, const ReliefRequest& request,
                        int threads, const Progress& progress);

/// The relief of an input, its depth measured: of one that has been read already.
Relief measured_relief(const DepthInput& input, DepthQuality quality, int threads,
                       const Progress& progress);

} // namespace integral

#endif
