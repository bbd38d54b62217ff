// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures with depth as views: RGBD pictures, pictures with a depth file, and stereo pairs, for
// the commands that show them.
#ifndef INTEGRAL_CLI_DEPTH_PICTURES_H
#define INTEGRAL_CLI_DEPTH_PICTURES_H

#include "integral/depth/relief_input.h"
#include "integral/sheet/panel.h"
#include "integral/views/view_input.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Values of --depth and --depth-range; nothing: not given.
struct DepthSource {
    std::optional<std::string> depth, range;
};

/// Whether a picture brings its depth along, beside it or inside its file: as --depth says or,
/// without it, by the file. Throws InputError.
bool has_own_depth(const std::string& path, const DepthSource& source);

/// Whether inputs are one picture with depth, or a stereo pair, whose views are to be drawn by
/// depth: as --depth says or, without it, by an RGBD picture's name, or because there are two
/// views. Throws InputError.
bool shows_by_depth(const std::vector<std::string>& inputs, const DepthSource& source);

/// The value of --depth that is in force: as given, or by the first input's file: beside, inside,
/// or else measured. Throws InputError.
std::string depth_in_force(const std::vector<std::string>& inputs, const DepthSource& source);

/// Facts about inputs that options give.
struct GivenPictures {
    Fit fit = Fit::contain;       ///< not stretch
    std::optional<double> aspect; ///< of each view
    bool right_to_left = false;   ///< views or a pair
    std::optional<ViewGrid> grid; ///< of the views
    bool eyes = false;            ///< views are seen by eyes that are spread over the zone
};

/// The request for inputs that will be seen in a frame of geometry `seen`. Depths without a unit
/// are limited to twice its depth budget. Notices begin with the command's name. Throws UsageError.
ReliefRequest relief_request(const char* command, const std::vector<std::string>& inputs,
                             const DepthSource& source, const GivenPictures& given,
                             const FrameMetadata& seen);

/// Views of a picture with depth that are drawn for a panel.
struct DepthViewsRequest {
    Panel panel;
    std::optional<ViewGrid> grid;  ///< of the quilt; nothing: of the panel's recommended quilt
    std::optional<PixelSize> size; ///< of each view; nothing: as in that quilt
    Fit fit = Fit::contain;        ///< on the panel; not stretch
    bool right_to_left = false;    ///< a pair's views
    const char* command = "";      ///< name of the command, for messages
    int threads = 0;
};

PixelSize size_of_view(const DepthViewsRequest& request);

/// The views, whose shape is the panel's, from eyes spread over the panel's zone. Prints what is
/// known about the depths, and how much is invented. Throws UsageError, InputError, Interrupted.
ViewInput views_by_depth(const std::vector<std::string>& inputs, const DepthSource& source,
                         const DepthViewsRequest& request);

} // namespace integral

#endif
