// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/views_to_frame.h"

#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/output/given_views.h"
#include "integral/replay/arrange.h"
#include "integral/replay/perspective_views.h"

namespace integral {

namespace {

GivenViews read_views_given(const options::variables_map& arguments)
{
    ViewsRequest request;
    if (given(arguments, "views"))
        request.grid = parse_view_grid(text_of(arguments, "views"));
    request.needs_geometry = !given(arguments, "sheet");
    request.of_eyes = arguments["eyes"].as<bool>();
    try {
        return read_given_views(inputs_of(arguments), request);
    } catch (const RequestError& error) {
        throw UsageError(error.what());
    }
}

} // namespace

int frame_of_views(const options::variables_map& arguments, const std::string& output, int threads)
{
    const auto inputs = inputs_of(arguments);
    check_writable(output);
    const GivenViews given_views = read_views_given(arguments);
    const std::string sheet = text_of(arguments, "sheet");
    if (sheet.empty() && !given_views.metadata)
        throw UsageError("--to-frame needs --sheet FILE.json here, the geometry of the frame "
                         "(integral sheet FRAME --json writes it): " +
                         inputs[0] + " carries none");
    FrameMetadata geometry = sheet.empty() ? *given_views.metadata : read_metadata(sheet);
    if (geometry.film.width < 1)
        throw UsageError(sheet + ": says no film.width and film.height, the frame's pixels");
    stop_if_interrupted();
    if (arguments["eyes"].as<bool>() && given_views.metadata && !given_views.metadata->quilt->eyes)
        throw UsageError(inputs[0] + ": it says that it holds parallel views, not those of --eyes");
    const bool eyes = arguments["eyes"].as<bool>() ||
                      (given_views.metadata && given_views.metadata->quilt->eyes);
    EyeGrid eye_grid{viewing_zone(geometry, geometry.aperture.distance),
                     geometry.aperture.distance};
    if (given_views.metadata)
        eye_grid = given_views.metadata->quilt->eyes.value_or(eye_grid);
    try {
        const Progress bar = progress_bar("views");
        auto image = eyes ? frame_from_perspective_views(given_views.views, geometry,
                                                         given_views.grid, eye_grid, threads, bar)
                          : frame_from_views(given_views.views, geometry, given_views.grid, threads,
                                             bar);
        if (!image)
            throw Interrupted();
        Frame frame{std::move(*image), std::nullopt};
        geometry.quilt.reset();
        set_metadata(frame, geometry);
        write_frame(output, std::move(frame));
    } catch (const std::invalid_argument& error) {
        throw UsageError(inputs[0] + ": " + error.what());
    }
    return exit_done;
}

} // namespace integral
