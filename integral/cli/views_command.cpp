// SPDX-License-Identifier: AGPL-3.0-or-later
// integral views: the views that are in a frame, as a quilt, an animation or files; and the frame
// of them.
#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/cli/views_options.h"
#include "integral/io/image_file.h"
#include "integral/output/given_views.h"
#include "integral/output/quilt.h"
#include "integral/replay/arrange.h"
#include "integral/replay/parallel_views.h"
#include "integral/replay/rgbd.h"
#include "integral/replay/view_files.h"

#include <algorithm>
#include <iostream>

namespace integral {

void declare(options::options_description& all, ViewsOptions& o)
{
    all.add_options()("output,o", fills(o.output, "FILE"),
                      "the quilt, or with --to-frame the frame: .png, .exr or .tiff; a quilt's "
                      "name gets _qsCxRaASPECT before the extension, "
                      "unless it has such an end; .webp, .webm or .mp4: an animation");
    all.add_options()("views", fills(o.views, "CxR"),
                      "the quilt's views across and up; those of lenticular lenses all go from "
                      "left to right, row after row from the bottom (default: as many as whole "
                      "pixels are nearest to a lens's; with --to-frame what the quilt says)");
    all.add_options()("eyes", sets(o.eyes),
                      "what eyes see that are spread over the frame's viewing zone, in place of "
                      "parallel views; needs --views");
    all.add_options()("files", sets(o.files),
                      "a file for each view, with its number before the extension, in place of a "
                      "quilt");
    all.add_options()("upright", sets(o.upright),
                      "parallel views as they look, of the film's shape and without the lenses' "
                      "slant, in place of a pixel a lens; not for --to-frame. "
                      "An animation's are");
    all.add_options()("size", fills(o.size, "WxH"),
                      "pixels of each view of --eyes and --upright (default: 500 on the longer "
                      "side)");
    all.add_options()("rgbd", fills(o.rgbd, "DEPTH.exr"),
                      "what the centre eye sees and, to its right, its depth frame "
                      "(Integral_Depth_Image), near white: for programs that make a quilt of "
                      "the two; .png or .tiff");
    all.add_options()("to-frame", sets(o.to_frame),
                      "back: the frame that shows the views of a quilt, or of files");
    all.add_options()("depth", fills(o.depth, "measured|FILE"),
                      "with --to-frame: make the frame by depth, for another sheet and film, out "
                      "of a frame, views of eyes or one photograph. The depth is measured in them "
                      "as integral depth does, or FILE has it: a depth frame, .pfm (mm behind the "
                      "sheet) or, with --depth-range, a grey picture");
    all.add_options()("depth-range", fills(o.depth_range, "WHITE,BLACK"),
                      "the depths, mm behind the sheet, of white and black in --depth's grey "
                      "picture; between them equal steps are equal steps of parallax");
    all.add_options()("sheet", fills(o.sheet, "FILE.json"),
                      "geometry of the frame (integral sheet FRAME --json writes it), if the "
                      "pictures do not carry it, or instead of that");
    declare(all, o.threads);
    declare(all, o.series);
}

namespace {

constexpr int largest_picture_side = 32768; // pixels

std::string text_of(ViewGrid grid)
{
    return std::to_string(grid.columns) + "x" + std::to_string(grid.rows);
}

std::string text_of(PixelSize size)
{
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

void check_view_size(PixelSize size)
{
    if (std::max(size.width, size.height) > largest_picture_side)
        throw UsageError("views of " + text_of(size) + " pixels have more than " +
                         std::to_string(largest_picture_side) + " one way");
}

void check_quilt_size(ViewGrid grid, PixelSize size)
{
    if (std::max(double(grid.columns) * size.width, double(grid.rows) * size.height) >
        largest_picture_side)
        throw UsageError("a quilt of " + text_of(grid) + " views of " + text_of(size) +
                         " pixels has more than " + std::to_string(largest_picture_side) +
                         " one way; fewer views would do");
}

/// The number of views: --views, else the film's whole pixels to a lens.
ViewGrid grid_of(const ViewsOptions& o, const FrameMetadata& metadata)
{
    if (o.views)
        return parse_view_grid(*o.views);
    const ViewGrid grid = natural_views(metadata);
    if (grid.columns > metadata.film.width || grid.rows > metadata.film.height)
        throw UsageError(
            o.inputs[0] + ": a lens is as large as " + text_of(grid) +
            " pixels, more than the whole film; --views CxR would tell how many views to take");
    return grid;
}

/// The size of a view for people to look at.
PixelSize size_to_look_at(const ViewsOptions& o, const Film& film)
{
    if (o.size)
        return parse_size("size", *o.size, largest_picture_side);
    constexpr int default_longer_side = 500;
    View view;
    set_view_size(view, film, default_longer_side);
    return {view.width, view.height};
}

/// A pixel for each lens.
PixelSize size_of_parallel_views(const std::string& input, const FrameMetadata& metadata)
{
    try {
        const LensWindow window = lens_window(metadata);
        return {window.columns, window.rows};
    } catch (const std::invalid_argument& error) {
        throw UsageError(input + ": " + error.what());
    }
}

/// The quilt's path, which names the number of views.
std::string quilt_path(const std::string& output, ViewGrid grid, const Film& film)
{
    const double aspect = film.width * film.pixel_pitch.x / (film.height * film.pixel_pitch.y);
    const std::string path = output == "-" ? output : quilt_name(output, grid, aspect);
    const auto named = grid_in_name(path);
    if (named && (named->columns != grid.columns || named->rows != grid.rows))
        throw UsageError("-o " + output + ": its name says " + text_of(*named) +
                         " views, but there are " + text_of(grid));
    check_writable(path);
    return path;
}

/// Says what is lost on the way there and back, if something is.
void state_loss(const Frame& frame, ViewGrid grid, int threads)
{
    if (views_are_exact(*frame.metadata, grid))
        return;
    const auto psnr = psnr_there_and_back(frame, grid, threads, progress_bar("there and back"));
    if (!psnr)
        throw Interrupted();
    say("views", "the views are interpolated between the film's pixels: made into a frame again, "
                 "PSNR " +
                     with_decimals(*psnr, 1) + " dB");
}

/// Where views go: into a series of files or an animation, else into a quilt.
struct ViewsOutput {
    std::string path;
    std::optional<PictureSeries> series;
};

/// Parallel views, a pixel for each lens.
void make_parallel_views(ViewsOutput& output, const Frame& frame, ViewGrid grid, int threads)
{
    const ViewGrid directions = directions_of(grid, frame.metadata->sheet);
    state_loss(frame, directions, threads);
    FrameMetadata metadata = *frame.metadata;
    metadata.quilt = QuiltRecord{grid, std::nullopt, std::nullopt};
    const ParallelViews views(frame, directions);
    const Progress bar = progress_bar("views");
    if (output.series)
        write_views(*output.series, frame, views, grid, metadata, threads, bar);
    else
        write_quilt(output.path, frame, views, grid, metadata, threads, bar);
}

/// Views to look at: of eyes, or parallel ones upright.
void make_pictures(ViewsOutput& output, const Frame& frame, ViewGrid grid, PixelSize size,
                   bool of_eyes, int threads)
{
    const ViewGrid directions = directions_of(grid, frame.metadata->sheet);
    std::vector<Image> views = of_eyes ? views_of_eyes(frame, directions, size.width, size.height,
                                                       threads, progress_bar("views"))
                                       : upright_views(frame, directions, size.width, size.height,
                                                       threads, progress_bar("views"));
    if (is_animation(output.path))
        return write_animation(*output.series, views, directions);
    std::optional<FrameMetadata> metadata; // no frame can be made of upright views
    if (of_eyes) {
        metadata = *frame.metadata;
        const double distance = metadata->aperture.distance;
        metadata->quilt = QuiltRecord{grid, std::nullopt,
                                      EyeGrid{viewing_zone(*metadata, distance), distance}};
    }
    if (!output.series)
        return write_frame(output.path, Frame{quilt_of_views(std::move(views), grid), metadata});
    for (int k = 0; k < grid.count(); ++k) {
        if (metadata)
            metadata->quilt->view = k;
        output.series->add(std::move(views[std::size_t(k)]), metadata);
    }
}

/// --rgbd: a picture and its depths.
int make_rgbd(const ViewsOptions& o, const std::string& output, int threads)
{
    if (format_for(output) == ImageFormat::exr)
        throw UsageError("-o " + output + ": colour and depth are stored values; .png or .tiff");
    check_writable(output);
    const Frame frame = read_sheet_frame(o.inputs[0], o.sheet.value_or(""));
    const DepthFrame depths = read_depths(*o.rgbd);
    PixelSize size = size_to_look_at(o, frame.metadata->film);
    check_quilt_size({2, 1}, size);
    try {
        auto picture = rgbd_picture(frame, depths, size.width, size.height, threads,
                                    progress_bar("views"));
        if (!picture)
            throw Interrupted();
        write_frame(output, Frame{std::move(picture->image), std::nullopt});
        say("views", "depths: white is " + with_decimals(picture->white, 1) +
                         " mm behind the sheet, black " + with_decimals(picture->black, 1) +
                         " (negative: in front)");
    } catch (const std::invalid_argument& error) {
        throw UsageError("--rgbd " + *o.rgbd + ": " + error.what());
    }
    return exit_done;
}

/// Several frames, those of an animation: an animation of their quilts.
int make_quilts(const ViewsOptions& o, const std::string& output, int threads)
{
    std::optional<PictureSeries> series;
    const Progress bar = progress_bar("views");
    const int count = int(o.inputs.size());
    for (int k = 0; k < count; ++k) {
        const Frame frame = read_sheet_frame(o.inputs[std::size_t(k)], o.sheet.value_or(""));
        stop_if_interrupted();
        const ViewGrid grid = parse_view_grid(*o.views);
        const PixelSize size = size_to_look_at(o, frame.metadata->film);
        if (!series) {
            check_view_size(size);
            check_quilt_size(grid, size);
            const std::string path = quilt_path(output, grid, frame.metadata->film);
            series.emplace(begin_series(o.series, path, count, 1, false));
            if (path != output)
                std::cout << path << '\n';
        }
        series->add(
            quilt_of_views(views_of_eyes(frame, directions_of(grid, frame.metadata->sheet),
                                         size.width, size.height, threads, piece_of(bar, k, count)),
                           grid));
    }
    series->finish();
    return exit_done;
}

int make_views(const ViewsOptions& o, const std::string& name, int threads)
{
    const std::string& input = o.inputs[0];
    const Frame frame = read_sheet_frame(input, o.sheet.value_or(""));
    stop_if_interrupted();
    const FrameMetadata& metadata = *frame.metadata;
    const bool animated = is_animation(name), upright = !o.eyes && (animated || o.upright);
    const ViewGrid grid = grid_of(o, metadata);
    const PixelSize size = size_to_look_at(o, metadata.film);
    ViewsOutput output{name, std::nullopt};
    if (o.files || animated)
        output.series.emplace(begin_series(o.series, name, grid.count(), 0, true));
    else
        output.path = quilt_path(name, grid, metadata.film);
    // Also of upright ones, which are refused where there are no parallel views.
    const PixelSize parallel = o.eyes ? size : size_of_parallel_views(input, metadata);
    const PixelSize of_a_view = upright ? size : parallel;
    check_view_size(of_a_view);
    if (!output.series)
        check_quilt_size(grid, of_a_view);

    if (o.eyes || upright)
        make_pictures(output, frame, grid, size, o.eyes, threads);
    else
        make_parallel_views(output, frame, grid, threads);
    if (output.path != name)
        std::cout << output.path << '\n';
    return exit_done;
}

/// Refuses options that do not go together. Throws UsageError.
void check_options(const ViewsOptions& o, bool animated)
{
    if (o.files && (o.to_frame || animated))
        throw UsageError(std::string("--files does not go with ") +
                         (o.to_frame ? "--to-frame" : "an animation"));
    if (o.eyes && !o.to_frame && !o.views)
        throw UsageError("--eyes needs --views CxR, how many eyes");
    if (o.upright && (o.to_frame || o.eyes))
        throw UsageError(std::string("--upright does not go with ") +
                         (o.to_frame ? "--to-frame" : "--eyes, whose views are upright"));
    if (o.size && (o.to_frame || (!o.eyes && !animated && !o.upright && !o.rgbd)))
        throw UsageError(
            "--size is for --eyes, --upright, --rgbd and animations; else parallel views have "
            "a pixel a lens");
    if (o.depth && !o.to_frame)
        throw UsageError("--depth is for --to-frame; integral depth measures depth");
    if (o.depth_range && (!o.depth || o.depth == "measured"))
        throw UsageError("--depth-range is for a grey picture as --depth");
    if (o.rgbd && (o.to_frame || o.eyes || o.upright || o.files || o.views || animated))
        throw UsageError("--rgbd makes one picture, of one view; only --size and --sheet go with "
                         "it");
    if (!o.to_frame && o.inputs.size() > 1 && !(animated && o.eyes))
        throw UsageError("one frame is expected; several frames make an animation of quilts, by "
                         "--eyes --views CxR and -o FILE.webm, .mp4 or .webp, and --to-frame "
                         "takes several views");
}

int run(const ViewsOptions& o)
{
    const std::string output = o.output.value_or("");
    if (output.empty())
        throw UsageError("-o FILE is missing");
    if (is_mpo(output))
        throw UsageError("-o " + output + ": integral replay --stereo MM makes pairs");
    const bool animated = is_animation(output);
    if (!animated || o.to_frame)
        format_for(output);
    check_series_options(o.series, output);
    check_options(o, animated);
    const int threads = o.threads.count();
    if (o.to_frame)
        return o.depth ? make_frame_with_depth(o, output, threads) : make_frame(o, output, threads);
    if (o.rgbd)
        return make_rgbd(o, output, threads);
    return o.inputs.size() > 1 ? make_quilts(o, output, threads) : make_views(o, output, threads);
}

} // namespace

const Command views_command = {
    "views",
    "the views that are in a frame, as a quilt, files or an animation; and back",
    "FRAME -o QUILT [--views CxR] [--eyes] | FRAME --rgbd DEPTH.exr -o PICTURE | FRAME... --eyes "
    "--views CxR -o QUILTS.webm | --to-frame VIEWS... -o FRAME [--sheet FILE.json] [--depth "
    "measured|FILE]",
    "Takes a frame apart into its parallel views: what eyes endlessly far away see, a pixel a\n"
    "lens, one view for each direction (thesis 5.3). They stand in one picture, a quilt: view 0,\n"
    "from the far left and below, at the bottom left, the last at the top right. With whole\n"
    "pixels a lens nothing is lost, and --to-frame gives the frame back to the bit. Quilts and\n"
    "files carry the frame's geometry, so that nothing else has to be said on the way back;\n"
    "other programs' need --sheet.\n",
    1,
    most_views_a_side* most_views_a_side,
    described<ViewsOptions>,
    run_with<ViewsOptions, run>};

} // namespace integral
