// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/replay_options.h"

#include "integral/cli/choices.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/values.h"

#include <cmath>

namespace integral {
namespace {

constexpr int most_samples = 64, largest_grid = 64;
constexpr double farthest = 1e9; // mm

Eye parse_eye(const std::string& text)
{
    constexpr char form[] = "X,Y,DISTANCE (mm, DISTANCE greater than 0)";
    const auto v = parse_numbers("eye", text, form, 3, 3);
    if (!(v[2] > 0 && v[2] <= farthest && std::fabs(v[0]) <= farthest &&
          std::fabs(v[1]) <= farthest))
        throw UsageError("--eye " + text + ": " + form + " is expected, each at most 1e9");
    return {v[0], v[1], v[2]};
}

/// Reads a number of mm from `least` to 1e6, if given.
void read_mm(const char* option, const std::optional<std::string>& text, double least,
             const char* form, double& value)
{
    if (text)
        value = parse_number_between(option, *text, form, least, 1e6, form);
}

SheetPart parse_part(const std::string& text)
{
    constexpr char form[] = "X,Y,W,H (mm, W and H greater than 0)";
    const auto v = parse_numbers("part", text, form, 4, 4);
    if (!(v[2] > 0 && v[3] > 0 && v[2] <= farthest && v[3] <= farthest &&
          std::fabs(v[0]) <= farthest && std::fabs(v[1]) <= farthest))
        throw UsageError("--part " + text + ": " + form + " is expected, each at most 1e9");
    return {{v[0], v[1]}, v[2], v[3]};
}

} // namespace

void declare(options::options_description& all, ReplayOptions& o)
{
    add(all, "output,o", o.output, "VIEW",
        "the picture to write: .png, .exr or .tiff; - writes a PNG to standard output; with "
        "--stereo .mpo, two JPEGs in one file; with --path or several frames .webp, .webm or .mp4, "
        "an animation, or FILE.png, files with numbers");
    add(all, "html", o.html, "FILE",
        "a page for any browser, of the frame and its replay, to look at from all sides; the "
        "options of a view say how it starts; - writes to standard output");
    add(all, "eye", o.eye, "X,Y,DISTANCE",
        "the eye: mm to the right of and above the sheet's centre, and mm in front of the sheet "
        "(default: the centre of the frame's capture aperture)");
    add(all, "size", o.size, "WxH",
        "pixels of the view (default: the film's shape, 1000 on the longer side)");
    add(all, "part", o.part, "X,Y,W,H",
        "only a part of the sheet: its middle, mm to the right of and above the sheet's centre, "
        "and its width and height");
    add(all, "samples", o.samples, "N",
        "N by N samples in each pixel, 1 to 64, averaged in linear light (default: 3; with a pupil "
        "or blur 8)");
    add(all, "pupil", o.pupil, "MM",
        "the pupil's diameter, 0 to 1e6 mm (default: 0, which sees every depth sharply)");
    add(all, "focus", o.focus, "MM",
        "the depth that a pupil sees sharply: mm behind the sheet, negative in front of it "
        "(default: 0, the sheet)");
    add(all, "lens-model", o.lens_model, "MODEL",
        "extended_pinhole: ideal lenses (default); pinhole; or full: with the curved surface's "
        "aberrations");
    add(all, "film-gap", o.film_gap, "MM",
        "how much farther than at the lenses' focus the film lies; negative: nearer (default: 0)");
    add(all, "lens-blur", o.lens_blur, "MM",
        "diameter of the spot on the film that a point of a lens gathers light from: crosstalk "
        "between directions, 0 to 1e6 (default: 0)");
    add(all, "stereo", o.stereo, "MM",
        "a pair of views, of eyes so many mm apart, side by side: the left eye's on the left");
    add(all, "cross-eyed", o.cross_eyed, "the left eye's on the right");
    add(all, "anaglyph", o.anaglyph, "the pair for red-cyan glasses: the left eye's in red");
    add(all, "half", o.half,
        "each view of the pair squeezed to half of its width, so that both fill --size");
    add(all, "grid", o.grid, "CxR",
        "a contact sheet: C by R views of eyes spread over the frame's capture aperture, the eye's "
        "distance away; Cx1 of lenses that lie across: from below upwards");
    add(all, "path", o.path, "KIND[,SPAN]",
        "several views of an eye that moves: turntable (the sheet turns, SPAN degrees), sweep "
        "(sideways, SPAN mm), sway (to the right, the left and back, SPAN mm), circle (SPAN mm) or "
        "dolly (nearer, by a factor of SPAN); by default across the viewing zone, and 4 times "
        "nearer. Before lenses that lie across, upwards in place of to the right");
    add(all, "steps", o.steps, "N (=48)",
        "views along the path, 2 to 10000; of several frames one each");
    declare(all, o.fit);
    add(all, "as-seen", o.as_seen,
        "what a person sees: a pupil of 4 mm, the spread of printed dots and the blur of the "
        "lenses' curved surface, unless --pupil and --lens-blur say otherwise");
    add(all, "raw-draft", o.raw_draft,
        "show a draft's own pixels, not what the print's finer pixels will fill in between them");
    declare_frame_geometry(all, o.sheet);
    declare(all, o.threads);
    declare(all, o.series);
}

View view_of(const ReplayOptions& o)
{
    View view;
    read_mm("pupil", o.pupil, 0, "a diameter from 0 to 1e6 mm", view.pupil);
    read_mm("focus", o.focus, -1e6, "mm behind the sheet, from -1e6 to 1e6,", view.focus);
    read_mm("film-gap", o.film_gap, -1e6, "mm, from -1e6 to 1e6,", view.film_gap);
    read_mm("lens-blur", o.lens_blur, 0, "a diameter from 0 to 1e6 mm", view.blur);
    if (o.lens_model)
        view.model = meaning_of("lens-model", *o.lens_model, replay_lens_model_choices);
    view.samples = o.samples   ? in_range("samples", *o.samples, 1, most_samples)
                   : o.as_seen ? scattered_samples
                               : default_samples(view);
    if (o.eye)
        view.eye = parse_eye(*o.eye);
    read_size("size", o.size, largest_replay_side, view.width, view.height);
    if (o.part)
        view.part = parse_part(*o.part);
    return view;
}

ViewArrangement arrangement_of(const ReplayOptions& o)
{
    ViewArrangement arrangement;
    arrangement.crossed = o.cross_eyed;
    arrangement.anaglyph = o.anaglyph;
    arrangement.half = o.half;
    if (o.stereo)
        read_mm("stereo", o.stereo, 0, "a distance from 0 to 1e6 mm",
                arrangement.separation.emplace());
    if (!o.stereo)
        throw_if_given({{"cross-eyed", o.cross_eyed}, {"anaglyph", o.anaglyph}, {"half", o.half}},
                       "needs --stereo MM, the eyes' distance");
    if (o.anaglyph)
        throw_if_given({{"half", o.half}, {"cross-eyed", o.cross_eyed}},
                       "and --anaglyph do not go together");
    if (!o.grid)
        return arrangement;
    if (o.stereo)
        throw UsageError("--grid and --stereo do not go together");
    const PixelSize grid = parse_size("grid", *o.grid, largest_grid, "CxR");
    arrangement.columns = grid.width;
    arrangement.rows = grid.height;
    return arrangement;
}

std::optional<EyeMovement> movement_of(const ReplayOptions& o)
{
    EyeMovement movement;
    if (o.steps)
        movement.steps = in_range("steps", *o.steps, 2, 10000);
    if (o.inputs.size() > 1) {
        if (o.steps)
            throw UsageError("--steps is for one frame: of several frames, each is a step");
        movement.steps = int(o.inputs.size());
    }
    if (!o.path) {
        if (o.steps)
            throw UsageError("--steps needs --path, how the eye moves");
        return std::nullopt;
    }
    const std::string text = *o.path, word = text.substr(0, text.find(','));
    movement.path = meaning_of("path", word, path_choices);
    if (word == text)
        return movement;
    const double span = parse_number("path", text.substr(word.size() + 1), "KIND,SPAN (a number)");
    const double least = movement.path == EyePath::dolly ? 1 : 0,
                 greatest = movement.path == EyePath::turntable ? 179 : farthest;
    if (!(span >= least && span <= greatest))
        throw_usage("path", text,
                    "a span from " + std::to_string(int(least)) + " to " +
                        std::to_string(int(greatest)) + "");
    movement.span = span;
    return movement;
}

} // namespace integral
