// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the input of a depth measurement: a frame, or views.
#ifndef INTEGRAL_DEPTH_DEPTH_INPUT_H
#define INTEGRAL_DEPTH_DEPTH_INPUT_H

#include "integral/depth/view_set.h"

#include <string>

namespace integral {

/// Eyes that are spread over the viewing zone of a sheet, and the width (mm) of their views in the
/// image plane.
struct GivenZone {
    EyeGrid eyes;
    double width = 0;
    LensSheet sheet;
};

/// Facts about the inputs that the files may lack.
struct DepthRequest {
    std::optional<ViewGrid> grid;  ///< of the views; nothing: as in the files
    std::optional<ViewEyes> eyes;  ///< of the views; nothing: as in the files
    std::optional<GivenZone> zone; ///< the eyes, if neither the files nor `eyes` give them
    bool top_first = false;        ///< the first row of views in the files is the highest
    bool right_to_left = false;    ///< the views stand from right to left
    std::optional<double> aspect;  ///< the views' shape, as in ViewsRequest (view_input.h)
    std::string sheet;             ///< a file with the frame's geometry; "": the frame has it
};

/// The views, the size of the picture in mm (pixels, where mm are not known), and, for a frame, its
/// geometry.
struct DepthInput {
    ViewSet views; ///< before soften()
    double width = 0, height = 0;
    std::optional<FrameMetadata> frame;
    Image form; ///< of the pictures: sample type and encoding, without samples
};

/// The input of a frame in memory that has metadata. Throws std::invalid_argument as view_set does,
/// and Interrupted where `progress` stops the work.
DepthInput depth_input_of(const Frame& frame, int threads, const Progress& progress);

/// The input of perspective views in memory. Parameters and exceptions as of view_set.
DepthInput depth_input_of(const std::vector<Image>& views, ViewGrid grid,
                          const std::optional<ViewEyes>& eyes, std::optional<double> shape);

/// Reads one frame, one quilt or MPO, or the files of all views. Turns parallel views of a frame
/// back into that frame. Throws InputError, std::invalid_argument where the request does not fit
/// the inputs, Interrupted.
DepthInput read_depth_input(const std::vector<std::string>& inputs, const DepthRequest& request,
                            int threads, const Progress& progress);

} // namespace integral

#endif
