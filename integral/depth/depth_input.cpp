// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_input.h"

#include "integral/base/interrupt.h"
#include "integral/io/image_file.h"
#include "integral/views/parallel_views.h"
#include "integral/views/view_input.h"

#include <algorithm>
#include <stdexcept>

namespace integral {

DepthInput depth_input_of(const Frame& frame, int threads, const Progress& progress)
{
    const Vec2 size = size_of(frame.metadata->film);
    return {view_set(frame, threads, progress), size.x, size.y, frame.metadata,
            form_of(frame.image)};
}

DepthInput depth_input_of(const std::vector<Image>& views, ViewGrid grid,
                          const std::optional<ViewEyes>& eyes, std::optional<double> shape)
{
    DepthInput input;
    input.form = form_of(views.at(0));
    input.views = view_set(views, grid, eyes, shape);
    const ViewSet& set = input.views;
    const double right = set.width * length(set.places.right),
                 down = set.height * length(set.places.down);
    input.width = set.turned ? down : right;
    input.height = set.turned ? right : down;
    return input;
}

namespace {

/// Reverses the order of the rows of views, so that the lowest row comes first.
void turn_over(std::vector<Image>& views, ViewGrid grid)
{
    for (int low = 0, high = grid.rows - 1; low < high; ++low, --high)
        for (int column = 0; column < grid.columns; ++column)
            std::swap(views[std::size_t(low * grid.columns + column)],
                      views[std::size_t(high * grid.columns + column)]);
}

/// Eyes of perspective views.
ViewEyes eyes_in(const GivenZone& zone, ViewGrid grid)
{
    return {{zone.eyes.zone.x / grid.columns, zone.eyes.zone.y / grid.rows},
            zone.eyes.distance,
            zone.width};
}

/// The frame from which parallel views were taken.
Frame frame_of(const ViewInput& given, ViewGrid grid, int threads, const Progress& progress)
{
    FrameMetadata metadata = *given.metadata;
    auto image = frame_from_parallel_views(given.views, metadata, grid, threads, progress);
    if (!image)
        throw Interrupted();
    metadata.quilt.reset();
    Frame frame{std::move(*image), std::nullopt};
    set_metadata(frame, metadata);
    return frame;
}

DepthInput of_views(const std::vector<std::string>& inputs, const DepthRequest& request,
                    int threads, const Progress& progress)
{
    ViewsRequest requested;
    requested.grid = request.grid;
    requested.needs_geometry = false;
    requested.of_eyes = true;
    requested.aspect = request.aspect;
    ViewInput given = read_given_views(inputs, requested);
    if (given.views.size() < 3)
        throw std::invalid_argument("depth needs 3 views at least, and there are " +
                                    std::to_string(given.views.size()) +
                                    "; integral lcd and views draw views of a stereo pair");
    ViewGrid grid = given.grid;
    std::optional<ViewEyes> eyes = request.eyes;
    if (given.metadata)
        grid = directions_of(grid, given.metadata->sheet);
    if (request.right_to_left)
        turn_right_to_left(given.views, grid);
    if (given.metadata) {
        if (!given.metadata->quilt->eyes)
            return depth_input_of(frame_of(given, grid, threads, progress), threads, progress);
        if (!eyes)
            eyes = eyes_in({*given.metadata->quilt->eyes, size_of(given.metadata->film).x,
                            given.metadata->sheet},
                           grid);
    }
    if (!eyes && request.zone) {
        grid = directions_of(grid, request.zone->sheet);
        eyes = eyes_in(*request.zone, grid);
    }
    if (request.top_first)
        turn_over(given.views, grid);
    return depth_input_of(given.views, grid, eyes, given.shape);
}

} // namespace

DepthInput read_depth_input(const std::vector<std::string>& inputs, const DepthRequest& request,
                            int threads, const Progress& progress)
{
    std::optional<Frame> frame;
    if (inputs.size() == 1 && !is_list_of_views(inputs[0])) {
        FrameReader reader(inputs[0], request.sheet);
        reader.refuse_projection();
        if (reader.frame().metadata)
            frame = reader.whole();
    }
    if (frame && (request.aspect || request.right_to_left))
        throw std::invalid_argument("it is a frame; --aspect and --right-to-left are for views");
    return frame ? depth_input_of(*frame, threads, progress)
                 : of_views(inputs, request, threads, progress);
}

} // namespace integral
