// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/views_to_frame.h"

#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/output/quilt.h"
#include "integral/replay/arrange.h"
#include "integral/replay/perspective_views.h"

#include <map>

namespace integral {

ViewGrid parse_view_grid(const options::variables_map& arguments)
{
    const PixelSize size = parse_size("views", text_of(arguments, "views"), most_views_a_side);
    return {size.width, size.height};
}

namespace {

/// Views by number, and what is known of them.
struct GivenViews {
    std::vector<Image> views;
    ViewGrid grid;
    std::optional<FrameMetadata> metadata; ///< of the frame they come from, with its quilt record
};

GivenViews read_quilt(const options::variables_map& arguments, const std::string& input)
{
    Views quilt = read_views(input, !given(arguments, "sheet"));
    const auto named = grid_in_name(input);
    GivenViews all{{}, {}, quilt.metadata};
    if (given(arguments, "views"))
        all.grid = parse_view_grid(arguments);
    else if (quilt.metadata)
        all.grid = quilt.metadata->quilt->grid;
    else if (named)
        all.grid = *named;
    else
        throw UsageError(input + ": its name does not end in _qsCxRaASPECT; --views CxR would tell");
    const ViewGrid grid = all.grid;
    if (quilt.metadata && quilt.metadata->quilt->view && grid.count() > 1)
        throw UsageError(input + ": it is view " + std::to_string(*quilt.metadata->quilt->view) + " of " + std::to_string(grid.count())
                         + "; give the files of all of them");
    // Pictures that eyes see may leave a rest, as 5 x 9 in 4096 x 4096; a parallel view has just so many pixels.
    const bool eyes = arguments["eyes"].as<bool>();
    const auto divides = [&](int side, int views) { return views >= 1 && (eyes ? side >= views : side % views == 0); };
    if (!divides(quilt.image.width, grid.columns) || !divides(quilt.image.height, grid.rows))
        throw UsageError(input + ": " + std::to_string(quilt.image.width) + "x" + std::to_string(quilt.image.height)
                         + " pixels are not " + std::to_string(grid.columns) + "x" + std::to_string(grid.rows) + " equal views");
    all.views = views_of_quilt(quilt.image, grid);
    return all;
}

bool of_one_kind(const QuiltRecord& a, const QuiltRecord& b)
{
    return a.grid.columns == b.grid.columns && a.grid.rows == b.grid.rows && a.eyes.has_value() == b.eyes.has_value();
}

/// Files that say which view each is; or, where they do not, in the order in which they are given.
GivenViews read_files(const options::variables_map& arguments, const std::vector<std::string>& inputs)
{
    GivenViews all;
    std::map<int, Image> by_number;
    for (const std::string& input : inputs) {
        stop_if_interrupted();
        Views file = read_views(input, !given(arguments, "sheet"));
        if (file.metadata && all.metadata && !of_one_kind(*file.metadata->quilt, *all.metadata->quilt))
            throw UsageError(input + ": it is a view of another set than the files before it");
        const bool numbered = file.metadata && file.metadata->quilt->view;
        const int number = numbered ? *file.metadata->quilt->view : int(by_number.size());
        if (!by_number.emplace(number, std::move(file.image)).second)
            throw UsageError(input + ": another file is view " + std::to_string(number) + " as well");
        if (file.metadata)
            all.metadata = file.metadata;
    }
    all.grid = given(arguments, "views") ? parse_view_grid(arguments)
             : all.metadata              ? all.metadata->quilt->grid
                                         : ViewGrid{int(inputs.size()), 1};
    if (int(by_number.size()) != all.grid.count() || by_number.rbegin()->first != all.grid.count() - 1)
        throw UsageError(std::to_string(inputs.size()) + " files are not the " + std::to_string(all.grid.columns) + "x"
                         + std::to_string(all.grid.rows) + " views; --views CxR would tell how many there are");
    for (auto& [number, image] : by_number)
        all.views.push_back(std::move(image));
    return all;
}

} // namespace

int frame_of_views(const options::variables_map& arguments, const std::string& output, int threads)
{
    const auto inputs = inputs_of(arguments);
    check_writable(output);
    const GivenViews given_views = inputs.size() == 1 ? read_quilt(arguments, inputs[0]) : read_files(arguments, inputs);
    const std::string sheet = text_of(arguments, "sheet");
    if (sheet.empty() && !given_views.metadata)
        throw UsageError("--to-frame needs --sheet FILE.json here, the geometry of the frame (integral sheet FRAME --json writes it): "
                         + inputs[0] + " carries none");
    FrameMetadata geometry = sheet.empty() ? *given_views.metadata : read_metadata(sheet);
    if (geometry.film.width < 1)
        throw UsageError(sheet + ": says no film.width and film.height, the frame's pixels");
    stop_if_interrupted();
    if (arguments["eyes"].as<bool>() && given_views.metadata && !given_views.metadata->quilt->eyes)
        throw UsageError(inputs[0] + ": it says that it holds parallel views, not those of --eyes");
    const bool eyes = arguments["eyes"].as<bool>() || (given_views.metadata && given_views.metadata->quilt->eyes);
    EyeGrid eye_grid{viewing_zone(geometry, geometry.aperture.distance), geometry.aperture.distance};
    if (given_views.metadata)
        eye_grid = given_views.metadata->quilt->eyes.value_or(eye_grid);
    try {
        const Progress bar = progress_bar("views");
        auto image = eyes ? frame_from_perspective_views(given_views.views, geometry, given_views.grid, eye_grid, threads, bar)
                          : frame_from_views(given_views.views, geometry, given_views.grid, threads, bar);
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
