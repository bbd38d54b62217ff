// SPDX-License-Identifier: AGPL-3.0-or-later
// integral views: extracts a frame's views as a quilt, an animation or files, and makes frames from
// views.
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/cli/views_options.h"
#include "integral/io/image_file.h"
#include "integral/views/view_export.h"

#include <algorithm>
#include <iostream>

namespace integral {

void declare(options::options_description& all, ViewsOptions& o)
{
    add(all, "output,o", o.output, "FILE",
        "the quilt, or with --to-frame the frame: .png, .exr or .tiff; a quilt's name gets "
        "_qsCxRaASPECT before the extension, unless it has such an end; .webp, .webm or .mp4: an "
        "animation");
    add(all, "views", o.views, "CxR",
        "the quilt's views across and up; those of lenticular lenses all go from left to right, or "
        "of ones that lie across from below upwards, row after row from the bottom (default: as "
        "many as whole pixels are nearest to a lens's; with --to-frame what the quilt says)");
    add(all, "eyes", o.eyes,
        "what eyes see that are spread over the frame's viewing zone, in place of parallel views; "
        "needs --views");
    add(all, "files", o.files,
        "a file for each view, with its number before the extension, in place of a quilt");
    add(all, "upright", o.upright,
        "parallel views as they look, of the film's shape and without the lenses' slant, in place "
        "of a pixel a lens; not for --to-frame. An animation's are");
    add(all, "size", o.size, "WxH",
        "pixels of each view of --eyes and --upright (default: 500 on the longer side), or by "
        "--depth");
    add(all, "rgbd", o.rgbd, "DEPTH.exr",
        "what the centre eye sees and, to its right, its depth frame (Integral_Depth_Image), near "
        "white: for programs that make a quilt of the two; .png or .tiff");
    add(all, "to-frame", o.to_frame,
        "back: the frame that shows the views of a quilt, or of files");
    add(all, "depth", o.depth.depth, "HOW",
        "draw the views by depth, out of one picture or a stereo pair, for --panel or --sheet: "
        "beside (the picture's right half has the depths of its left half as greys, near white; "
        "default for names that end in rgbd), inside (as phones store it in a .jpg; default where "
        "it is), measured (default for two views: a pair in an .mpo or two files), or FILE (a grey "
        "picture, .pfm of mm behind the sheet, a depth frame). With --to-frame: make the frame by "
        "depth, for another sheet and film, also out of a frame or views of eyes, in which depth "
        "is measured as integral depth does");
    add(all, "depth-range", o.depth.range, "WHITE,BLACK",
        "the depths, mm behind the sheet, of white and black in grey depths, or else of the "
        "nearest "
        "and the farthest twentieth, also of depths in mm and measured ones (default of greys and "
        "pairs: twice the depth budget in front and behind); between them equal steps are equal "
        "steps of parallax");
    add(all, "panel", o.panel, "NAME|FILE.json",
        "for views by --depth: the light-field panel (integral lcd --list) that shows them; they "
        "have its shape, and the number and size of its quilt's unless --views and --size give "
        "others");
    add(all, "sheet", o.sheet, "FILE.json",
        "geometry of the frame (integral sheet FRAME --json writes it), if the pictures do not "
        "carry it, or instead of that");
    add(all, "at", o.at, "S",
        "with --to-frame: the picture of a quilt video (.mp4, .webm; needs the program ffmpeg) at "
        "S "
        "seconds: its first one from then on");
    declare(all, o.given_views);
    declare(all, o.fit);
    declare(all, o.threads);
    declare(all, o.series);
}

namespace {

/// Whether views are to be drawn of a picture with depth or a stereo pair.
bool by_depth(const ViewsOptions& o)
{
    return !o.to_frame && !o.rgbd && shows_by_depth(o.inputs, o.depth);
}

/// Writes the views of frames as pictures. `depth`: by_depth.
int make_views(const ViewsOptions& o, const std::string& output, bool animated, bool depth)
{
    ViewExport requested;
    requested.output = output;
    requested.sheet = o.sheet.value_or("");
    if (o.views)
        requested.grid = parse_view_grid(*o.views);
    if (o.size)
        requested.size = parse_size("size", *o.size, largest_picture_side);
    requested.kind = o.eyes                  ? ViewKind::of_eyes
                     : animated || o.upright ? ViewKind::upright
                                             : ViewKind::parallel;
    requested.files = o.files;
    requested.fit = o.fit.value();
    requested.animation = animation_settings(o.series);
    requested.threads = o.threads.count();
    requested.tell = [](const std::string& what) { say("views", what); };
    requested.progress = progress_bar;
    if (depth)
        return make_views_by_depth(o, requested);
    if (o.rgbd) {
        write_rgbd(o.inputs[0], *o.rgbd, requested);
        return exit_done;
    }
    const std::string path = o.inputs.size() > 1 ? write_quilts(o.inputs, requested)
                                                 : write_views_of_frame(o.inputs[0], requested);
    if (path != output)
        std::cout << path << '\n';
    return exit_done;
}

/// Throws UsageError if --at or other options do not go with a video, or without one.
void check_video(const ViewsOptions& o)
{
    const auto video = std::find_if(o.inputs.begin(), o.inputs.end(), is_video);
    if (video == o.inputs.end())
        return throw_if_given({{"at", o.at}}, "is for videos");
    if (!o.to_frame)
        throw UsageError(*video + ": it is a video, not a frame; --to-frame --at SECONDS makes a "
                                  "frame of one of its quilts, and integral lcd shows it");
    if (o.inputs.size() > 1 || !o.at)
        throw UsageError(*video + ": --at SECONDS selects one of its pictures, as the only INPUT");
    throw_if_given({{"depth", o.depth.depth}}, "does not work with a video");
}

/// Throws UsageError for options that exclude each other. `depth`: by_depth.
void check_options(const ViewsOptions& o, bool animated, bool depth)
{
    check_video(o);
    if (o.files && (o.to_frame || animated))
        throw UsageError(std::string("--files does not work with ") +
                         (o.to_frame ? "--to-frame" : "an animation"));
    if (o.eyes && !o.to_frame && !o.views)
        throw UsageError("--eyes needs --views CxR, how many eyes");
    if (o.upright && (o.to_frame || o.eyes))
        throw UsageError(std::string("--upright does not work with ") +
                         (o.to_frame ? "--to-frame" : "--eyes, whose views are upright"));
    if (o.size && (o.to_frame || (!o.eyes && !animated && !o.upright && !o.rgbd && !depth)))
        throw UsageError(
            "--size is for --eyes, --upright, --rgbd and animations; else parallel views have "
            "a pixel a lens");
    if (!o.to_frame)
        throw_if_given({{"aspect", o.given_views.given_aspect},
                        {"right-to-left", o.given_views.right_to_left && !depth}},
                       "is for the views of --to-frame");
    if (depth)
        throw_if_given({{"eyes", o.eyes}, {"upright", o.upright}},
                       "is for frames; views by depth are those of eyes");
    if (o.depth.range && !o.depth.depth && !depth)
        throw UsageError("--depth-range is for views and frames by --depth");
    if (o.panel && !depth)
        throw UsageError("--panel is for pictures with depth; integral lcd shows frames and views");
    if (o.panel && o.sheet)
        throw UsageError("--sheet does not work with --panel, whose geometry the views are for");
    if (o.rgbd && (o.to_frame || o.eyes || o.upright || o.files || o.views || animated))
        throw UsageError("--rgbd makes one picture, of one view; only --size and --sheet go with "
                         "it");
    if (!o.to_frame && o.inputs.size() > 1 && !(animated && o.eyes) && !depth)
        throw UsageError("one frame is expected; several frames make an animation of quilts, by "
                         "--eyes --views CxR and -o FILE.webm, .mp4 or .webp, and --to-frame "
                         "takes several views");
}

int run(const ViewsOptions& o)
{
    const std::string output = needed_output(o.output, "FILE");
    if (is_mpo(output))
        throw UsageError("-o " + output + ": integral replay --stereo MM makes pairs");
    const bool animated = is_animation(output);
    if (!animated || o.to_frame)
        format_for(output);
    check_series_options(o.series, output);
    const bool depth = by_depth(o);
    check_options(o, animated, depth);
    const int threads = o.threads.count();
    if (o.to_frame)
        return o.depth.depth ? make_frame_with_depth(o, output, threads)
                             : make_frame(o, output, threads);
    return make_views(o, output, animated, depth);
}

} // namespace

const Command views_command = {
    "views",
    "the views that are in a frame, as a quilt, files or an animation; and back",
    "FRAME -o QUILT [--views CxR] [--eyes] | FRAME --rgbd DEPTH.exr -o PICTURE | FRAME... --eyes "
    "--views CxR -o QUILTS.webm | PICTURE_rgbd.png|PAIR.mpo|LEFT RIGHT --panel NAME -o QUILT | "
    "--to-frame VIEWS... -o FRAME [--sheet FILE.json] [--depth HOW]",
    R"(Takes a frame apart into its parallel views: what eyes endlessly far away see, a pixel a
lens, one view for each direction (thesis 5.3). They stand in one picture, a quilt: view 0,
from the far left and below, at the bottom left, the last at the top right. With whole
pixels a lens nothing is lost, and --to-frame gives the frame back to the bit. Quilts and
files carry the frame's geometry, so that nothing else has to be said on the way back;
other programs' need --sheet. Of a picture with depth (RGBD, a phone's) and of a stereo pair
it draws the views that eyes before a --panel see.
)",
    1,
    most_views_a_side* most_views_a_side,
    described<ViewsOptions>,
    run_with<ViewsOptions, run>};

} // namespace integral
