// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads views from a quilt or from one file a view, and draws views of a frame.
#ifndef INTEGRAL_VIEWS_VIEW_INPUT_H
#define INTEGRAL_VIEWS_VIEW_INPUT_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"
#include "integral/frame/picture_fit.h"
#include "integral/frame/view_grid.h"
#include "integral/replay/replay.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace integral {

/// The request contradicts the inputs or itself. The message names the file or option.
struct RequestError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Views by number, and their properties.
struct ViewInput {
    std::vector<Image> views;
    ViewGrid grid;
    std::optional<FrameMetadata> metadata; ///< of the frame they come from, with its quilt record
    double shape = 1;                      ///< displayed width / height of each view, > 0
    bool shape_is_assumed = false;         ///< from a quilt's pixels, as nothing states a shape
};

/// How views are read.
struct ViewsRequest {
    std::optional<ViewGrid> grid; ///< nothing: as in the inputs, or (files) as many as there are
    bool needs_geometry = true;   ///< any geometry in the inputs must be valid
    bool of_eyes = false; ///< perspective views: their quilt may have unused pixels
    std::optional<double> aspect; ///< the views' shape; nothing: as in the inputs, or (files) their
                                  ///< pixels' shape
    std::optional<double> video_time; ///< seconds: a quilt video's first picture from then on
};

/// Reads one quilt, an MPO, or the files of all views. The views' shape is the first of these that
/// exists: the requested one, the film's in their geometry, the one in the quilt's name
/// (perspective views only), the shape of their pixels' rectangle. Throws InputError and
/// RequestError; also if a name states a shape in which pixels would be more than four times as
/// long as wide.
ViewInput read_given_views(const std::vector<std::string>& inputs, const ViewsRequest& request);

/// Puts views that are in order from right to left into order from left to right: reverses each row
/// of their grid.
void turn_right_to_left(std::vector<Image>& views, ViewGrid directions);

/// A sentence on how the views were fitted to a target (picture_fit.h).
std::string fit_text(const ViewInput& given, const FittedPicture& picture,
                     const std::string& target);

/// The views of a frame from eyes spread over its viewing zone, by number. `view`: their size and
/// their part of the sheet. `threads` and `progress` as in for_each_row. Throws Interrupted where
/// `progress` stops the work.
std::vector<Image> views_of_eyes(const Frame& frame, ViewGrid grid, const View& view, int threads,
                                 const Progress& progress);

} // namespace integral

#endif
