// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/lcd_options.h"

#include "integral/base/number_text.h"
#include "integral/cli/choices.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"

namespace integral {
namespace {

constexpr int largest_view_side = 32768; // pixels

/// Reads a number above 0 and up to `most` into `value`, if the option was given.
void read_up_to(const char* option, const std::optional<std::string>& text, double most,
                double& value)
{
    if (!text)
        return;
    const std::string form = "a number above 0 and up to " + with_digits(most, 10);
    value = parse_number(option, *text, form.c_str());
    if (!(value > 0 && value <= most))
        throw_usage(option, *text, form);
}

PanelImageOptions image_options(const LcdOptions& o)
{
    PanelImageOptions image;
    if (o.views)
        image.views = parse_view_grid(*o.views);
    image.aspect = o.given_views.aspect();
    if (o.at)
        image.video_time = parse_video_time(*o.at);
    image.right_to_left = o.given_views.right_to_left;
    image.fit = o.fit.value();
    image.blend = {meaning_of("blend", o.blend, neighbours_choices),
                   meaning_of("sampling", o.sampling, neighbours_choices)};
    image.encoded = o.encoded;
    read_size("size", o.size, largest_view_side, image.width, image.height);
    image.lit_view = o.view;
    image.threads = o.threads.count();
    image.panel_name = "--panel " + o.panel.value_or("");
    image.tell = [](const std::string& what) { say("lcd", what); };
    image.progress = progress_bar;
    return image;
}

} // namespace

void declare(options::options_description& all, LcdOptions& o)
{
    add(all, "output,o", o.output, "FILE",
        "the panel's image: .png, .tiff or .exr; of several frames or quilts, or a quilt video, "
        "files with numbers before the extension, or a folder that is there already, for files of "
        "the inputs' names");
    add(all, "html", o.html, "PAGE",
        "a page that drives the panel: one file, with INPUT as a quilt, which a browser with WebGL "
        "2 interlaces and shows on the panel in full screen; each subpixel is that of -o");
    add(all, "panel", o.panel, "NAME|FILE.json",
        "the panel: one of --list, a description as --describe writes, or the calibration file of "
        "a Looking Glass or CubeVi display");
    add(all, "views", o.views, "CxR",
        "views of a quilt whose name does not tell, across and up, or how many to see a frame of "
        "other geometry from (default: as many as pixels are nearest to a lens's), or to draw by "
        "depth (default: as in the quilt for the panel), or of a card (default: 8)");
    add(all, "depth", o.depth.depth, "HOW",
        "draw the views by depth, out of one picture or a stereo pair: beside (INPUT's right half "
        "has the depths of its left half as greys, near white; default for names that end in "
        "rgbd), inside (as phones store it in a .jpg; default where it is), measured (default for "
        "two views: a pair in an .mpo or two files), FILE (a grey picture, or .pfm or .exr of mm "
        "behind the panel); or none: show a pair as two views");
    add(all, "depth-range", o.depth.range, "WHITE,BLACK",
        "depths, mm behind the panel, of white and black in grey depths, or else of the nearest "
        "and the farthest twentieth (default of greys and pairs: twice the panel's depth budget "
        "in front and behind)");
    declare(all, o.given_views);
    declare(all, o.fit);
    all.add_options()("blend", fills(o.blend, "WAY")->default_value(o.blend),
                      "between views: linear, or nearest, as displays' makers do");
    all.add_options()("sampling", fills(o.sampling, "WAY")->default_value(o.sampling),
                      "between pixels of a view: linear or nearest");
    add(all, "encoded", o.encoded,
        "blend the values as they are stored, as displays' own programs do; not linear light: "
        "several times as fast, edges between views a little darker");
    add(all, "size", o.size, "WxH",
        "pixels of each view that is seen of a frame (default: 1000 on the longer side) or drawn "
        "by depth (default: as in the quilt for the panel)");
    add(all, "viewing-distance", o.viewing_distance, "MM",
        "how far the viewers are from the panel (default: as the panel says)");
    add(all, "at", o.at, "S",
        "of a quilt video only the picture at S seconds: its first one from then on");
    add(all, "card", o.card, "CARD",
        "a test card in place of INPUT: views (each its number and colour), crosstalk (one view "
        "white), colours (red, green, blue and white bands in one view), pitch (three cards, by "
        "which the eye measures the lenses' pitch, slant and phase)");
    add(all, "even", o.even, "BARS",
        "with --card pitch: the bars that look even, or on the third card the brightest, as 7,20; "
        "again for each card that is read. -o IMAGE is then the next card, and -o FILE.json the "
        "panel's description, corrected");
    add(all, "view", o.view, "K",
        "the view that --card crosstalk or colours lights, from 0, the leftmost, or lowest where "
        "lenses lie across (default: every other; the middle one)");
    add(all, "list", o.list, "list the panels that are known by name");
    add(all, "describe", o.describe,
        "print the panel's description, to be changed and given to --panel");
    add(all, "camera", o.camera,
        "print what povray-integral needs to render for the panel: an INI file's lines; with "
        "--quilt or --views those for a quilt");
    add(all, "quilt", o.quilt,
        "with --camera: the lines for a quilt, as the display's maker recommends it (other panels: "
        "8x6 views), or with --views of that many views");
    add(all, "show", o.show, "DISPLAY",
        "show the picture on this display, pixel for pixel: its number or name, or auto, the only "
        "one of the picture's size. Escape, q or Ctrl-C ends it");
    add(all, "play", o.play,
        "show all pictures, or those of a video, one after another, on the display of --show "
        "(default auto); with --panel each picture of a quilt video is interlaced as it plays; the "
        "space bar pauses");
    add(all, "fps", o.fps, "N",
        "with --play: pictures a second (default: a video's own rate, else 30); late ones are "
        "dropped and counted");
    add(all, "loop", o.loop, "with --play: begin again after the last");
    add(all, "seconds", o.seconds, "S", "with --show and --play: end by itself after so long");
    add(all, "list-displays", o.list_displays,
        "list the displays: number, name, pixels, rate, place, and whether they show pictures as "
        "they are");
    declare(all, o.threads);
    add(all, "json", o.json, "print figures as JSON");
}

LcdRequest lcd_request(const LcdOptions& o)
{
    LcdRequest request;
    request.panel = o.panel.value_or("");
    request.output = o.output.value_or("");
    if (o.card)
        request.card = meaning_of("card", *o.card, card_choices);
    request.showing.display = o.show.value_or(request.showing.display);
    read_up_to("seconds", o.seconds, 1e7, request.showing.seconds);
    if (o.fps)
        read_up_to("fps", o.fps, 1000, request.playing.rate.emplace());
    request.playing.loop = o.loop;
    request.image = image_options(o);
    request.playing.threads = request.image.threads;
    if (o.viewing_distance)
        request.viewing_distance = parse_number_between(
            "viewing-distance", *o.viewing_distance, "a number of mm", 1, 1e6, "1 to 1000000 mm");
    return request;
}

void check_panel_options(const LcdOptions& o, const LcdRequest& lcd)
{
    if (int(o.describe) + int(o.camera) + int(lcd.card.has_value()) > 1)
        throw UsageError("--describe, --camera and --card do not go together");
    if (o.quilt && !o.camera)
        throw UsageError("--quilt is for --camera");
    if (!o.inputs.empty())
        throw_if_given({{"describe", o.describe}, {"camera", o.camera}, {"card", o.card}},
                       "takes no INPUT");
    if (lcd.panel.empty())
        throw UsageError("--panel NAME|FILE.json is missing; --list prints the names");
    if (o.describe || o.camera)
        throw_if_given({{"html", o.html}}, "is for pictures and cards");
    if (o.html && (o.html->empty() || *o.html == lcd.output))
        throw UsageError("--html: the name of a file is expected, other than that of -o");
    if (!o.describe && !o.camera && lcd.output.empty() && !o.show && !o.play && !o.html)
        throw UsageError("-o FILE is missing, --html PAGE, or --show DISPLAY or --play");
    if (!o.describe && !o.camera && !lcd.card && o.inputs.empty())
        throw UsageError("INPUT is missing: a frame, a quilt or views");
    if (lcd.image.lit_view && lcd.card != PanelCard::crosstalk && lcd.card != PanelCard::colours)
        throw UsageError("--view is for --card crosstalk and --card colours");
    if (lcd.card != PanelCard::pitch)
        throw_if_given({{"even", o.even}}, "is for --card pitch");
}

Panel panel_of(const LcdRequest& lcd)
{
    const Panel panel = usage_checked("--panel " + lcd.panel + ": ",
                                      [&] { return find_panel(lcd.panel); });
    if (!lcd.viewing_distance)
        return panel;
    return usage_checked(lcd.panel + ": ", [&] { return seen_from(panel, *lcd.viewing_distance); });
}

} // namespace integral
