// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the views that a command is given, as a quilt or as one file a view, and takes views of a
// frame.
#ifndef INTEGRAL_OUTPUT_GIVEN_VIEWS_H
#define INTEGRAL_OUTPUT_GIVEN_VIEWS_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"
#include "integral/lightfield/view_grid.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace integral {

/// What was asked for does not go with the inputs, or with itself. The message says which file or
/// option is meant.
struct RequestError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Views by number, and what is known of them.
struct GivenViews {
    std::vector<Image> views;
    ViewGrid grid;
    std::optional<FrameMetadata> metadata; ///< of the frame they come from, with its quilt record
};

/// How views are read.
struct ViewsRequest {
    std::optional<ViewGrid> grid; ///< nothing: as the inputs say, or (files) as many as there are
    bool needs_geometry = true;   ///< of the frame they come from, where the inputs have it
    bool of_eyes = false; ///< they are perspective views: a quilt may have some pixels more than
                          ///< its views
};

/// Reads one quilt, an MPO, or the files of all views. Throws RequestError and InputError.
GivenViews read_given_views(const std::vector<std::string>& inputs, const ViewsRequest& request);

/// The views of a frame that eyes have which are spread over its viewing zone, by number: pictures
/// of width x height pixels. `threads` and `progress` as in for_each_row. Throws Interrupted where
/// `progress` stops the work.
std::vector<Image> views_of_eyes(const Frame& frame, ViewGrid grid, int width, int height,
                                 int threads, const Progress& progress);

} // namespace integral

#endif
