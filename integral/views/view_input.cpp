// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/view_input.h"

#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/io/image_file.h"
#include "integral/io/video.h"
#include "integral/io/video_reader.h"
#include "integral/replay/arrange.h"
#include "integral/views/quilt.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace integral {

namespace {

/// The views of an MPO or a stereo OpenEXR, which stand from left to right.
ViewInput read_list(const std::string& input, const ViewsRequest& request)
{
    ViewInput all;
    all.views = read_list_of_views(input);
    all.grid = request.grid.value_or(ViewGrid{int(all.views.size()), 1});
    if (all.grid.count() != int(all.views.size()))
        throw RequestError(input + ": it holds " + std::to_string(all.views.size()) +
                           " views; leave --views out");
    return all;
}

/// The number of a quilt's views across and up: as requested, or from its metadata or its name.
/// Throws RequestError if none of these states it, or if the metadata differ from the request.
ViewGrid grid_of_quilt(const std::string& input, const Views& quilt,
                       const std::optional<ViewGrid>& asked)
{
    if (!quilt.metadata) {
        if (asked)
            return *asked;
        const auto name = quilt_in_name(input);
        if (!name)
            throw RequestError(input +
                               ": its name does not end in _qsCxRaASPECT; --views CxR would tell");
        return name->grid;
    }
    const ViewGrid held = quilt.metadata->quilt->grid;
    if (asked && (held.columns != asked->columns || held.rows != asked->rows))
        throw RequestError(input + ": it says that it holds " + std::to_string(held.columns) + "x" +
                           std::to_string(held.rows) + " views; leave --views out");
    return held;
}

/// Throws RequestError if a picture of that form does not hold the views of that grid.
void check_grid(const std::string& input, const Image& form, ViewGrid grid, bool of_eyes)
{
    // A quilt of perspective views may have unused pixels, like 5 x 9 views in 4096 x 4096 pixels;
    // parallel views have one pixel for each lens, so they must fill their quilt exactly.
    const auto divides = [&](int side, int views) {
        return views >= 1 && (of_eyes ? side >= views : side % views == 0);
    };
    if (!divides(form.width, grid.columns) || !divides(form.height, grid.rows))
        throw RequestError(input + ": " + std::to_string(form.width) + "x" +
                           std::to_string(form.height) + " pixels are not " +
                           std::to_string(grid.columns) + "x" + std::to_string(grid.rows) +
                           " equal views");
}

/// The views of one picture of a quilt video.
ViewInput read_quilt_of_video(const std::string& input, const ViewsRequest& request)
{
    if (!request.video_time)
        throw RequestError(input + ": it is a video; --at SECONDS selects one of its pictures");
    ViewInput all;
    all.grid = grid_of_quilt(input, {}, request.grid);
    const Image quilt = picture_of_video(input, *request.video_time);
    check_grid(input, quilt, all.grid, request.of_eyes);
    all.views = views_of_quilt(quilt, all.grid);
    return all;
}

ViewInput read_quilt(const std::string& input, const ViewsRequest& request)
{
    ViewsReader file(input, request.needs_geometry);
    const Views& quilt = file.head();
    const ViewGrid grid = grid_of_quilt(input, quilt, request.grid);
    ViewInput all;
    all.grid = grid;
    all.metadata = quilt.metadata;
    if (quilt.metadata && quilt.metadata->quilt->view && grid.count() > 1)
        throw RequestError(input + ": it is view " + std::to_string(*quilt.metadata->quilt->view) +
                           " of " + std::to_string(grid.count()) +
                           "; give the files of all of them");
    check_grid(input, quilt.image, grid, request.of_eyes);
    file.check_memory();
    all.views = views_of_quilt(quilt.image, grid, [&](Image& band) {
        stop_if_interrupted();
        file.read(band);
    });
    return all;
}

bool of_one_kind(const QuiltRecord& a, const QuiltRecord& b)
{
    return a.grid.columns == b.grid.columns && a.grid.rows == b.grid.rows &&
           a.eyes.has_value() == b.eyes.has_value();
}

/// Reads files in the order of their view numbers or, without these, in the order given.
ViewInput read_files(const std::vector<std::string>& inputs, const ViewsRequest& request)
{
    ViewInput all;
    std::map<int, Image> by_number;
    for (const std::string& input : inputs) {
        stop_if_interrupted();
        Views file = read_views(input, request.needs_geometry);
        if (file.metadata && all.metadata &&
            !of_one_kind(*file.metadata->quilt, *all.metadata->quilt))
            throw RequestError(input + ": it is a view of another set than the files before it");
        const bool numbered = file.metadata && file.metadata->quilt->view;
        const int number = numbered ? *file.metadata->quilt->view : int(by_number.size());
        if (!by_number.emplace(number, std::move(file.image)).second)
            throw RequestError(input + ": another file is view " + std::to_string(number) +
                               " as well");
        if (file.metadata)
            all.metadata = file.metadata;
    }
    all.grid = request.grid   ? *request.grid
               : all.metadata ? all.metadata->quilt->grid
                              : ViewGrid{int(inputs.size()), 1};
    if (int(by_number.size()) != all.grid.count() ||
        by_number.rbegin()->first != all.grid.count() - 1)
        throw RequestError(std::to_string(inputs.size()) + " files are not the " +
                           std::to_string(all.grid.columns) + "x" + std::to_string(all.grid.rows) +
                           " views; --views CxR would tell how many there are");
    for (auto& [number, image] : by_number)
        all.views.push_back(std::move(image));
    return all;
}

/// The views' shape in a quilt's name. Throws RequestError if the shape is implausible.
std::optional<double> shape_in_name(const std::string& input, const Image& view)
{
    constexpr double longest_pixel = 4; // its length / its width; quilts of displays reach 1.8
    const auto name = quilt_in_name(input);
    if (!name)
        return std::nullopt;
    const double pixel = name->aspect * view.height / view.width;
    if (std::max(pixel, 1 / pixel) > longest_pixel)
        throw RequestError(input + ": its name states that a view's width by its height is " +
                           with_digits(name->aspect, 6) + ", and the views have " +
                           size_text(view.width, view.height) +
                           " pixels; --aspect A states what is meant");
    return name->aspect;
}

void set_shape(ViewInput& given, const std::vector<std::string>& inputs,
               const ViewsRequest& request)
{
    const Image& view = given.views.at(0);
    const bool is_quilt = inputs.size() == 1 && !is_list_of_views(inputs[0]);
    std::optional<double> stated = request.aspect;
    if (!stated && given.metadata && given.metadata->film.width > 0)
        stated = shape_of(given.metadata->film);
    if (!stated && is_quilt && request.of_eyes) // a parallel view's pixels are as large as lenses
        stated = shape_in_name(inputs[0], view);
    given.shape = stated.value_or(double(view.width) / view.height);
    given.shape_is_assumed = is_quilt && !stated;
}

} // namespace

