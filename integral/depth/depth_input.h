// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads what depth is to be measured in: a frame, or views.
#ifndef INTEGRAL_DEPTH_DEPTH_INPUT_H
#define INTEGRAL_DEPTH_DEPTH_INPUT_H

#include "integral/depth/view_set.h"

#include <string>

namespace integral {

/// The eyes of views that are spread over the zone of a sheet, and how wide a view is in the image
/// plane, mm.
struct GivenZone {
    EyeGrid eyes;
    double width = 0;
    LensSheet sheet;
};

/// What is known of the inputs besides what they say themselves.
struct DepthRequest {
    std::optional<ViewGrid> grid;  ///< of the views; nothing: as they say
    std::optional<ViewEyes> eyes;  ///< where they were taken from; nothing: as they say
    std::optional<GivenZone> zone; ///< the same, where neither they nor `eyes` say it
    bool top_first = false;        ///< the files' first row of views is from above
    bool right_to_left = false;    ///< the views stand from right to left
    std::optional<double> aspect;  ///< the views' shape, as in ViewsRequest
    std::string sheet;             ///< a file with the frame's geometry; "": it carries its own
};

/// The views, the size of the picture in mm (pixels, where mm are not known), and the geometry of
/// the frame, if it is one.
struct DepthInput {
    ViewSet views; ///< not softened
    double width = 0, height = 0;
    std::optional<FrameMetadata> frame;
    Image form; ///< of the pictures: sample type and encoding, without samples
};

/// One frame, one quilt or MPO, or the files of all views. Parallel views of a frame become that
/// frame again. Throws InputError, std::invalid_argument where the request does not go with the
/// inputs, Interrupted.
DepthInput read_depth_input(const std::vector<std::string>& inputs, const DepthRequest& request,
                            int threads, const Progress& progress);

} // namespace integral

#endif
