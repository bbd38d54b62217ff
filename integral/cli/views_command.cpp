// SPDX-License-Identifier: AGPL-3.0-or-later
// integral views: the views that are in a frame, as a quilt; and the frame of a quilt.
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"
#include "integral/replay/parallel_views.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>

namespace integral {
namespace {

constexpr int most_a_side = 256, largest_side = 32768;

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()
        ("output,o", options::value<std::string>()->value_name("FILE"),
         "the quilt, or with --to-frame the frame: .png, .exr or .tiff; a quilt's name gets _qsCxRaASPECT before the extension, "
         "unless it has such an end")
        ("views", options::value<std::string>()->value_name("CxR"),
         "views across and up (default: as many as whole pixels are nearest to a lens's; with --to-frame what the quilt's name says)")
        ("eyes", options::bool_switch(),
         "what eyes see that are spread over the frame's capture aperture, in place of parallel views; needs --views")
        ("size", options::value<std::string>()->value_name("WxH"), "pixels of each view of --eyes (default: 500 on the longer side)")
        ("to-frame", options::bool_switch(), "back: the frame that shows the parallel views of a quilt; needs --sheet")
        ("sheet", options::value<std::string>()->value_name("FILE.json"),
         "geometry of the frame (integral sheet FRAME --json writes it), if it does not carry its own, or instead of that")
        ("threads", options::value<int>()->value_name("N")->default_value(0), "threads to work with (0: one per core)")
        ("help", "print this");
    return all;
}

/// The quilt's columns and rows, of its name; nothing if it has no such end.
std::optional<ViewGrid> grid_in_name(const std::string& path)
{
    const std::size_t end = path.rfind("_qs"), dot = path.find_last_of('.');
    if (end == std::string::npos || dot == std::string::npos || dot < end)
        return std::nullopt;
    ViewGrid grid;
    int aspect = 0, whole = 0; // where the aspect begins, and how much of the end has been read
    const std::string text = path.substr(end, dot - end);
    if (std::sscanf(text.c_str(), "_qs%4dx%4da%n%*[0-9.]%n", &grid.columns, &grid.rows, &aspect, &whole) < 2
        || whole <= aspect || std::size_t(whole) != text.size())
        return std::nullopt;
    return grid;
}

std::string quilt_name(const std::string& path, ViewGrid grid, const Film& film)
{
    if (path == "-" || grid_in_name(path))
        return path;
    const double aspect = film.width * film.pixel_pitch.x / (film.height * film.pixel_pitch.y);
    char end[64];
    std::snprintf(end, sizeof end, "_qs%dx%da%.4g", grid.columns, grid.rows, aspect);
    const std::size_t dot = path.find_last_of('.');
    return path.substr(0, dot) + end + path.substr(dot);
}

ViewGrid parse_grid(const std::string& text)
{
    const PixelSize size = parse_size("views", text, most_a_side);
    return {size.width, size.height};
}

/// A quilt's views stand with the bottom row first; rows of pictures with the top one.
std::vector<Image> turned(std::vector<Image> views, ViewGrid grid)
{
    for (int row = 0; row < grid.rows / 2; ++row)
        std::swap_ranges(views.begin() + row * grid.columns, views.begin() + (row + 1) * grid.columns,
                         views.begin() + (grid.rows - 1 - row) * grid.columns);
    return views;
}

void check_quilt_size(ViewGrid grid, int width, int height)
{
    if (std::max(double(grid.columns) * width, double(grid.rows) * height) > largest_side)
        throw UsageError("a quilt of " + std::to_string(grid.columns) + "x" + std::to_string(grid.rows) + " views of "
                         + std::to_string(width) + "x" + std::to_string(height) + " pixels has more than "
                         + std::to_string(largest_side) + " one way; fewer views would do");
}

std::vector<Image> views_of_eyes(const Frame& frame, ViewGrid grid, const options::variables_map& arguments, int threads)
{
    const FrameMetadata& metadata = *frame.metadata;
    View view;
    constexpr int default_longer_side = 500;
    set_view_size(view, metadata.film, default_longer_side);
    if (given(arguments, "size")) {
        const PixelSize size = parse_size("size", text_of(arguments, "size"), largest_side);
        view.width = size.width;
        view.height = size.height;
    }
    check_quilt_size(grid, view.width, view.height);
    std::vector<Image> pictures;
    for (const Eye& eye : eye_grid(centre_eye(metadata), grid.columns, grid.rows, metadata.aperture.width, metadata.aperture.height)) {
        view.eye = eye;
        auto picture = replay(frame, view, threads, progress_bar("views"));
        if (!picture)
            throw Interrupted();
        pictures.push_back(std::move(*picture));
    }
    return pictures;
}

int make_quilt(const options::variables_map& arguments, const std::string& output, int threads)
{
    const Frame frame = read_frame_with_metadata(inputs_of(arguments)[0], text_of(arguments, "sheet"));
    stop_if_interrupted();
    const ViewGrid grid = given(arguments, "views") ? parse_grid(text_of(arguments, "views")) : natural_views(*frame.metadata);
    const std::string path = quilt_name(output, grid, frame.metadata->film);
    check_writable(path);
    Image quilt;
    if (arguments["eyes"].as<bool>()) {
        quilt = tiled(views_of_eyes(frame, grid, arguments, threads), grid.columns, 0);
    } else {
        if (frame.metadata->sheet.arrangement == Arrangement::lenticular && grid.rows > 1)
            throw UsageError("--views " + text_of(arguments, "views") + ": lenticular lenses show nothing new from above: one row is expected");
        try {
            const LensWindow window = lens_window(*frame.metadata);
            check_quilt_size(grid, window.columns, window.rows);
        } catch (const std::invalid_argument& error) {
            throw UsageError(inputs_of(arguments)[0] + ": " + error.what());
        }
        auto views = parallel_views(frame, grid, threads, progress_bar("views"));
        if (!views)
            throw Interrupted();
        quilt = tiled(turned(std::move(*views), grid), grid.columns, 0);
    }
    write_frame(path, Frame{std::move(quilt), std::nullopt});
    if (path != output)
        std::cout << path << '\n';
    return exit_done;
}

std::vector<Image> cut(const Image& quilt, ViewGrid grid)
{
    const int width = quilt.width / grid.columns, height = quilt.height / grid.rows;
    std::vector<Image> views;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            views.push_back(part_of(quilt, column * width, (grid.rows - 1 - row) * height, width, height));
    return views;
}

int make_frame(const options::variables_map& arguments, const std::string& output, int threads)
{
    const std::string input = inputs_of(arguments)[0];
    if (!given(arguments, "sheet"))
        throw UsageError("--to-frame needs --sheet FILE.json, the geometry of the frame (integral sheet FRAME --json writes it)");
    const auto named = grid_in_name(input);
    if (!named && !given(arguments, "views"))
        throw UsageError(input + ": its name does not end in _qsCxRaASPECT; --views CxR would tell");
    const ViewGrid grid = given(arguments, "views") ? parse_grid(text_of(arguments, "views")) : *named;
    check_writable(output);
    const FrameMetadata metadata = read_metadata(text_of(arguments, "sheet"));
    if (metadata.film.width < 1)
        throw UsageError(text_of(arguments, "sheet") + ": says no film.width and film.height, the frame's pixels");
    const Frame quilt = read_frame(input);
    stop_if_interrupted();
    if (grid.columns < 1 || grid.rows < 1 || quilt.image.width % grid.columns != 0 || quilt.image.height % grid.rows != 0)
        throw UsageError(input + ": " + std::to_string(quilt.image.width) + "x" + std::to_string(quilt.image.height)
                         + " pixels are not " + std::to_string(grid.columns) + "x" + std::to_string(grid.rows) + " equal views");
    try {
        auto image = frame_from_views(cut(quilt.image, grid), metadata, grid, threads, progress_bar("views"));
        if (!image)
            throw Interrupted();
        Frame frame{std::move(*image), std::nullopt};
        FrameMetadata geometry = metadata;
        geometry.encoding = frame.image.encoding;
        set_metadata(frame, geometry);
        write_frame(output, std::move(frame));
    } catch (const std::invalid_argument& error) {
        throw UsageError(input + ": " + error.what());
    }
    return exit_done;
}

int run(const options::variables_map& arguments)
{
    const std::string output = text_of(arguments, "output");
    if (output.empty())
        throw UsageError("-o FILE is missing");
    format_for(output);
    const bool back = arguments["to-frame"].as<bool>(), eyes = arguments["eyes"].as<bool>();
    if (back && eyes)
        throw UsageError("--to-frame and --eyes do not go together: a frame is made of parallel views");
    if (eyes && !given(arguments, "views"))
        throw UsageError("--eyes needs --views CxR, how many eyes");
    if (given(arguments, "size") && !eyes)
        throw UsageError("--size is for --eyes; parallel views have a pixel a lens");
    const int threads = in_range(arguments, "threads", 0, 1024);
    return back ? make_frame(arguments, output, threads) : make_quilt(arguments, output, threads);
}

} // namespace

const Command views_command = {
    "views",
    "the views that are in a frame, as a quilt; and back",
    "FRAME -o QUILT [--views CxR] [--eyes] | --to-frame QUILT -o FRAME --sheet FILE.json",
    "Takes a frame apart into its parallel views: what eyes endlessly far away see, a pixel a\n"
    "lens, one view for each direction (thesis 5.3). They stand in one picture, a quilt: view 0,\n"
    "from the far left and below, at the bottom left. With whole pixels a lens nothing is lost,\n"
    "and --to-frame gives the frame back to the bit.\n",
    1, 1, make_options, run};

} // namespace integral
