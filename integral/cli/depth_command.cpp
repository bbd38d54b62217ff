// SPDX-License-Identifier: AGPL-3.0-or-later
// integral depth: depths of everything shown in a frame or a set of views.
#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/cli/fit_options.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/depth/depth_files.h"
#include "integral/depth/depth_input.h"
#include "integral/depth/depth_quality.h"
#include "integral/depth/depth_report.h"
#include "integral/depth/ray_trace.h"
#include "integral/depth/relief_frame.h"
#include "integral/depth/relief_input.h"
#include "integral/depth/view_order.h"
#include "integral/io/image_file.h"

#include <chrono>
#include <cmath>
#include <iostream>

namespace integral {
namespace {

constexpr int largest_map_side = 32768; // pixels

struct DepthOptions : CommonOptions {
    std::optional<std::string> output, method, quality, views, eyes, range, truth, sheet;
    std::optional<std::string> refocus, pupil;
    std::optional<int> width, border;
    bool as_disparity = false, top_first = false, rgbd = false, json = false;
    ViewOrderOptions given_views;
    ThreadOptions threads;
};

void declare(options::options_description& all, DepthOptions& o)
{
    add(all, "output,o", o.output, "FILE",
        "the depth map: .png (in colours, with a scale), .exr or .pfm (mm behind the sheet; "
        "disparities where mm are not known), .ply (a cloud of points)");
    add(all, "disparity", o.as_disparity,
        "write disparities, in place of mm, to .pfm and to channel Y of .exr");
    add(all, "rgbd", o.rgbd,
        "write the middle view and, to its right, its depth in greys, near white: for programs "
        "that make views of the two; .png or .tiff");
    add(all, "refocus", o.refocus, "MM",
        "write, in place of depth, the picture that a lens takes before the middle of the eyes, in "
        "focus MM behind the sheet (negative: in front); .png, .exr or .tiff, --width PIXELS");
    add(all, "pupil", o.pupil, "MM", "diameter of the lens of --refocus");
    add(all, "method", o.method, "multibaseline|raytrace",
        "multibaseline (the default) searches the depth at which most views agree (thesis 5.4.4); "
        "raytrace counts where rays of like colours meet (5.4.3): coarse, with false points near "
        "the sheet, to compare");
    add(all, "quality", o.quality, "draft|good|best",
        "draft compares the views in a cross about the middle one, coarsely; good (the default) "
        "also those on the diagonals; best in finer steps, over wider windows");
    add(all, "width", o.width, "PIXELS",
        "pixels of the map across (default: about as many as the views have)");
    add(all, "range", o.range, "FAR,NEAR",
        "disparities to search: pixels from one view to the next, less than 0 behind the sheet "
        "(default: found)");
    add(all, "views", o.views, "CxR",
        "how many views there are across and up, where a quilt's name or files do not say it");
    add(all, "top-first", o.top_first,
        "the views' first row is the one from above, as in the HCI light-field benchmark, in place "
        "of the one from below, as in quilts");
    declare(all, o.given_views);
    add(all, "eyes", o.eyes, "ACROSS[,UP],DISTANCE,WIDTH",
        "where views were taken from that do not say it, in mm: between neighbouring eyes (UP: "
        "between rows, by default ACROSS), from there to the plane without parallax, and how wide "
        "a view is there. Without it depth is in disparities");
    add(all, "truth", o.truth, "FILE",
        "score the map against the depths of the frame or the quilt (.exr, Integral_Depth_Image) "
        "or true disparities (.pfm)");
    add(all, "border", o.border, "PIXELS (=0)",
        "leave so many out at each side of the map when scoring (the HCI toolkit: 15)");
    add(all, "json", o.json, "print the figures as JSON");
    declare_frame_geometry(all, o.sheet);
    declare(all, o.threads);
}

DepthRequest request_of(const DepthOptions& o)
{
    DepthRequest request;
    if (o.views)
        request.grid = parse_view_grid(*o.views);
    request.top_first = o.top_first;
    request.aspect = o.given_views.aspect();
    request.right_to_left = o.given_views.right_to_left;
    request.sheet = o.sheet.value_or("");
    if (o.eyes) {
        const auto mm = parse_numbers("eyes", *o.eyes, "ACROSS[,UP],DISTANCE,WIDTH", 3, 4);
        for (const double length : mm)
            if (!(length > 0))
                throw UsageError("--eyes " + *o.eyes + ": lengths greater than 0 are expected");
        const std::size_t rest = mm.size() - 2;
        request.eyes = ViewEyes{{mm[0], mm[rest - 1]}, mm[rest], mm[rest + 1]};
    }
    return request;
}

DepthQuality quality_of(const DepthOptions& o)
{
    const auto quality = depth_quality(o.quality.value_or("good"));
    if (!quality)
        throw_usage("quality", *o.quality, "draft, good or best");
    return *quality;
}

MultibaselineSettings settings_of(const DepthOptions& o)
{
    MultibaselineSettings settings = settings_for(quality_of(o));
    if (o.range) {
        const auto ends = parse_numbers("range", *o.range, "FAR,NEAR", 2, 2);
        constexpr double widest = 100;
        if (!(ends[0] < ends[1] && ends[0] >= -widest && ends[1] <= widest))
            throw_usage("range", *o.range, "FAR less than NEAR, from -100 to 100,");
        settings.range = DisparityRange{ends[0], ends[1]};
    }
    return settings;
}

void print_figures(const DepthOptions& o, const DepthInput& input, const DepthMap& map,
                   double seconds)
{
    DepthFigures figures{input.views.others.size() + 1,
                         input.views.upright_width(),
                         input.views.upright_height(),
                         map.range,
                         seconds,
                         std::nullopt};
    if (o.truth) {
        const int border = in_range("border", o.border.value_or(0), 0, 10000);
        const auto truth = usage_checked("--truth " + *o.truth + ": ",
                                         [&] { return read_truth(*o.truth, input); });
        figures.scores = depth_scores(input.views, map.disparity, truth, border);
    }
    std::cout << (o.json ? figures_json(figures).dump(2) + "\n" : figures_text(figures));
}

bool holds_numbers(const std::string& path)
{
    const std::string extension = extension_of(path);
    return extension == "pfm" || extension == "exr";
}

void check_options(const DepthOptions& o)
{
    if (!o.output && !o.truth)
        throw UsageError("-o FILE is missing");
    if (o.method && *o.method != "multibaseline" && *o.method != "raytrace")
        throw_usage("method", *o.method, "multibaseline or raytrace");
    if (o.method == "raytrace" && o.quality)
        throw UsageError("--quality is for multibaseline, not for --method raytrace");
    if (o.rgbd && (!o.output || format_for(*o.output) == ImageFormat::exr))
        throw UsageError("--rgbd needs -o FILE.png or .tiff");
    if (o.as_disparity && (o.rgbd || !o.output || !holds_numbers(*o.output)))
        throw UsageError("--disparity needs -o FILE.pfm or .exr");
    if (o.refocus.has_value() != o.pupil.has_value())
        throw UsageError("--refocus MM and --pupil MM go together: depth and width of the focus");
    if (o.refocus && (!o.output || o.truth || o.rgbd || o.method || o.range || o.json))
        throw UsageError("--refocus MM needs -o PICTURE, and no option of depth maps");
    if (o.refocus)
        format_for(*o.output);
    else if (o.output && !o.rgbd && !is_depth_file(*o.output))
        throw UsageError("-o " + *o.output + ": a depth map is .png, .exr, .pfm or .ply");
    if (o.width)
        in_range("width", *o.width, 1, largest_map_side);
    check_outputs({o.output});
}

std::optional<DepthMap> measured(const DepthOptions& o, const ViewSet& views,
                                 const MultibaselineSettings& settings, int threads,
                                 const Progress& bar)
{
    if (o.method != "raytrace")
        return multibaseline(views, settings, threads, bar);
    RayTraceSettings of_rays;
    of_rays.range = settings.range ? *settings.range : find_range(views, settings.votes, threads);
    return ray_trace(views, of_rays, threads, bar);
}

void write(const DepthOptions& o, const UprightMap& map)
{
    if (!o.rgbd)
        return write_depth(*o.output, map, o.as_disparity);
    const DisparityRange range = write_rgbd(*o.output, map);
    const auto text = [&](double disparity) {
        return map.scale ? with_decimals(map.scale->mm(disparity), 1) + " mm behind the sheet"
                         : "disparity " + with_decimals(disparity, 2);
    };
    say("depth", "white is " + text(range.greatest) + ", black " + text(range.least));
}

/// --refocus: a picture in focus at one depth.
void refocus(const DepthOptions& o, const DepthInput& input, int threads, const Progress& bar)
{
    constexpr double least_longer_side = 500; // pixels
    Refocus lens;
    lens.focus = parse_number("refocus", *o.refocus, "MM");
    lens.pupil = parse_number("pupil", *o.pupil, "MM");
    const Relief relief = measured_relief(input, quality_of(o), threads, piece_of(bar, 0, 2));
    if (!(lens.focus > -relief.distance()) || !(lens.pupil >= 0))
        throw UsageError("--refocus " + *o.refocus + " --pupil " + *o.pupil +
                         ": a depth before the eye and a diameter are expected");
    lens.width = o.width.value_or(
        int(std::lround(std::max(least_longer_side, input.width / relief.pixel()))));
    lens.height = std::max(1, int(std::lround(lens.width * input.height / input.width)));
    const RefocusedPicture picture = refocused(relief, lens, input.form, threads,
                                               piece_of(bar, 1, 2));
    write_frame(*o.output, Frame{picture.image, std::nullopt});
    say("depth", holes_text(picture.figures));
}

/// Views, and the map measured in them.
struct Measurement {
    DepthInput input;
    DepthMap map;
    double seconds = 0; ///< of measuring
};

Measurement measurement(const DepthOptions& o, DepthInput input,
                        const MultibaselineSettings& settings, int threads, const Progress& bar)
{
    soften(input.views, threads);
    keep_views(input.views, quality_of(o));
    const auto start = std::chrono::steady_clock::now();
    auto map = measured(o, input.views, settings, threads, bar);
    if (!map)
        throw Interrupted();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return {std::move(input), std::move(*map), seconds.count()};
}

/// Measures views again that seem to be in reverse order, and keeps that if it removes the
/// contradiction. Reports it. An order that the user gave is kept.
void check_order(const DepthOptions& o, const DepthRequest& request, MultibaselineSettings settings,
                 int threads, const Progress& bar, Measurement& found)
{
    if (found.input.frame)
        return;
    const HiddenSides hidden = hidden_sides(found.input.views, found.map);
    if (!hidden.is_reversed())
        return;
    const std::string fact = o.inputs[0] + ": at " + std::to_string(hidden.nearer) + " of " +
                             std::to_string(hidden.nearer + hidden.farther) +
                             " places on edges, what is measured as nearer is hidden: the views ";
    if (!request.right_to_left) {
        DepthRequest turned = request;
        turned.right_to_left = true;
        if (settings.range)
            settings.range = DisparityRange{-settings.range->greatest, -settings.range->least};
        Measurement again = measurement(
            o, read_depth_input(o.inputs, turned, threads, piece_of(bar, 0, 2)), settings, threads,
            piece_of(bar, 1, 2));
        if (!hidden_sides(again.input.views, again.map).is_reversed()) {
            say("depth", fact + "go from right to left, and are measured again in that order");
            found = std::move(again);
            return;
        }
    }
    say("depth", fact + "seem to go from " +
                     (request.right_to_left ? "left to right; leave --right-to-left out"
                                            : "right to left; give --right-to-left"));
}

int run(const DepthOptions& o)
{
    check_options(o);
    const int threads = o.threads.count();
    const MultibaselineSettings settings = settings_of(o);
    const DepthRequest request = request_of(o);
    const Progress bar = progress_bar("depth");
    usage_checked(o.inputs[0] + ": ", [&] {
        DepthInput input = read_depth_input(o.inputs, request, threads, piece_of(bar, 0, 2));
        if (o.refocus)
            return refocus(o, input, threads, piece_of(bar, 1, 2));
        Measurement found = measurement(o, std::move(input), settings, threads,
                                        piece_of(bar, 1, 2));
        check_order(o, request, settings, threads, bar, found);
        if (o.output)
            write(o, upright_map(found.input.views, found.map, found.input.width,
                                 found.input.height, o.width.value_or(0)));
        print_figures(o, found.input, found.map, found.seconds);
    });
    return exit_done;
}

} // namespace

const Command depth_command = {
    "depth",
    "the depth of what a frame or a set of views shows, as a map or points",
    "FRAME -o DEPTH | VIEWS... -o DEPTH [--views CxR] [--eyes ACROSS[,UP],DISTANCE,WIDTH]",
    R"(Measures how far behind or in front of the sheet everything is that a frame shows (thesis
5.4.4), from the many views that its lenses give: a point that is nearer or farther stands
elsewhere in each of them. It also takes a quilt, or the files of views. The map shows what
the eye at the aperture's centre, or the middle view, sees.
)",
    1,
    most_views_a_side* most_views_a_side,
    described<DepthOptions>,
    run_with<DepthOptions, run>};

} // namespace integral
