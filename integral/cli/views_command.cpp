// SPDX-License-Identifier: AGPL-3.0-or-later
// integral views: the views that are in a frame, as a quilt, an animation or files; and the frame
// of them.
#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/cli/picture_series.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/cli/views_to_frame.h"
#include "integral/io/image_file.h"
#include "integral/output/given_views.h"
#include "integral/output/quilt.h"
#include "integral/replay/arrange.h"
#include "integral/replay/parallel_views.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <iostream>
#include <optional>

namespace integral {
namespace {

constexpr int largest_side = 32768;

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()("output,o", options::value<std::string>()->value_name("FILE"),
                      "the quilt, or with --to-frame the frame: .png, .exr or .tiff; a quilt's "
                      "name gets _qsCxRaASPECT before the extension, "
                      "unless it has such an end; .webp: an animation")(
        "views", options::value<std::string>()->value_name("CxR"),
        "views across and up (default: as many as whole pixels are nearest to a lens's; with "
        "--to-frame what the quilt says)")("eyes", options::bool_switch(),
                                           "what eyes see that are spread over the frame's viewing "
                                           "zone, in place of parallel views; needs --views")(
        "files", options::bool_switch(),
        "a file for each view, with its number before the extension, in place of a quilt")(
        "upright", options::bool_switch(),
        "parallel views as they look, of the film's shape and without the lenses' slant, in place "
        "of a pixel a lens; not for --to-frame. "
        "An animation's are")(
        "size", options::value<std::string>()->value_name("WxH"),
        "pixels of each view of --eyes and --upright (default: 500 on the longer side)")(
        "to-frame", options::bool_switch(),
        "back: the frame that shows the views of a quilt, or of files")(
        "sheet", options::value<std::string>()->value_name("FILE.json"),
        "geometry of the frame (integral sheet FRAME --json writes it), if the pictures do not "
        "carry it, or instead of that")(
        "threads", options::value<int>()->value_name("N")->default_value(0),
        "threads to work with (0: one per core)")("help", "print this");
    add_series_options(all);
    return all;
}

void check_view_size(int width, int height)
{
    if (std::max(width, height) > largest_side)
        throw UsageError("views of " + std::to_string(width) + "x" + std::to_string(height) +
                         " pixels have more than " + std::to_string(largest_side) + " one way");
}

void check_quilt_size(ViewGrid grid, int width, int height)
{
    if (std::max(double(grid.columns) * width, double(grid.rows) * height) > largest_side)
        throw UsageError("a quilt of " + std::to_string(grid.columns) + "x" +
                         std::to_string(grid.rows) + " views of " + std::to_string(width) + "x" +
                         std::to_string(height) + " pixels has more than " +
                         std::to_string(largest_side) + " one way; fewer views would do");
}

double aspect_of(const Film& film)
{
    return film.width * film.pixel_pitch.x / (film.height * film.pixel_pitch.y);
}

/// The size of a view for people to look at.
PixelSize size_to_look_at(const options::variables_map& arguments, const Film& film)
{
    if (given(arguments, "size"))
        return parse_size("size", text_of(arguments, "size"), largest_side);
    constexpr int default_longer_side = 500;
    View view;
    set_view_size(view, film, default_longer_side);
    return {view.width, view.height};
}

/// Parallel views as they look: upright and of the film's shape. Black where the lenses reflect
/// totally.
std::vector<Image> upright_views(const Frame& frame, ViewGrid grid, PixelSize size, int threads)
{
    View view;
    view.width = size.width;
    view.height = size.height;
    std::vector<Image> views;
    const Progress bar = progress_bar("views");
    for (const auto& eye : far_eyes(*frame.metadata, grid)) {
        auto picture = eye ? replay_each(frame, view, {*eye}, threads,
                                         piece_of(bar, int(views.size()), grid.count()))
                           : std::vector<Image>{blank_like(frame.image, size.width, size.height)};
        if (!picture)
            throw Interrupted();
        views.push_back(std::move(picture->front()));
    }
    return views;
}

/// Says what is lost on the way there and back, where something is.
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

/// Makes some rows, which draw(row) does, in `threads` threads.
template <class Draw> void draw_rows(int rows, int threads, Draw draw)
{
    stop_if_interrupted();
    for_each_row(rows, threads, draw);
}

/// The quilt of parallel views, some rows at a time.
void write_quilt(const std::string& path, const Frame& frame, const ParallelViews& views,
                 ViewGrid grid, const FrameMetadata& metadata, int threads)
{
    Image form = form_of(frame.image);
    form.width = grid.columns * views.width();
    form.height = grid.rows * views.height();
    PictureWriter file = PictureWriter::of_frame(path, form, metadata);
    const Progress bar = progress_bar("views");
    const int most = rows_of_a_band(form);
    for (int first = 0; first < form.height; first += most) {
        Image band = blank_like(form, form.width, std::min(most, form.height - first));
        draw_rows(band.height, threads, [&](int y) {
            const int row = grid.rows - 1 - (first + y) / views.height(); // view 0 is at the bottom
            for (int column = 0; column < grid.columns; ++column)
                views.draw(row * grid.columns + column, (first + y) % views.height(), band,
                           column * views.width(), y);
        });
        file.write(band);
        bar(first + band.height, form.height);
    }
    stop_if_interrupted();
    file.finish();
}

/// Parallel views as files of their own.
void write_views(PictureSeries& series, const Frame& frame, const ParallelViews& views,
                 ViewGrid grid, FrameMetadata metadata, int threads)
{
    const Progress bar = progress_bar("views");
    for (int k = 0; k < grid.count(); ++k) {
        Image view = blank_like(frame.image, views.width(), views.height());
        draw_rows(view.height, threads, [&](int y) { views.draw(k, y, view, 0, y); });
        metadata.quilt->view = k;
        series.add(std::move(view), metadata);
        bar(k + 1, grid.count());
    }
}

/// Row by row upwards, the even rows from the left, the odd ones from the right: each view beside
/// the one before.
void play(PictureSeries& series, const std::vector<Image>& views, ViewGrid grid)
{
    for (int row = 0; row < grid.rows; ++row)
        for (int i = 0; i < grid.columns; ++i) {
            stop_if_interrupted();
            series.add(views[row * grid.columns + (row % 2 ? grid.columns - 1 - i : i)]);
        }
    series.finish(true);
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

int make_views(const options::variables_map& arguments, const std::string& output, int threads)
{
    const Frame frame = read_frame_with_metadata(inputs_of(arguments)[0],
                                                 text_of(arguments, "sheet"));
    stop_if_interrupted();
    const FrameMetadata& metadata = *frame.metadata;
    const bool eyes = arguments["eyes"].as<bool>(), files = arguments["files"].as<bool>(),
               animated = is_animation(output);
    const bool upright = !eyes && (animated || arguments["upright"].as<bool>());
    const ViewGrid grid = given(arguments, "views") ? parse_view_grid(text_of(arguments, "views"))
                                                    : natural_views(metadata);
    if (!given(arguments, "views") &&
        (grid.columns > metadata.film.width || grid.rows > metadata.film.height))
        throw UsageError(
            inputs_of(arguments)[0] + ": a lens is as large as " + std::to_string(grid.columns) +
            "x" + std::to_string(grid.rows) +
            " pixels, more than the whole film; --views CxR would tell how many views to take");
    const PixelSize size = size_to_look_at(arguments, metadata.film);
    std::optional<PictureSeries> series;
    if (files || animated)
        series.emplace(arguments, output, grid.count(), 0);
    const std::string path = series || output == "-"
                                 ? output
                                 : quilt_name(output, grid, aspect_of(metadata.film));
    if (!series) {
        const auto named = grid_in_name(path);
        if (named && (named->columns != grid.columns || named->rows != grid.rows))
            throw UsageError("-o " + output + ": its name says " + std::to_string(named->columns) +
                             "x" + std::to_string(named->rows) + " views, but there are " +
                             std::to_string(grid.columns) + "x" + std::to_string(grid.rows));
        check_writable(path);
    }

    if (metadata.sheet.arrangement == Arrangement::lenticular && grid.rows > 1)
        throw UsageError("--views " + text_of(arguments, "views") +
                         ": lenticular lenses show nothing new from above: one row is expected");
    const PixelSize of_lenses = eyes ? size
                                     : size_of_parallel_views(inputs_of(arguments)[0],
                                                              metadata); // refuses what has none
    const PixelSize of_a_view = upright ? size : of_lenses;
    check_view_size(of_a_view.width, of_a_view.height);
    if (!series)
        check_quilt_size(grid, of_a_view.width, of_a_view.height);

    FrameMetadata of_views = metadata;
    of_views.quilt = QuiltRecord{grid, std::nullopt, std::nullopt};
    if (!eyes && !upright) {
        state_loss(frame, grid, threads);
        const ParallelViews views(frame, grid);
        if (files)
            write_views(*series, frame, views, grid, of_views, threads);
        else
            write_quilt(path, frame, views, grid, of_views, threads);
    } else {
        std::vector<Image> views = eyes ? views_of_eyes(frame, grid, size.width, size.height,
                                                        threads, progress_bar("views"))
                                        : upright_views(frame, grid, size, threads);
        if (eyes)
            of_views.quilt->eyes = EyeGrid{viewing_zone(metadata, metadata.aperture.distance),
                                           metadata.aperture.distance};
        const auto about = [&](std::optional<int> view) -> std::optional<FrameMetadata> {
            if (upright)
                return std::nullopt; // to look at; there is no way back from them
            of_views.quilt->view = view;
            return of_views;
        };
        if (animated)
            play(*series, views, grid);
        for (int k = 0; k < (files ? grid.count() : 0); ++k)
            series->add(std::move(views[std::size_t(k)]), about(k));
        if (!series)
            write_frame(path, Frame{quilt_of_views(std::move(views), grid), about(std::nullopt)});
    }
    if (!series && path != output)
        std::cout << path << '\n';
    return exit_done;
}

int run(const options::variables_map& arguments)
{
    const std::string output = text_of(arguments, "output");
    if (output.empty())
        throw UsageError("-o FILE is missing");
    const bool back = arguments["to-frame"].as<bool>(), eyes = arguments["eyes"].as<bool>(),
               files = arguments["files"].as<bool>();
    const bool animated = is_animation(output);
    if (!animated || back)
        format_for(output);
    check_series_options(arguments, output);
    if (files && (back || animated))
        throw UsageError(std::string("--files does not go with ") +
                         (back ? "--to-frame" : "an animation"));
    if (eyes && !back && !given(arguments, "views"))
        throw UsageError("--eyes needs --views CxR, how many eyes");
    const bool upright = arguments["upright"].as<bool>();
    if (upright && (back || eyes))
        throw UsageError(std::string("--upright does not go with ") +
                         (back ? "--to-frame" : "--eyes, whose views are upright"));
    if (given(arguments, "size") && (back || (!eyes && !animated && !upright)))
        throw UsageError("--size is for --eyes, --upright and animations; else parallel views have "
                         "a pixel a lens");
    if (!back && inputs_of(arguments).size() > 1)
        throw UsageError("one frame is expected; --to-frame takes several views");
    const int threads = in_range(arguments, "threads", 0, 1024);
    return back ? frame_of_views(arguments, output, threads)
                : make_views(arguments, output, threads);
}

} // namespace

const Command views_command = {
    "views",
    "the views that are in a frame, as a quilt, files or an animation; and back",
    "FRAME -o QUILT [--views CxR] [--eyes] | --to-frame VIEWS... -o FRAME [--sheet FILE.json]",
    "Takes a frame apart into its parallel views: what eyes endlessly far away see, a pixel a\n"
    "lens, one view for each direction (thesis 5.3). They stand in one picture, a quilt: view 0,\n"
    "from the far left and below, at the bottom left. With whole pixels a lens nothing is lost,\n"
    "and --to-frame gives the frame back to the bit. Quilts and files carry the frame's geometry,\n"
    "so that nothing else has to be said on the way back; other programs' need --sheet.\n",
    1,
    most_views_a_side* most_views_a_side,
    make_options,
    run};

} // namespace integral
