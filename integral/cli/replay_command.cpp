// SPDX-License-Identifier: AGPL-3.0-or-later
// integral replay: what an eye sees of a frame through its sheet.
#include "integral/cli/command.h"
#include "integral/cli/picture_series.h"
#include "integral/cli/progress.h"
#include "integral/cli/replay_html.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/names.h"
#include "integral/replay/arrange.h"

#include <cmath>

namespace integral {
namespace {

constexpr int default_longer_side = 1000, largest_side = 32768, most_samples = 64;
constexpr double farthest = 1e9; // mm

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()("output,o", options::value<std::string>()->value_name("VIEW"),
                      "the picture to write: .png, .exr or .tiff; - writes a PNG to standard "
                      "output; with --path FILE.webp, an animation, or "
                      "FILE.png, files with numbers")(
        "html", options::value<std::string>()->value_name("FILE"),
        "a page for any browser, of the frame and its replay, to look at from all sides; the "
        "options of a view "
        "say how it starts; - writes to standard output")(
        "eye", options::value<std::string>()->value_name("X,Y,DISTANCE"),
        "the eye: mm to the right of and above the sheet's centre, and mm in front of the sheet "
        "(default: the centre of the frame's capture aperture)")(
        "size", options::value<std::string>()->value_name("WxH"),
        "pixels of the view (default: the film's shape, 1000 on the longer side)")(
        "part", options::value<std::string>()->value_name("X,Y,W,H"),
        "only a part of the sheet: its middle, mm to the right of and above the sheet's centre, "
        "and its width and height")("samples", options::value<int>()->value_name("N"),
                                    "N by N samples in each pixel, 1 to 64, averaged in linear "
                                    "light (default: 3; with a pupil or blur 8)")(
        "pupil", options::value<std::string>()->value_name("MM"),
        "the pupil's diameter, 0 to 1e6 mm (default: 0, which sees every depth sharply)")(
        "focus", options::value<std::string>()->value_name("MM"),
        "the depth that a pupil sees sharply: mm behind the sheet, negative in front of it "
        "(default: 0, the sheet)")("lens-model", options::value<std::string>()->value_name("MODEL"),
                                   "extended_pinhole: ideal lenses (default); pinhole; or full: "
                                   "with the curved surface's aberrations")(
        "film-gap", options::value<std::string>()->value_name("MM"),
        "how much farther than at the lenses' focus the film lies; negative: nearer (default: 0)")(
        "lens-blur", options::value<std::string>()->value_name("MM"),
        "diameter of the spot on the film that a point of a lens gathers light from: crosstalk "
        "between directions, 0 to 1e6 (default: 0)")(
        "stereo", options::value<std::string>()->value_name("MM"),
        "a pair of views, of eyes so many mm apart, side by side: the left eye's on the left")(
        "cross-eyed", options::bool_switch(), "the left eye's on the right")(
        "anaglyph", options::bool_switch(), "the pair for red-cyan glasses: the left eye's in red")(
        "grid", options::value<std::string>()->value_name("CxR"),
        "a contact sheet: C by R views of eyes spread over the frame's capture aperture, the eye's "
        "distance away")("path", options::value<std::string>()->value_name("KIND[,SPAN]"),
                         "several views of an eye that moves: turntable (the sheet turns, SPAN "
                         "degrees), sweep (sideways, SPAN mm), circle (SPAN mm) "
                         "or dolly (nearer, by a factor of SPAN); by default across the viewing "
                         "zone, and 4 times nearer")(
        "steps", options::value<int>()->value_name("N")->default_value(48),
        "views along the path, 2 to 10000")(
        "sheet", options::value<std::string>()->value_name("FILE.json"),
        "geometry for a frame that carries none, or instead of its own")(
        "threads", options::value<int>()->value_name("N")->default_value(0),
        "threads to work with (0: one per core)")("help", "print this");
    add_series_options(all);
    return all;
}

Eye parse_eye(const std::string& text)
{
    constexpr char form[] = "X,Y,DISTANCE (mm, DISTANCE greater than 0)";
    const auto v = parse_numbers("eye", text, form, 3, 3);
    if (!(v[2] > 0 && v[2] <= farthest && std::fabs(v[0]) <= farthest &&
          std::fabs(v[1]) <= farthest))
        throw UsageError("--eye " + text + ": " + form + " is expected, each at most 1e9");
    return {v[0], v[1], v[2]};
}

/// A number of mm from `least` to 1e6; `fallback` if the option was not given.
double parse_mm(const options::variables_map& arguments, const char* option, double least,
                const char* form, double fallback)
{
    if (!given(arguments, option))
        return fallback;
    const double value = parse_number(option, text_of(arguments, option), form);
    if (!(value >= least && value <= 1e6))
        throw UsageError(std::string("--") + option + " " + text_of(arguments, option) + ": " +
                         form + " is expected");
    return value;
}

LensModel parse_model(const std::string& text)
{
    for (const LensModel model : {LensModel::extended_pinhole, LensModel::pinhole, LensModel::full})
        if (text == name_of(model))
            return model;
    throw UsageError("--lens-model " + text + ": extended_pinhole, pinhole or full is expected");
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

/// The eye's path, if it moves.
class Movement {
public:
    explicit Movement(const options::variables_map& arguments)
        : steps_(in_range(arguments, "steps", 2, 10000))
    {
        if (!given(arguments, "path")) {
            if (!arguments["steps"].defaulted())
                throw UsageError("--steps needs --path, how the eye moves");
            return;
        }
        const std::string text = text_of(arguments, "path"), word = text.substr(0, text.find(','));
        for (const auto& [name, path] :
             {std::pair("turntable", EyePath::turntable), std::pair("sweep", EyePath::sweep),
              std::pair("circle", EyePath::circle), std::pair("dolly", EyePath::dolly)})
            if (word == name)
                path_ = path;
        if (!path_)
            throw UsageError("--path " + text + ": turntable, sweep, circle or dolly is expected");
        if (word == text)
            return;
        span_ = parse_number("path", text.substr(word.size() + 1), "KIND,SPAN (a number)");
        const double least = *path_ == EyePath::dolly ? 1 : 0,
                     greatest = *path_ == EyePath::turntable ? 179 : farthest;
        if (!(*span_ >= least && *span_ <= greatest))
            throw UsageError("--path " + text + ": a span from " + std::to_string(int(least)) +
                             " to " + std::to_string(int(greatest)) + " is expected");
    }

    bool any() const { return path_.has_value(); }
    bool there_and_back() const { return path_ != EyePath::circle; }
    std::vector<Eye> eyes_about(Eye middle, const FrameMetadata& metadata) const
    {
        if (!path_)
            return {middle};
        return eye_path(*path_, middle, viewing_zone(metadata, middle.distance), span_, steps_);
    }

private:
    std::optional<EyePath> path_;
    std::optional<double> span_;
    int steps_;
};

/// One view, a pair or a grid of them.
class ArrangementOfViews {
public:
    explicit ArrangementOfViews(const options::variables_map& arguments)
        : separation_(parse_mm(arguments, "stereo", 0, "a distance from 0 to 1e6 mm", 0)),
          pair_(given(arguments, "stereo")),
          crossed_(arguments["cross-eyed"].as<bool>()),
          anaglyph_(arguments["anaglyph"].as<bool>())
    {
        if ((crossed_ || anaglyph_) && !pair_)
            throw UsageError(std::string(crossed_ ? "--cross-eyed" : "--anaglyph") +
                             " needs --stereo MM, the eyes' distance");
        if (crossed_ && anaglyph_)
            throw UsageError("--cross-eyed and --anaglyph do not go together");
        if (given(arguments, "grid")) {
            if (pair_)
                throw UsageError("--grid and --stereo do not go together");
            grid_ = parse_size("grid", text_of(arguments, "grid"), largest_grid, "CxR");
        }
    }

    std::vector<Eye> eyes_for(Eye middle, const FrameMetadata& metadata) const
    {
        if (pair_)
            return eye_pair(middle, separation_);
        if (grid_.width == 0)
            return {middle};
        return eye_grid(middle, grid_.width, grid_.height, viewing_zone(metadata, middle.distance));
    }

    void check_size(const View& view) const
    {
        const int columns = pair_ && !anaglyph_ ? 2 : std::max(1, grid_.width),
                  rows = std::max(1, grid_.height);
        const int between = pair_ ? 0 : border;
        if (columns * (view.width + between) - between > largest_side ||
            rows * (view.height + between) - between > largest_side)
            throw UsageError(std::to_string(columns) + " by " + std::to_string(rows) +
                             " views of " + std::to_string(view.width) + "x" +
                             std::to_string(view.height) + " pixels are more than " +
                             std::to_string(largest_side) +
                             " pixels one way; a smaller --size would help");
    }

    Image as_one(std::vector<Image> pictures) const
    {
        if (anaglyph_)
            return anaglyph(pictures[0], pictures[1]);
        if (crossed_)
            std::swap(pictures[0], pictures[1]);
        if (pictures.size() == 1)
            return std::move(pictures[0]);
        return tiled(pictures, pair_ ? 2 : grid_.width, pair_ ? 0 : border);
    }

private:
    static constexpr int largest_grid = 64, border = 4;
    double separation_;
    bool pair_, crossed_, anaglyph_;
    PixelSize grid_;
};

/// What of a view can only be judged once the frame is known.
void check_view(const View& view, const FrameMetadata& metadata)
{
    if (!(view.focus > -view.eye.distance))
        throw UsageError("--focus " + std::to_string(view.focus) +
                         ": that is not in front of the eye, which is " +
                         std::to_string(view.eye.distance) + " mm in front of the sheet");
    if (!(view.film_gap > -metadata.sheet.thickness))
        throw UsageError("--film-gap " + std::to_string(view.film_gap) +
                         ": that is not behind the lenses, whose focus is " +
                         std::to_string(metadata.sheet.thickness) + " mm behind them");
    if (view.model == LensModel::full && !has_surface(metadata.sheet))
        throw UsageError("--lens-model full: these lenses have no surface that reaches their edge");
}

/// The same for each place of an eye that moves.
void check_stop(const Eye& stop, const View& view)
{
    if (!(stop.distance > 0))
        throw UsageError(
            "--path: from this --eye it goes behind the sheet; a lesser span would do");
    if (!(view.focus > -stop.distance))
        throw UsageError("--path: it comes as near to the sheet as " +
                         std::to_string(stop.distance) + " mm, and --focus " +
                         std::to_string(view.focus) + " would be behind the eye there");
}

/// What the options say of a view; where they say nothing of the eye and the size, these are left
/// to the frame.
View parse_view(const options::variables_map& arguments)
{
    View view;
    view.pupil = parse_mm(arguments, "pupil", 0, "a diameter from 0 to 1e6 mm", 0);
    view.focus = parse_mm(arguments, "focus", -1e6, "mm behind the sheet, from -1e6 to 1e6,", 0);
    view.film_gap = parse_mm(arguments, "film-gap", -1e6, "mm, from -1e6 to 1e6,", 0);
    view.blur = parse_mm(arguments, "lens-blur", 0, "a diameter from 0 to 1e6 mm", 0);
    if (given(arguments, "lens-model"))
        view.model = parse_model(text_of(arguments, "lens-model"));
    constexpr int plain_samples = 3, pupil_samples = 8;
    view.samples = given(arguments, "samples") ? in_range(arguments, "samples", 1, most_samples)
                   : view.pupil > 0 || view.blur > 0 ? pupil_samples
                                                     : plain_samples;
    if (given(arguments, "eye"))
        view.eye = parse_eye(text_of(arguments, "eye"));
    if (given(arguments, "size")) {
        const PixelSize size = parse_size("size", text_of(arguments, "size"), largest_side);
        view.width = size.width;
        view.height = size.height;
    }
    if (given(arguments, "part"))
        view.part = parse_part(text_of(arguments, "part"));
    return view;
}

int run(const options::variables_map& arguments)
{
    const std::string output = text_of(arguments, "output");
    const bool html = html_is_wanted(arguments);
    if (output.empty() && !html)
        throw UsageError("-o VIEW is missing");
    if (given(arguments, "focus") && !given(arguments, "pupil") && !html)
        throw UsageError("--focus needs --pupil MM: an eye without one sees every depth sharply");
    check_series_options(arguments, output);
    View view = parse_view(arguments);
    const int threads = in_range(arguments, "threads", 0, 1024);
    const ArrangementOfViews seen(arguments);
    if (html)
        check_writable(text_of(arguments, "html"));
    const Movement movement(arguments);
    std::optional<PictureSeries> series;
    if (movement.any()) {
        series.emplace(arguments, output, in_range(arguments, "steps", 2, 10000), 1);
    } else if (!output.empty()) {
        if (is_animation(output))
            throw UsageError("-o " + output + ": an animation needs --path, how the eye moves");
        format_for(output);
        check_writable(output);
    }

    const Frame frame = read_frame_with_metadata(inputs_of(arguments)[0],
                                                 text_of(arguments, "sheet"));
    stop_if_interrupted();
    if (!given(arguments, "eye"))
        view.eye = centre_eye(*frame.metadata);
    check_view(view, *frame.metadata);
    if (html)
        write_html(arguments, frame, view);
    if (output.empty())
        return exit_done;
    if (!given(arguments, "size"))
        set_view_size(view, frame.metadata->film, default_longer_side);

    seen.check_size(view);
    const std::vector<Eye> stops = movement.eyes_about(view.eye, *frame.metadata);
    for (const Eye& stop : stops)
        check_stop(stop, view);
    const Progress bar = progress_bar("replay");
    for (std::size_t i = 0; i < stops.size(); ++i) {
        auto pictures = replay_each(frame, view, seen.eyes_for(stops[i], *frame.metadata), threads,
                                    piece_of(bar, int(i), int(stops.size())));
        if (!pictures)
            throw Interrupted();
        Image picture = seen.as_one(std::move(*pictures));
        if (series)
            series->add(std::move(picture));
        else
            write_frame(output, Frame{std::move(picture), std::nullopt});
    }
    if (series)
        series->finish(movement.there_and_back());
    return exit_done;
}

} // namespace

const Command replay_command = {
    "replay",
    "what an eye sees of a frame through its lens sheet",
    "FRAME (-o VIEW | --html PAGE) [--eye X,Y,DISTANCE] [--size WxH] [--stereo MM | --grid CxR] "
    "[--path KIND]",
    "Draws the view that an eye at a given place has of a frame under its lens sheet. The sheet\n"
    "fills the picture. From the aperture's centre (the default) it is the picture that the\n"
    "scene's perspective camera takes; beyond the viewing zone the eye sees side lobes, and black\n"
    "where it looks past the film. A pupil blurs what is not at the depth that it focuses on.\n",
    1,
    1,
    make_options,
    run_from_map<run>};

} // namespace integral
