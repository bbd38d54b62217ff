// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/given_views.h"

#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/output/quilt.h"
#include "integral/replay/arrange.h"

#include <iterator>
#include <map>

namespace integral {

ViewGrid parse_view_grid(const std::string& text)
{
    const PixelSize size = parse_size("views", text, most_views_a_side, "CxR");
    return {size.width, size.height};
}

ViewGrid parse_view_grid(const options::variables_map& arguments)
{
    return parse_view_grid(text_of(arguments, "views"));
}

namespace {

GivenViews read_quilt(const std::string& input, const ViewsSaid& said)
{
    Views quilt = read_views(input, !said.ignore_documents);
    const auto named = grid_in_name(input);
    GivenViews all{{}, {}, quilt.metadata};
    if (said.grid)
        all.grid = *said.grid;
    else if (quilt.metadata)
        all.grid = quilt.metadata->quilt->grid;
    else if (named)
        all.grid = *named;
    else
        throw UsageError(input +
                         ": its name does not end in _qsCxRaASPECT; --views CxR would tell");
    const ViewGrid grid = all.grid;
    if (quilt.metadata) {
        const ViewGrid held = quilt.metadata->quilt->grid;
        if (held.columns != grid.columns || held.rows != grid.rows)
            throw UsageError(input + ": it says that it holds " + std::to_string(held.columns) +
                             "x" + std::to_string(held.rows) + " views; leave --views out");
    }
    if (quilt.metadata && quilt.metadata->quilt->view && grid.count() > 1)
        throw UsageError(input + ": it is view " + std::to_string(*quilt.metadata->quilt->view) +
                         " of " + std::to_string(grid.count()) + "; give the files of all of them");
    // Pictures that eyes see may leave a rest, as 5 x 9 in 4096 x 4096; a parallel view has just so
    // many pixels.
    const auto divides = [&](int side, int views) {
        return views >= 1 && (said.eyes ? side >= views : side % views == 0);
    };
    if (!divides(quilt.image.width, grid.columns) || !divides(quilt.image.height, grid.rows))
        throw UsageError(input + ": " + std::to_string(quilt.image.width) + "x" +
                         std::to_string(quilt.image.height) + " pixels are not " +
                         std::to_string(grid.columns) + "x" + std::to_string(grid.rows) +
                         " equal views");
    all.views = views_of_quilt(quilt.image, grid);
    return all;
}

bool of_one_kind(const QuiltRecord& a, const QuiltRecord& b)
{
    return a.grid.columns == b.grid.columns && a.grid.rows == b.grid.rows &&
           a.eyes.has_value() == b.eyes.has_value();
}

/// Files that say which view each is; or, where they do not, in the order in which they are given.
GivenViews read_files(const Words& inputs, const ViewsSaid& said)
{
    GivenViews all;
    std::map<int, Image> by_number;
    for (const std::string& input : inputs) {
        stop_if_interrupted();
        Views file = read_views(input, !said.ignore_documents);
        if (file.metadata && all.metadata &&
            !of_one_kind(*file.metadata->quilt, *all.metadata->quilt))
            throw UsageError(input + ": it is a view of another set than the files before it");
        const bool numbered = file.metadata && file.metadata->quilt->view;
        const int number = numbered ? *file.metadata->quilt->view : int(by_number.size());
        if (!by_number.emplace(number, std::move(file.image)).second)
            throw UsageError(input + ": another file is view " + std::to_string(number) +
                             " as well");
        if (file.metadata)
            all.metadata = file.metadata;
    }
    all.grid = said.grid      ? *said.grid
               : all.metadata ? all.metadata->quilt->grid
                              : ViewGrid{int(inputs.size()), 1};
    if (int(by_number.size()) != all.grid.count() ||
        by_number.rbegin()->first != all.grid.count() - 1)
        throw UsageError(std::to_string(inputs.size()) + " files are not the " +
                         std::to_string(all.grid.columns) + "x" + std::to_string(all.grid.rows) +
                         " views; --views CxR would tell how many there are");
    for (auto& [number, image] : by_number)
        all.views.push_back(std::move(image));
    return all;
}

} // namespace

GivenViews read_given_views(const Words& inputs, const ViewsSaid& said)
{
    return inputs.size() == 1 ? read_quilt(inputs[0], said) : read_files(inputs, said);
}

GivenViews read_given_views(const options::variables_map& arguments, const Words& inputs, bool eyes)
{
    std::optional<ViewGrid> grid;
    if (given(arguments, "views"))
        grid = parse_view_grid(arguments);
    return read_given_views(inputs, {grid, given(arguments, "sheet"), eyes});
}

std::vector<Image> views_of_eyes(const Frame& frame, ViewGrid grid, PixelSize size, int threads)
{
    View view;
    view.width = size.width;
    view.height = size.height;
    const Eye middle = centre_eye(*frame.metadata);
    auto pictures = replay_each(
        frame, view,
        eye_grid(middle, grid.columns, grid.rows, viewing_zone(*frame.metadata, middle.distance)),
        threads, progress_bar("views"));
    if (!pictures)
        throw Interrupted();
    std::vector<Image> views; // by number: the bottom row first
    for (int row = grid.rows; row-- > 0;)
        std::move(pictures->begin() + row * grid.columns,
                  pictures->begin() + (row + 1) * grid.columns, std::back_inserter(views));
    return views;
}

} // namespace integral
