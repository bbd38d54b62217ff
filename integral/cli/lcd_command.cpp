// SPDX-License-Identifier: AGPL-3.0-or-later
// integral lcd: turns frames, quilts and views into a light-field panel's image, and shows pictures
// on a display.
#include "integral/cli/lcd_cards.h"
#include "integral/cli/lcd_video.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/panel/panel_files.h"
#include "integral/panel/panel_page.h"
#include "integral/screen/screen_text.h"
#include "integral/sheet/panel_render.h"
#include "integral/sheet/panel_text.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>

namespace integral {
namespace {

void print(bool as_json, const Json& json, const std::string& text)
{
    std::cout << (as_json ? json.dump(2) + "\n" : text);
}

/// The inputs that make one image each: as PanelImages groups them, or each by itself if one of
/// them brings its depth along.
std::vector<Arguments> groups_of(const LcdOptions& o, const PanelImages& images)
{
    if (std::none_of(o.inputs.begin(), o.inputs.end(),
                     [&o](const std::string& input) { return has_own_depth(input, o.depth); }))
        return images.groups(o.inputs);
    std::vector<Arguments> groups;
    for (const std::string& input : o.inputs)
        groups.push_back({input});
    return groups;
}

/// Throws UsageError for options that no group's kind of picture uses.
void check_depth_options(const LcdOptions& o, const std::vector<Arguments>& groups)
{
    if (!o.depth.range && !o.given_views.given_aspect)
        return;
    const auto by_depth = std::count_if(groups.begin(), groups.end(), [&o](const Arguments& group) {
        return shows_by_depth(group, o.depth);
    });
    if (by_depth == 0)
        throw_if_given({{"depth-range", o.depth.range}}, "is for pictures with depth and pairs");
    if (by_depth == std::ptrdiff_t(groups.size()))
        throw_if_given({{"aspect", o.given_views.given_aspect}},
                       "is for quilts and views; pictures with depth have a shape");
}

/// Views of a picture with depth.
ViewInput depth_views(const LcdOptions& o, const PanelImages& images, const Arguments& group)
{
    const PanelImageOptions& image = images.options();
    DepthViewsRequest request;
    request.panel = images.panel();
    request.grid = image.views;
    if (image.width > 0)
        request.size = PixelSize{image.width, image.height};
    request.fit = image.fit;
    request.right_to_left = image.right_to_left;
    request.command = "lcd";
    request.threads = image.threads;
    return views_by_depth(group, o.depth, request);
}

Frame image_of(const LcdOptions& o, PanelImages& images, const Arguments& group)
{
    return shows_by_depth(group, o.depth)
               ? images.image_of_views(group[0], depth_views(o, images, group))
               : images.image_of(group);
}

PanelPictures pictures_of(const LcdOptions& o, PanelImages& images, const Arguments& group)
{
    return shows_by_depth(group, o.depth)
               ? images.pictures_of_views(group[0], depth_views(o, images, group))
               : images.pictures_of(group);
}

/// --html: writes the page of the input or test card.
void make_page(const LcdOptions& o, const LcdRequest& lcd, PanelImages& images,
               const std::vector<Arguments>& groups)
{
    if (groups.size() > 1)
        throw UsageError("--html makes a page of one picture; several are given");
    check_outputs({o.html});
    const Arguments& group = groups[0];
    write_file(*o.html, takes_whole_video(o) ? panel_video_page(images, group[0])
                                             : panel_page(images,
                                                          lcd.card ? images.pictures_of(*lcd.card)
                                                                   : pictures_of(o, images, group),
                                                          group[0]));
}

/// The report on images as JSON, with the bars of a lenses' card.
Json report_json(const LcdRequest& lcd, const Panel& panel, const Json& images)
{
    Json report = {{"panel", panel.name}, {"images", images}};
    if (lcd.image.lens_card)
        report["lens_card"] = lens_card_json(*lcd.image.lens_card);
    return report;
}

/// --html, --show and -o: makes the images of all inputs, or a test card.
void make_images(const LcdOptions& o, const LcdRequest& lcd, const Panel& panel)
{
    PanelImages images(panel, lcd.image);
    const auto groups = lcd.card ? std::vector<Arguments>{{"--card"}} : groups_of(o, images);
    if (!lcd.card)
        check_depth_options(o, groups);
    if (o.show && groups.size() > 1)
        throw UsageError("--show shows one image; -o makes several, which --play plays");
    if (o.show)
        check_display(panel.film.width, panel.film.height, groups[0][0], lcd.showing);
    if (o.html)
        make_page(o, lcd, images, groups);
    if (lcd.output.empty() && !o.show)
        return;
    if (takes_whole_video(o))
        return write_images_of_video(o, lcd, panel);
    Arguments paths(groups.size());
    if (!lcd.output.empty() && lcd.card) {
        check_panel_file(lcd.output);
        paths = {lcd.output};
    } else if (!lcd.output.empty()) {
        paths = panel_files(lcd.output, groups);
    }
    Json report = Json::array();
    for (std::size_t k = 0; k < groups.size(); ++k) {
        stop_if_interrupted();
        const auto begun = std::chrono::steady_clock::now();
        Frame frame = lcd.card ? images.card(*lcd.card) : image_of(o, images, groups[k]);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
        report.push_back({{"output", paths[k]},
                          {"width", frame.image.width},
                          {"height", frame.image.height},
                          {"views", images.views()},
                          {"seconds", taken.count()}});
        if (!paths[k].empty())
            write_frame(paths[k], frame);
        if (o.show)
            return show_picture(frame.image, groups[k][0], lcd.showing);
    }
    if (o.json)
        std::cout << report_json(lcd, panel, report).dump(2) << '\n';
}

/// Handles --card pitch: makes a card, or the description that the readings of cards give.
void use_pitch_card(const LcdOptions& o, LcdRequest lcd, const Panel& panel)
{
    const auto card = lens_card_of(o, panel);
    if (!card)
        return make_images(o, lcd, panel);
    if (panel.calibration && o.even)
        say("lcd", lcd.panel + ": the readings take the place of the maker's calibration");
    if (writes_panel(o, *card))
        return write_lens_panel(o, *card);
    const std::string text = usage_checked("--card pitch: ",
                                           [&] { return lens_card_text(o, *card); });
    if (!lcd.output.empty())
        check_panel_file(lcd.output);
    if (!o.json && lcd.output != "-")
        std::cout << text << std::flush;
    lcd.image.lens_card = card;
    make_images(o, lcd, card->panel);
}

/// Handles --panel: makes images, or prints the panel's description.
void use_panel(const LcdOptions& o, const LcdRequest& lcd)
{
    const bool has_video = takes_whole_video(o);
    if (o.list_displays)
        throw UsageError("--list-displays takes no other option");
    if (o.play && !has_video)
        throw UsageError("--panel with --play takes a quilt video; make the images of other "
                         "pictures with -o, then play them");
    if (o.play)
        throw_if_given({{"output", o.output}, {"html", o.html}}, "does not work with --play");
    else
        throw_if_given({{"fps", o.fps}, {"loop", o.loop}}, "is for --play");
    if (o.seconds && !o.show && !o.play)
        throw UsageError("--seconds is for --show and --play");
    check_panel_options(o, lcd);
    const Panel panel = panel_of(lcd);
    if (panel.calibration)
        for (const std::string& what : panel.calibration->assumed)
            say("lcd", lcd.panel + ": " + what);
    if (o.describe)
        return print_result(o.output, to_json(panel));
    if (o.camera)
        return print_result(
            o.output,
            ini_text(panel_render(panel, o.quilt || o.views
                                             ? std::optional(quilt_for(panel, lcd.image.views))
                                             : std::nullopt)));
    if (lcd.card == PanelCard::pitch)
        return use_pitch_card(o, lcd, panel);
    if (o.play)
        return play_on_panel(o, lcd, panel);
    make_images(o, lcd, panel);
}

/// Throws UsageError if the options of showing contradict each other.
void check_show_options(const LcdOptions& o)
{
    if (o.list_displays && (o.play || o.show || !o.inputs.empty()))
        throw UsageError("--list-displays takes no other option");
    if (!o.play)
        throw_if_given({{"fps", o.fps}, {"loop", o.loop}}, "is for --play");
    if (!o.play && !o.show && o.seconds)
        throw UsageError("--seconds is for --show and --play");
    if ((o.play || o.show) && o.inputs.empty())
        throw UsageError("a picture to show is missing");
    if (o.show && !o.play && o.inputs.size() > 1)
        throw UsageError("--show shows one picture; --play shows several one after another");
    for (const std::string& input : o.inputs)
        if (o.play && input == "-")
            throw UsageError("--play reads files, not standard input");
}

/// Handles everything without --panel.
void use_display(const LcdOptions& o, const LcdRequest& lcd)
{
    if (o.output || o.html || o.card || o.even || o.camera || o.describe)
        throw UsageError("--panel NAME|FILE.json is missing; --list prints the names");
    check_show_options(o);
    const bool has_video = takes_whole_video(o);
    if (o.list_displays) {
        const Desktop desktop;
        return print(o.json, screens_json(desktop.screens()), screens_text(desktop.screens()));
    }
    if (o.play && has_video)
        return play_as_it_is(o, lcd);
    if (o.play)
        return print_play_report(o, play_files(o.inputs, lcd.playing, lcd.showing));
    if (!o.show)
        throw UsageError("there is nothing to do; --panel NAME with -o FILE makes a panel's image, "
                         "--show and --play show pictures");
    const Image picture = lcd.image.video_time
                              ? picture_of_video(o.inputs[0], *lcd.image.video_time)
                              : read_views(o.inputs[0], false).image;
    stop_if_interrupted();
    show_picture(picture, o.inputs[0], lcd.showing);
}

int run(const LcdOptions& o)
{
    const LcdRequest request = lcd_request(o);
    if (!o.panel || o.inputs.empty())
        throw_if_given({{"depth", o.depth.depth}, {"depth-range", o.depth.range}},
                       "is for INPUT on a --panel");
    if (o.list) {
        if (!o.inputs.empty() || o.panel)
            throw UsageError("--list takes no other option");
        print(o.json, panels_json(), panels_text());
    } else if (o.panel) {
        use_panel(o, request);
    } else {
        use_display(o, request);
    }
    return exit_done;
}

} // namespace

const Command lcd_command = {
    "lcd",
    "frames, quilts and views on a light-field panel: its image, test cards; shown or played",
    "INPUT... --panel NAME|FILE.json (-o IMAGE | --html PAGE) | --panel NAME --card CARD "
    "[--even BARS...] -o IMAGE | PICTURE --show DISPLAY | PICTURE... --play | --list",
    R"(Makes the image that a panel of pixels under a lens sheet has to be sent: every red, green and
blue of it takes the colour of the view that it is seen in. INPUT is a quilt, or the files of all
views: perspective pictures whose window lies on the panel, from eyes on a line across the
viewing zone at the viewing distance, view 0 from the far left, or where the lenses lie across
from the lowest eye (integral views --eyes makes such).
Or it is a picture with depth (RGBD, a phone's), or a stereo pair: its views are drawn by depth.
Or it is a frame: one rendered for the panel (--camera says how) is passed through to the bit; of
any other the views of its own zone are drawn first. Several frames or quilts make several images.
Or it is a quilt video (.mp4, .webm; needs the program ffmpeg): --play shows it on the panel, -o
writes the image of each of its pictures, and --at takes one.

Panels with a maker's calibration are interlaced by the mapping that its maker publishes,
others through the exact optics of their lenses. The image carries the geometry of a frame, so that
integral replay shows what eyes see of it; but where the panel is mirrored it does not.

--card pitch measures lenses that were laid on a display by hand, as the chart of integral print
measures a sheet: three cards with bars. --even takes the numbers of the bars that look even (on the
third card: the brightest), once for each card; -o card2.png is then the next card, and -o panel.json
the panel's description.

--html writes a page that does the same in a browser, on machines without this program: one file
with INPUT, also with a quilt video. In full screen on the panel it shows the image.

--show and --play bring pictures to a display pixel for pixel; they are never scaled. 8-bit samples
reach it as they are; 16-bit ones are rounded, linear light becomes sRGB, transparent parts black.
--play shows one after another at a steady rate and says how many were shown, dropped, and how late.
)",
    0,
    std::numeric_limits<int>::max(),
    described<LcdOptions>,
    run_with<LcdOptions, run>};

} // namespace integral
