// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/replay_series.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace integral {
namespace {

constexpr int border = 4; ///< between the views of a grid, pixels

std::vector<Eye> eyes_for(const ViewArrangement& arrangement, Eye middle,
                          const FrameMetadata& metadata)
{
    if (arrangement.separation)
        return eye_pair(middle, *arrangement.separation);
    if (arrangement.columns == 0)
        return {middle};
    return contact_sheet_eyes(metadata, middle, arrangement.columns, arrangement.rows);
}

/// The views of eyes_for as one picture.
Image arranged(const ViewArrangement& arrangement, std::vector<Image> views)
{
    const bool pair = arrangement.separation.has_value();
    if (arrangement.anaglyph)
        return anaglyph(views[0], views[1]);
    if (arrangement.crossed)
        std::swap(views[0], views[1]);
    if (views.size() == 1)
        return std::move(views[0]);
    return tiled(views, pair ? 2 : arrangement.columns, pair ? 0 : border);
}

void check_stop(const Eye& stop, const View& view)
{
    if (!(stop.distance > 0))
        throw std::invalid_argument(
            "--path: from this --eye it goes behind the sheet; a lesser span would do");
    if (!(view.focus > -stop.distance))
        throw std::invalid_argument("--path: it comes as near to the sheet as " +
                                    std::to_string(stop.distance) + " mm, and --focus " +
                                    std::to_string(view.focus) + " would be behind the eye there");
}

} // namespace

void check_size(const ViewArrangement& arrangement, const View& view)
{
    const bool pair = arrangement.separation.has_value();
    const int columns = pair && !arrangement.anaglyph ? 2 : std::max(1, arrangement.columns),
              rows = std::max(1, arrangement.rows), between = pair ? 0 : border;
    if (columns * (view.width + between) - between > largest_replay_side ||
        rows * (view.height + between) - between > largest_replay_side)
        throw std::invalid_argument(std::to_string(columns) + " by " + std::to_string(rows) +
                                    " views of " + std::to_string(view.width) + "x" +
                                    std::to_string(view.height) + " pixels are more than " +
                                    std::to_string(largest_replay_side) +
                                    " pixels one way; a smaller --size would help");
}

std::vector<Eye> eyes_of(const ReplayRequest& request, const FrameMetadata& metadata)
{
    const Eye middle = request.view.eye;
    if (!request.movement)
        return {middle};
    const EyeMovement& movement = *request.movement;
    const auto eyes = eye_path(movement.path, middle, viewing_zone(metadata, middle.distance),
                               movement.span, movement.steps, lenses_lie_across(metadata.sheet));
    for (const Eye& eye : eyes)
        check_stop(eye, request.view);
    return eyes;
}

bool ends_apart(const EyeMovement& movement)
{
    return movement.path != EyePath::circle && movement.path != EyePath::sway;
}

void check_view(const View& view, const FrameMetadata& metadata)
{
    if (!(view.focus > -view.eye.distance))
        throw std::invalid_argument("--focus " + std::to_string(view.focus) +
                                    ": that is not in front of the eye, which is " +
                                    std::to_string(view.eye.distance) +
                                    " mm in front of the sheet");
    if (!(view.film_gap > -metadata.sheet.thickness))
        throw std::invalid_argument("--film-gap " + std::to_string(view.film_gap) +
                                    ": that is not behind the lenses, whose focus is " +
                                    std::to_string(metadata.sheet.thickness) + " mm behind them");
    if (view.model == LensModel::full && !has_surface(metadata.sheet))
        throw std::invalid_argument(
            "--lens-model full: these lenses have no surface that reaches their edge");
}

bool replay_pictures(const Frame& frame, const ReplayRequest& request, const TakePicture& take,
                     const Progress& progress)
{
    const FrameMetadata& metadata = *frame.metadata;
    check_size(request.arrangement, request.view);
    const std::vector<Eye> stops = eyes_of(request, metadata);
    View view = request.view;
    if (request.arrangement.half)
        view.width = std::max(1, view.width / 2);
    for (std::size_t i = 0; i < stops.size(); ++i) {
        auto views = replay_each(frame, view, eyes_for(request.arrangement, stops[i], metadata),
                                 request.threads, piece_of(progress, int(i), int(stops.size())));
        if (!views)
            return false;
        take(arranged(request.arrangement, std::move(*views)));
    }
    return true;
}

} // namespace integral
