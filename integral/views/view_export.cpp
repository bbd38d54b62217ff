// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/view_export.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"
#include "integral/replay/fit_part.h"
#include "integral/views/parallel_views.h"
#include "integral/views/quilt.h"
#include "integral/views/rgbd.h"
#include "integral/views/view_files.h"
#include "integral/views/view_input.h"

#include <algorithm>

namespace integral {
namespace {

std::string text_of(ViewGrid grid) { return size_text(grid.columns, grid.rows); }
std::string text_of(PixelSize size) { return size_text(size.width, size.height); }

void check_view_size(PixelSize size)
{
    if (std::max(size.width, size.height) > largest_picture_side)
        throw RequestError("views of " + text_of(size) + " pixels have more than " +
                           std::to_string(largest_picture_side) + " one way");
}

void check_quilt_size(ViewGrid grid, PixelSize size)
{
    if (std::max(double(grid.columns) * size.width, double(grid.rows) * size.height) >
        largest_picture_side)
        throw RequestError("a quilt of " + text_of(grid) + " views of " + text_of(size) +
                           " pixels has more than " + std::to_string(largest_picture_side) +
                           " one way; fewer views would do");
}

/// The number of views: as requested, else natural_views.
ViewGrid grid_of(const ViewExport& requested, const std::string& name,
                 const FrameMetadata& metadata)
{
    if (requested.grid)
        return *requested.grid;
    const ViewGrid grid = natural_views(metadata);
    if (grid.columns > metadata.film.width || grid.rows > metadata.film.height)
        throw RequestError(
            name + ": a lens is as large as " + text_of(grid) +
            " pixels, more than the whole film; --views CxR would tell how many views to take");
    return grid;
}

/// A view for display: its size, and its part of the sheet.
struct FittedView {
    View view;
    FittedPicture picture;
    bool is_whole() const { return picture.size.x == 1 && picture.size.y == 1; }
};

/// The displayed shape of views: a stated one, the shape with square pixels, or else the film's
/// shape, whatever the pixels are.
struct SeenShape {
    std::optional<double> stated;
    bool of_square_pixels = false;
};

FittedView view_to_look_at(const ViewExport& requested, const FrameMetadata& metadata,
                           SeenShape shape)
{
    FittedView made;
    if (shape.stated)
        made.picture = fit_part(made.view, metadata, *shape.stated, requested.fit);
    set_view_size(made.view, metadata.film, default_longer_side_of_view);
    if (!requested.size)
        return made;
    made.view.width = requested.size->width;
    made.view.height = requested.size->height;
    if (shape.of_square_pixels)
        made.picture = fit_part_to_size(made.view, metadata, requested.fit);
    return made;
}

/// Notifies the user how the film was fitted into the shape of `target`.
void tell_fit(const ViewExport& requested, const std::string& name, const FittedPicture& picture,
              const std::string& target)
{
    if (picture.differs())
        requested.tell(name + ": " + fit_text(picture, target));
}

/// A pixel for each lens.
PixelSize size_of_parallel_views(const std::string& name, const FrameMetadata& metadata)
{
    try {
        const LensWindow window = lens_window(metadata);
        return {window.columns, window.rows};
    } catch (const std::invalid_argument& error) {
        throw RequestError(name + ": " + error.what());
    }
}

/// The quilt's path, which contains the number of views.
std::string quilt_path(const std::string& output, ViewGrid grid, double shape)
{
    const std::string path = output == "-" ? output : quilt_name(output, grid, shape);
    const auto named = quilt_in_name(path);
    if (named && (named->grid.columns != grid.columns || named->grid.rows != grid.rows))
        throw RequestError("-o " + output + ": its name says " + text_of(named->grid) +
                           " views, but there are " + text_of(grid));
    check_writable(path);
    return path;
}

PictureSeries series_of(const ViewExport& requested, const std::string& path, int count, int first,
                        bool there_and_back)
{
    AnimationSettings settings = requested.animation;
    settings.there_and_back = there_and_back;
    return PictureSeries(path, settings, count, first);
}

/// Notifies the user of the loss from the frame to its views and back, if there is any.
void tell_loss(const Frame& frame, ViewGrid grid, const ViewExport& requested)
{
    if (views_are_exact(*frame.metadata, grid))
        return;
    const auto psnr = psnr_there_and_back(frame, grid, requested.threads,
                                          requested.progress("there and back"));
    if (!psnr)
        throw Interrupted();
    requested.tell("the views are interpolated between the film's pixels: made into a frame again, "
                   "PSNR " +
                   with_decimals(*psnr, 1) + " dB");
}

/// The destination of views: a series of files or an animation, else a quilt.
struct ViewsOutput {
    std::string path;
    std::optional<PictureSeries> series;
};

/// Writes parallel views, a pixel for each lens.
void make_parallel_views(ViewsOutput& output, const Frame& frame, ViewGrid grid,
                         const ViewExport& requested)
{
    const ViewGrid directions = directions_of(grid, frame.metadata->sheet);
    tell_loss(frame, directions, requested);
    FrameMetadata metadata = *frame.metadata;
    metadata.quilt = QuiltRecord{grid, std::nullopt, std::nullopt};
    const ParallelViews views(frame, directions);
    const Progress bar = requested.progress("views");
    if (output.series)
        write_views(*output.series, frame, views, grid, metadata, requested.threads, bar);
    else
        write_quilt(output.path, frame, views, grid, metadata, requested.threads, bar);
}

/// Writes views for display, with the geometry of the frame that they are views of, if any.
void write_pictures(ViewsOutput& output, std::vector<Image> views, ViewGrid grid,
                    ViewGrid directions, std::optional<FrameMetadata> metadata)
{
    if (is_animation(output.path))
        return write_animation(*output.series, views, directions);
    if (!output.series)
        return write_frame(output.path, Frame{quilt_of_views(std::move(views), grid), metadata});
    for (int k = 0; k < grid.count(); ++k) {
        if (metadata)
            metadata->quilt->view = k;
        output.series->add(std::move(views[std::size_t(k)]), metadata);
    }
}

/// Writes views for display: views of eyes, or parallel views turned upright.
void make_pictures(ViewsOutput& output, const Frame& frame, ViewGrid grid, const FittedView& fitted,
                   const ViewExport& requested)
{
    const bool of_eyes = requested.kind == ViewKind::of_eyes;
    const ViewGrid directions = directions_of(grid, frame.metadata->sheet);
    std::vector<Image> views = (of_eyes ? views_of_eyes : upright_views)(
        frame, directions, fitted.view, requested.threads, requested.progress("views"));
    std::optional<FrameMetadata> metadata; // no frame can be made of upright views
    if (of_eyes && fitted.is_whole()) {
        metadata = *frame.metadata;
        const double distance = metadata->aperture.distance;
        metadata->quilt = QuiltRecord{grid, std::nullopt,
                                      EyeGrid{viewing_zone(*metadata, distance), distance}};
    }
    write_pictures(output, std::move(views), grid, directions, metadata);
}

/// The displayed shape of views in a quilt of that path.
SeenShape shape_of_quilt(const ViewExport& requested, const std::string& path,
                         const std::string& name, const Film& film)
{
    const auto named = quilt_in_name(path);
    if (!named)
        return {std::nullopt, requested.kind == ViewKind::upright};
    if (requested.kind == ViewKind::parallel &&
        fitted(shape_of(film), named->aspect, requested.fit).differs())
        throw RequestError("-o " + path + ": its name states the shape (width/height) " +
                           with_digits(named->aspect, 3) + ", and that of " + name + " is " +
                           with_digits(shape_of(film), 3) +
                           "; a name without _qs gets the right end, and --upright or --eyes fit "
                           "views into another shape");
    return {named->aspect, false};
}

/// The displayed shape of views in files and animations. Files of eyes carry the film's geometry;
/// notifies the user if their pixels are not square.
SeenShape shape_of_files(const ViewExport& requested, const Film& film)
{
    if (!requested.files || requested.kind != ViewKind::of_eyes)
        return {std::nullopt, true};
    if (requested.size && fitted(double(requested.size->width) / requested.size->height,
                                 shape_of(film), requested.fit)
                              .differs())
        requested.tell("views of " + text_of(*requested.size) +
                       " pixels: these are not square, as the film's shape (width/height) is " +
                       with_digits(shape_of(film), 3) +
                       "; programs that take them for square show the views stretched");
    return {};
}

} // namespace

std::string write_views_of_frame(const std::string& name, const ViewExport& requested)
{
    const Frame frame = read_sheet_frame(name, requested.sheet);
    stop_if_interrupted();
    const FrameMetadata& metadata = *frame.metadata;
    const ViewGrid grid = grid_of(requested, name, metadata);
    ViewsOutput output{requested.output, std::nullopt};
    SeenShape shape;
    if (requested.files || is_animation(requested.output)) {
        output.series.emplace(series_of(requested, requested.output, grid.count(), 0, true));
        shape = shape_of_files(requested, metadata.film);
    } else {
        output.path = quilt_path(requested.output, grid, shape_of(metadata.film));
        shape = shape_of_quilt(requested, output.path, name, metadata.film);
    }
    const FittedView fitted = view_to_look_at(requested, metadata, shape);
    const PixelSize size{fitted.view.width, fitted.view.height};
    // Also checks upright views, which are refused where there are no parallel views.
    const PixelSize parallel = requested.kind == ViewKind::of_eyes
                                   ? size
                                   : size_of_parallel_views(name, metadata);
    const PixelSize of_a_view = requested.kind == ViewKind::upright ? size : parallel;
    check_view_size(of_a_view);
    if (!output.series)
        check_quilt_size(grid, of_a_view);

    if (requested.kind == ViewKind::parallel) {
        make_parallel_views(output, frame, grid, requested);
    } else {
        tell_fit(requested, name, fitted.picture, output.series ? "--size" : "the quilt");
        make_pictures(output, frame, grid, fitted, requested);
    }
    return output.path;
}

void check_views_of_eyes(const EyeViews& form, const ViewExport& requested)
{
    check_view_size(form.size);
    if (requested.files || is_animation(requested.output))
        return;
    check_quilt_size(form.grid, form.size);
    const std::string path = quilt_path(requested.output, form.grid, form.shape);
    const auto named = quilt_in_name(path);
    if (named && fitted(form.shape, named->aspect, Fit::contain).differs())
        throw RequestError("-o " + path + ": its name states the shape (width/height) " +
                           with_digits(named->aspect, 3) + ", and that of the views is " +
                           with_digits(form.shape, 3) + "; a name without _qs gets the right end");
}

std::string write_views_of_eyes(std::vector<Image> views, const EyeViews& form,
                                const ViewExport& requested)
{
    check_views_of_eyes(form, requested);
    ViewsOutput output{requested.output, std::nullopt};
    if (requested.files || is_animation(requested.output))
        output.series.emplace(series_of(requested, requested.output, form.grid.count(), 0, true));
    else
        output.path = quilt_path(requested.output, form.grid, form.shape);
    write_pictures(output, std::move(views), form.grid, form.directions, form.metadata);
    return output.path;
}

std::string write_quilts(const std::vector<std::string>& names, const ViewExport& requested)
{
    std::string path;
    std::optional<PictureSeries> series;
    const Progress bar = requested.progress("views");
    const int count = int(names.size());
    const ViewGrid grid = requested.grid.value();
    for (int k = 0; k < count; ++k) {
        const std::string& name = names[std::size_t(k)];
        const Frame frame = read_sheet_frame(name, requested.sheet);
        stop_if_interrupted();
        const Film& film = frame.metadata->film;
        if (!series)
            path = quilt_path(requested.output, grid, shape_of(film));
        const FittedView fitted = view_to_look_at(requested, *frame.metadata,
                                                  shape_of_quilt(requested, path, name, film));
        tell_fit(requested, name, fitted.picture, "the quilt");
        if (!series) {
            const PixelSize size{fitted.view.width, fitted.view.height};
            check_view_size(size);
            check_quilt_size(grid, size);
            series.emplace(series_of(requested, path, count, 1, false));
        }
        series->add(
            quilt_of_views(views_of_eyes(frame, directions_of(grid, frame.metadata->sheet),
                                         fitted.view, requested.threads, piece_of(bar, k, count)),
                           grid));
    }
    series->finish();
    return path;
}

void write_rgbd(const std::string& name, const std::string& depth_file, const ViewExport& requested)
{
    if (format_for(requested.output) == ImageFormat::exr)
        throw RequestError("-o " + requested.output +
                           ": colour and depth are stored values; .png or .tiff");
    check_writable(requested.output);
    const Frame frame = read_sheet_frame(name, requested.sheet);
    const DepthFrame depths = read_depths(depth_file);
    const FittedView fitted = view_to_look_at(requested, *frame.metadata, {std::nullopt, true});
    tell_fit(requested, name, fitted.picture, "--size");
    check_quilt_size({2, 1}, {fitted.view.width, fitted.view.height});
    std::optional<RgbdPicture> picture;
    try {
        picture = rgbd_picture(frame, depths, fitted.view, requested.threads,
                               requested.progress("views"));
    } catch (const std::invalid_argument& error) {
        throw RequestError("--rgbd " + depth_file + ": " + error.what());
    }
    if (!picture)
        throw Interrupted();
    write_frame(requested.output, Frame{std::move(picture->image), std::nullopt});
    requested.tell("depths: white is " + with_decimals(picture->white, 1) +
                   " mm behind the sheet, black " + with_decimals(picture->black, 1) +
                   " (negative: in front)");
}

} // namespace integral
