// SPDX-License-Identifier: AGPL-3.0-or-later
// integral flip: several pictures that share a sheet's viewing zone, as one frame.
#include "integral/cli/fit_options.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/io/image_file.h"
#include "integral/views/flip.h"

#include <algorithm>
#include <iostream>

namespace integral {
namespace {

constexpr int most_pictures = 256;

struct FlipOptions : CommonOptions {
    PicturesFrameOptions frame;
    std::optional<std::string> shares, transition, deghost, page, output;
    bool loop = false, there_and_back = false, reverse = false, upwards = false, json = false;
    FitOptions fit;
    ThreadOptions threads;
};

void declare(options::options_description& all, FlipOptions& o)
{
    add(all, "output,o", o.output, "FRAME", "the frame: .png, .exr or .tiff");
    add(all, "transition", o.transition, "PERCENT",
        "of a picture's share, in which one picture turns evenly into the next: 0 is a flip or "
        "motion (default), 100 a morph");
    add(all, "shares", o.shares, "S,...",
        "of the zone, one for each picture (default: equal ones)");
    add(all, "there-and-back", o.there_and_back,
        "after the last picture the order goes back to the second one");
    add(all, "loop", o.loop,
        "the last picture turns into the first at the zone's edge, too, where else it jumps");
    add(all, "reverse", o.reverse,
        "the first picture at the right, or above, in place of at the left, or below");
    add(all, "upwards", o.upwards,
        "square and hexagonal lenses: pictures from below upwards, in place of from left to right; "
        "lenticular ones show what their slant lets them");
    add(all, "deghost", o.deghost, "PERCENT",
        "subtract the light that neighbouring pictures add to each other by the lenses' blur and "
        "the printed dots; so much of the contrast, as 10, may be lost");
    add(all, "page", o.page, "FILE.html",
        "a page of what each eye sees, where, and how much of other pictures");
    add(all, "json", o.json, "print the same as JSON");
    declare(all, o.fit);
    declare(all, o.frame);
    declare(all, o.threads);
}

/// Whether the line gives the frame's sheet and film.
bool states_geometry(const PicturesFrameOptions& o)
{
    return o.start || o.print || first_given(o.sheet) || o.film.dpi || o.film.pixel_pitch ||
           o.film.size || o.aperture.distance || o.aperture.aperture;
}

/// The geometry on the line; empty if it gives none and a picture is a frame.
std::optional<FrameMetadata> geometry_of(const FlipOptions& o)
{
    const auto is_frame = [](const std::string& path) {
        return FrameReader(path).frame().metadata.has_value();
    };
    if (!states_geometry(o.frame) && std::any_of(o.inputs.begin(), o.inputs.end(), is_frame))
        return std::nullopt;
    return geometry_for_pictures(o.frame, o.inputs[0]);
}

PictureFlip flip_of(const FlipOptions& o)
{
    PictureFlip flip;
    flip.pictures = o.inputs;
    flip.output = needed_output(o.output, "FRAME");
    if (o.shares)
        flip.shares = parse_numbers("shares", *o.shares, "a number for each picture",
                                    o.inputs.size(), o.inputs.size());
    if (o.transition)
        flip.transition = parse_number_between("transition", *o.transition, "per cent of a share",
                                               0, 100, "0 to 100") /
                          100;
    if (o.deghost)
        flip.deghost = parse_number_between("deghost", *o.deghost, "per cent of the contrast", 0,
                                            50, "0 to 50") /
                       100;
    flip.loop = o.loop;
    flip.there_and_back = o.there_and_back;
    flip.reverse = o.reverse;
    flip.upwards = o.upwards;
    flip.fit = o.fit.value();
    flip.bits = bits_given(o.frame.bits);
    flip.threads = o.threads.count();
    flip.tell = [](const std::string& what) { say("flip", what); };
    return flip;
}

int run(const FlipOptions& o)
{
    PictureFlip flip = flip_of(o);
    format_for(flip.output);
    check_outputs({o.output, o.page});
    flip.geometry = geometry_of(o);
    const ZoneView view = write_flip(flip, progress_bar("flip"));
    print_figures(o.json ? zone_view_json(view, o.inputs) : zone_view_text(view, o.inputs),
                  flip.output == "-");
    if (o.page)
        write_file(*o.page, zone_view_page(view, o.inputs, read_frame(flip.output), flip.threads));
    return exit_done;
}

} // namespace

const Command flip_command = {
    "flip",
    "several pictures that an eye sees one after another: flips, motion, morphs",
    "PICTURE PICTURE... -o FRAME [--transition PERCENT] [--print WxH] [--lpi N] [--page FILE.html] "
    "...",
    R"(Gives each of several pictures a share of the sheet's viewing zone, in one frame: the
print shows one picture after the other as it is turned. Pictures are photographs,
drawings, or frames of one sheet and film, whose depth stays: a flip in 3-D. The first is
seen from the left, or behind lenses that lie across (--slant 90, where both eyes see the
same) from below.

Prints which eye sees what, at the viewing distance: alone where no change of pictures is,
with the blur of lenses and printed dots.
)",
    2,
    most_pictures,
    described<FlipOptions>,
    run_with<FlipOptions, run>};

} // namespace integral
