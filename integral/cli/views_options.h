// SPDX-License-Identifier: AGPL-3.0-or-later
// The options of `integral views`, and its reverse, --to-frame.
#ifndef INTEGRAL_CLI_VIEWS_OPTIONS_H
#define INTEGRAL_CLI_VIEWS_OPTIONS_H

#include "integral/cli/depth_pictures.h"
#include "integral/cli/fit_options.h"
#include "integral/cli/series_options.h"
#include "integral/cli/thread_options.h"
#include "integral/views/view_export.h"

namespace integral {

struct ViewsOptions : CommonOptions {
    std::optional<std::string> output, views, size, sheet, panel, rgbd, at;
    DepthSource depth;
    bool eyes = false, files = false, upright = false, to_frame = false;
    FitOptions fit;
    ViewOrderOptions given_views;
    ThreadOptions threads;
    SeriesOptions series;
};

void declare(options::options_description& all, ViewsOptions& o);

/// --to-frame: writes the frame that shows the views of a quilt, or of files. Returns an
/// ExitStatus. Throws as a command's run does.
int make_frame(const ViewsOptions& o, const std::string& output, int threads);

/// --to-frame --depth: makes a frame from a frame, views or a photograph, and their depths.
int make_frame_with_depth(const ViewsOptions& o, const std::string& output, int threads);

/// Writes the views of a picture with depth or a stereo pair, for a panel or the sheet of a frame,
/// in the form of `requested`. Returns an ExitStatus. Throws as a command's run does.
int make_views_by_depth(const ViewsOptions& o, const ViewExport& requested);

} // namespace integral

#endif