ViewInput read_given_views(const std::vector<std::string>& inputs, const ViewsRequest& request)
{
    ViewInput given = inputs.size() > 1             ? read_files(inputs, request)
                      : is_list_of_views(inputs[0]) ? read_list(inputs[0], request)
                      : is_video(inputs[0])         ? read_quilt_of_video(inputs[0], request)
                                                    : read_quilt(inputs[0], request);
    set_shape(given, inputs, request);
    return given;
}

void turn_right_to_left(std::vector<Image>& views, ViewGrid directions)
{
    for (int row = 0; row < directions.rows; ++row) {
        const auto first = views.begin() + row * directions.columns;
        std::reverse(first, first + directions.columns);
    }
}

std::string fit_text(const ViewInput& given, const FittedPicture& picture,
                     const std::string& target)
{
    return fit_text(picture, target) +
           (given.shape_is_assumed ? "; --aspect A states another shape of the views" : "");
}

std::vector<Image> views_of_eyes(const Frame& frame, ViewGrid grid, const View& view, int threads,
                                 const Progress& progress)
{
    const Eye middle = centre_eye(*frame.metadata);
    auto pictures = replay_each(
        frame, view,
        eye_grid(middle, grid.columns, grid.rows, viewing_zone(*frame.metadata, middle.distance)),
        threads, progress);
    if (!pictures)
        throw Interrupted();
    std::vector<Image> views; // by number: the bottom row first
    for (int row = grid.rows; row-- > 0;)
        std::move(pictures->begin() + row * grid.columns,
                  pictures->begin() + (row + 1) * grid.columns, std::back_inserter(views));
    return views;
}

} // namespace integral
