// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the views that a command is given, as a quilt or as one file a view, and takes views of a
// frame.
#ifndef INTEGRAL_OUTPUT_GIVEN_VIEWS_H
#define INTEGRAL_OUTPUT_GIVEN_VIEWS_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"
#include "integral/lightfield/picture_fit.h"
#include "integral/lightfield/view_grid.h"
#include "integral/replay/replay.h"

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
    double shape = 1;              ///< width by height of each view as it is to be seen, > 0
    bool shape_is_assumed = false; ///< that of the pixels of a quilt's views, as nothing states it
};

/// How views are read.
struct ViewsRequest {
    std::optional<ViewGrid> grid; ///< nothing: as the inputs say, or (files) as many as there are
    bool needs_geometry = true;   ///< of the frame they come from, where the inputs have it
    bool of_eyes = false; ///< they are perspective views: a quilt may have some pixels more than
                          ///< its views
    std::optional<double> aspect; ///< the views' shape; nothing: as the inputs say, or (files) that
                                  ///< of their pixels
};

/// Reads one quilt, an MPO, or the files of all views. The views' shape is the first of these that
/// exists: the request's, that of the film in their geometry, the one in the quilt's name, that of
/// their pixels. Throws RequestError, also where a name states a shape in which pixels would be
/// more than four times as long as wide; and InputError.
GivenViews read_given_views(const std::vector<std::string>& inputs, const ViewsRequest& request);

/// Reverses the order of views that stand from right to left, in each row of a grid of directions.
void turn_right_to_left(std::vector<Image>& views, ViewGrid directions);

/// What was done to bring the views onto a target (picture_fit.h), in a sentence.
std::string fit_text(const GivenViews& given, const FittedPicture& picture,
                     const std::string& target);

/// The views of a frame that eyes have which are spread over its viewing zone, by number. `view`:
/// their size and their part of the sheet. `threads` and `progress` as in for_each_row. Throws
/// Interrupted where `progress` stops the work.
std::vector<Image> views_of_eyes(const Frame& frame, ViewGrid grid, const View& view, int threads,
                                 const Progress& progress);

} // namespace integral

#endif
