// SPDX-License-Identifier: AGPL-3.0-or-later
// integral lcd: frames, quilts and views as a light-field panel's image; and pictures shown on a
// display.
#include "integral/cli/lcd_command.h"

#include "integral/base/number_text.h"
#include "integral/cli/picture_series.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>

namespace integral {
namespace {

constexpr int largest_view_side = 32768;

void add_panel_options(options::options_description& all)
{
    const auto value = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    all.add_options()("output,o", value("FILE"),
                      "the panel's image: .png, .tiff or .exr; of several frames or quilts files "
                      "with numbers before the extension, or a folder "
                      "that is there already, for files of the inputs' names")(
        "panel", value("NAME|FILE.json"),
        "the panel: one of --list, a description as --describe writes, or the calibration file of "
        "a Looking Glass display")(
        "views", value("CxR"),
        "views of a quilt whose name does not tell, across and up, or how many to see a frame of "
        "other geometry from (default: as many "
        "as pixels are nearest to a lens's), or of a card (default: 8)")(
        "blend", value("WAY")->default_value("linear"),
        "between views: linear, or nearest, as displays' makers do")(
        "sampling", value("WAY")->default_value("linear"),
        "between pixels of a view: linear or nearest")(
        "encoded", options::bool_switch(),
        "blend the values as they are stored, as displays' own programs do; not linear light: "
        "several times as fast, "
        "edges between views a little darker")(
        "size", value("WxH"),
        "pixels of each view that is seen of a frame (default: 1000 on the longer side)")(
        "viewing-distance", value("MM"),
        "how far the viewers are from the panel (default: as the panel says)")(
        "card", value("CARD"),
        "a test card in place of INPUT: views (each its number and colour), crosstalk (one view "
        "white), colours (red, green, blue and "
        "white bands in one view), pitch (bars of lines about the calibrated pitch)")(
        "view", options::value<int>()->value_name("K"),
        "the view that --card crosstalk or colours lights, from 0, the leftmost (default: every "
        "other; the middle one)")("list", options::bool_switch(),
                                  "list the panels that are known by name")(
        "describe", options::bool_switch(),
        "print the panel's description, to be changed and given to --panel")(
        "camera", options::bool_switch(),
        "print what povray-integral needs to render for the panel: an INI file's lines");
}

void add_show_options(options::options_description& all)
{
    const auto value = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    all.add_options()("show", value("DISPLAY"),
                      "show the picture on this display, pixel for pixel: its number or name, or "
                      "auto, the only one of the picture's size. "
                      "Escape, q or Ctrl-C ends it")(
        "play", options::bool_switch(),
        "show all pictures one after another, on the display of --show (default auto); the space "
        "bar pauses")(
        "fps", value("N"),
        "with --play: pictures a second (default 30); late ones are dropped and counted")(
        "loop", options::bool_switch(), "with --play: begin again after the last")(
        "seconds", value("S"), "with --show and --play: end by itself after so long")(
        "list-displays", options::bool_switch(),
        "list the displays: number, name, pixels, rate, place, and whether they show pictures as "
        "they are");
}

options::options_description make_options()
{
    options::options_description all("Options");
    add_panel_options(all);
    add_show_options(all);
    all.add_options()("threads", options::value<int>()->value_name("N")->default_value(0),
                      "threads to work with (0: one per core)")("json", "print figures as JSON")(
        "help", "print this");
    return all;
}

Neighbours neighbours(const options::variables_map& arguments, const char* option)
{
    const std::string word = text_of(arguments, option);
    if (word == "nearest")
        return Neighbours::nearest;
    if (word == "linear")
        return Neighbours::linear;
    throw UsageError(std::string("--") + option + " " + word + ": nearest or linear is expected");
}

PanelCard card_named(const std::string& word)
{
    if (word == "views")
        return PanelCard::views;
    if (word == "crosstalk")
        return PanelCard::crosstalk;
    if (word == "colours")
        return PanelCard::colours;
    if (word == "pitch")
        return PanelCard::pitch;
    throw UsageError("--card " + word + ": views, crosstalk, colours or pitch is expected");
}

/// A number above 0, `fallback` where the option was not given.
double positive(const options::variables_map& arguments, const char* option, double most,
                double fallback)
{
    if (!given(arguments, option))
        return fallback;
    const std::string form = "a number above 0 and up to " + with_digits(most, 10);
    const double value = parse_number(option, text_of(arguments, option), form.c_str());
    if (!(value > 0 && value <= most))
        throw UsageError(std::string("--") + option + " " + text_of(arguments, option) + ": " +
                         form + " is expected");
    return value;
}

void read_image_options(const options::variables_map& arguments, LcdOptions& lcd)
{
    PanelImageOptions& image = lcd.image;
    if (given(arguments, "views"))
        image.views = parse_view_grid(text_of(arguments, "views"));
    image.blend = {neighbours(arguments, "blend"), neighbours(arguments, "sampling")};
    image.encoded = arguments["encoded"].as<bool>();
    if (given(arguments, "size")) {
        const PixelSize size = parse_size("size", text_of(arguments, "size"), largest_view_side);
        image.width = size.width;
        image.height = size.height;
    }
    if (given(arguments, "view"))
        image.lit_view = arguments["view"].as<int>();
    image.threads = in_range(arguments, "threads", 0, 1024);
    image.panel_name = "--panel " + lcd.panel;
    image.tell = [](const std::string& what) { say("lcd", what); };
    image.progress = progress_bar;
    if (given(arguments, "viewing-distance")) {
        const std::string text = text_of(arguments, "viewing-distance");
        lcd.viewing_distance = parse_number("viewing-distance", text, "a number of mm");
        if (!(*lcd.viewing_distance >= 1 && *lcd.viewing_distance <= 1e6))
            throw UsageError("--viewing-distance " + text + ": 1 to 1000000 mm is expected");
    }
}

void list_panels(bool json)
{
    if (json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const Panel& panel : known_panels())
            list.push_back({{"name", panel.name},
                            {"width", panel.film.width},
                            {"height", panel.film.height},
                            {"pixel_pitch_mm", panel.film.pixel_pitch.x},
                            {"lens_pitch_mm", panel.sheet.pitch},
                            {"slant_degrees", panel.sheet.slant},
                            {"viewing_distance_mm", panel.aperture.distance}});
        std::cout << list.dump(2) << '\n';
        return;
    }
    std::printf("%-28s %11s %9s %10s %8s %9s\n", "", "pixels", "pixel mm", "lens mm", "slant",
                "from mm");
    for (const Panel& panel : known_panels()) {
        const std::string size = std::to_string(panel.film.width) + "x" +
                                 std::to_string(panel.film.height);
        std::printf("%-28s %11s %9.4f %10.4f %8.2f %9.0f\n", panel.name.c_str(), size.c_str(),
                    panel.film.pixel_pitch.x, panel.sheet.pitch, panel.sheet.slant,
                    panel.aperture.distance);
    }
}

void list_displays(bool json)
{
    const Desktop desktop;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    int number = 0;
    for (const Screen& screen : desktop.screens()) {
        ++number;
        if (json)
            list.push_back({{"number", number},
                            {"name", screen.name},
                            {"width", screen.width},
                            {"height", screen.height},
                            {"rate", screen.rate},
                            {"x", screen.x},
                            {"y", screen.y},
                            {"scaled", screen.scaled}});
        else
            std::cout << number << "  " << screen.name << "  "
                      << size_text(screen.width, screen.height)
                      << (screen.rate > 0 ? "  " + with_decimals(screen.rate, 2) + " Hz" : "")
                      << "  at " << screen.x << "," << screen.y << "  "
                      << (screen.scaled.empty() ? "pixel for pixel" : screen.scaled) << '\n';
    }
    if (json)
        std::cout << list.dump(2) << '\n';
}

void print_report(const PlayReport& report, bool as_json)
{
    char text[300];
    if (as_json) {
        const nlohmann::ordered_json json = {{"shown", report.shown},
                                             {"dropped", report.dropped},
                                             {"seconds", report.seconds},
                                             {"rate", report.rate},
                                             {"worst_lateness_ms", 1000 * report.worst_lateness}};
        std::cout << json.dump(2) << '\n';
        return;
    }
    std::snprintf(text, sizeof text,
                  "shown               %lld\n"
                  "dropped             %lld\n"
                  "rate                %.3f a second\n"
                  "worst lateness      %.1f ms\n",
                  report.shown, report.dropped, report.rate, 1000 * report.worst_lateness);
    std::cout << text;
}

/// The path of one of several images.
std::string path_of(const std::string& output, const std::vector<std::string>& group, int index,
                    int count)
{
    if (std::filesystem::is_directory(output))
        return (std::filesystem::path(output) / std::filesystem::path(group[0]).filename())
            .string();
    return count == 1 ? output : numbered(output, index + 1, count);
}

void check_outputs(const std::string& output, const std::vector<std::vector<std::string>>& groups)
{
    const int count = int(groups.size());
    if (output == "-" && count > 1)
        throw UsageError("-o -: several images need a name or a folder");
    if (!std::filesystem::is_directory(output)) {
        if (!output.empty() && output.back() == '/')
            throw OutputError(output + ": there is no such folder; make it first");
        format_for(output);
    }
    for (int k = 0; k < count; ++k) {
        const std::string path = path_of(output, groups[k], k, count);
        format_for(path);
        check_writable(path);
        for (const std::string& input : groups[k])
            if (std::filesystem::exists(path) && std::filesystem::equivalent(path, input))
                throw UsageError("-o " + output + ": it would overwrite the input " + input);
    }
}

/// Prints a result to standard output, or to -o's FILE whole.
void print_result(const LcdOptions& lcd, const std::string& text)
{
    write_file(lcd.output.empty() ? "-" : lcd.output, text);
}

void make_images(const LcdOptions& lcd, const Panel& panel)
{
    PanelImages images(panel, lcd.image);
    const auto groups = lcd.card ? std::vector<std::vector<std::string>>{{"--card"}}
                                 : images.groups(lcd.inputs);
    if (lcd.show && groups.size() > 1)
        throw UsageError("--show shows one image; -o makes several, which --play plays");
    if (!lcd.output.empty() && lcd.card) {
        format_for(lcd.output);
        check_writable(lcd.output);
    } else if (!lcd.output.empty()) {
        check_outputs(lcd.output, groups);
    }
    nlohmann::ordered_json report = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < groups.size(); ++k) {
        stop_if_interrupted();
        const auto begun = std::chrono::steady_clock::now();
        Frame frame = lcd.card ? images.card(*lcd.card) : images.image_of(groups[k]);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
        const std::string path = lcd.output.empty() || lcd.card
                                     ? lcd.output
                                     : path_of(lcd.output, groups[k], int(k), int(groups.size()));
        report.push_back({{"output", path},
                          {"width", frame.image.width},
                          {"height", frame.image.height},
                          {"views", images.views()},
                          {"seconds", taken.count()}});
        if (!path.empty())
            write_frame(path, frame);
        if (lcd.show)
            return show_picture(frame.image, groups[k][0], lcd.showing);
    }
    if (lcd.json)
        std::cout << nlohmann::ordered_json{{"panel", panel.name}, {"images", report}}.dump(2)
                  << '\n';
}

/// All that --panel does: makes images, or prints what the panel is.
void use_panel(const LcdOptions& lcd)
{
    if (lcd.play || lcd.list_displays)
        throw UsageError("--panel does not go with --play or --list-displays: make the images "
                         "with -o, then play them");
    if (lcd.has_fps || lcd.playing.loop)
        throw UsageError(std::string(lcd.has_fps ? "--fps" : "--loop") + " is for --play");
    if (lcd.has_seconds && !lcd.show)
        throw UsageError("--seconds is for --show and --play");
    check_panel_options(lcd);
    const Panel panel = panel_of(lcd);
    if (panel.calibration)
        for (const std::string& what : panel.calibration->assumed)
            say("lcd", lcd.panel + ": " + what);
    if (lcd.describe)
        return print_result(lcd, to_json(panel));
    if (lcd.camera)
        return print_result(lcd, "Width=" + std::to_string(panel.film.width) +
                                     "\nHeight=" + std::to_string(panel.film.height) +
                                     "\nIntegral_Camera=\"" + camera_words(panel) + "\"\n");
    make_images(lcd, panel);
}

/// Throws UsageError where the options of showing make no sense together.
void check_show_options(const LcdOptions& lcd)
{
    if (lcd.list_displays && (lcd.play || lcd.show || !lcd.inputs.empty()))
        throw UsageError("--list-displays stands alone");
    if (!lcd.play && (lcd.has_fps || lcd.playing.loop))
        throw UsageError(std::string(lcd.has_fps ? "--fps" : "--loop") + " is for --play");
    if (!lcd.play && !lcd.show && lcd.has_seconds)
        throw UsageError("--seconds is for --show and --play");
    if ((lcd.play || lcd.show) && lcd.inputs.empty())
        throw UsageError("a picture to show is missing");
    if (lcd.show && !lcd.play && lcd.inputs.size() > 1)
        throw UsageError("--show shows one picture; --play shows several one after another");
    for (const std::string& input : lcd.inputs)
        if (lcd.play && input == "-")
            throw UsageError("--play reads files, not standard input");
}

/// All that is done without --panel.
void use_display(const LcdOptions& lcd)
{
    if (!lcd.output.empty() || lcd.card || lcd.camera || lcd.describe)
        throw UsageError("--panel NAME|FILE.json is missing; --list tells the names");
    check_show_options(lcd);
    if (lcd.list_displays)
        return list_displays(lcd.json);
    if (lcd.play) {
        const PlayReport report = play_files(lcd.inputs, lcd.playing, lcd.showing);
        if (report.shown > 0)
            print_report(report, lcd.json);
        if (report.interrupted)
            throw Interrupted();
        return;
    }
    if (!lcd.show)
        throw UsageError("there is nothing to do; --panel NAME with -o FILE makes a panel's image, "
                         "--show and --play show pictures");
    const Image picture = read_views(lcd.inputs[0], false).image;
    stop_if_interrupted();
    show_picture(picture, lcd.inputs[0], lcd.showing);
}

int run(const options::variables_map& arguments)
{
    const LcdOptions lcd = lcd_options(arguments);
    try {
        if (lcd.list) {
            if (!lcd.inputs.empty() || !lcd.panel.empty())
                throw UsageError("--list stands alone");
            list_panels(lcd.json);
        } else if (!lcd.panel.empty()) {
            use_panel(lcd);
        } else {
            use_display(lcd);
        }
    } catch (const RequestError& error) {
        throw UsageError(error.what());
    }
    return exit_done;
}

} // namespace

LcdOptions lcd_options(const options::variables_map& arguments)
{
    LcdOptions lcd;
    lcd.inputs = inputs_of(arguments);
    lcd.output = text_of(arguments, "output");
    lcd.json = given(arguments, "json");
    lcd.panel = text_of(arguments, "panel");
    if (given(arguments, "card"))
        lcd.card = card_named(text_of(arguments, "card"));
    lcd.list = arguments["list"].as<bool>();
    lcd.describe = arguments["describe"].as<bool>();
    lcd.camera = arguments["camera"].as<bool>();
    lcd.show = given(arguments, "show");
    lcd.play = arguments["play"].as<bool>();
    lcd.list_displays = arguments["list-displays"].as<bool>();
    lcd.has_fps = given(arguments, "fps");
    lcd.has_seconds = given(arguments, "seconds");
    if (lcd.show)
        lcd.showing.display = text_of(arguments, "show");
    lcd.showing.seconds = positive(arguments, "seconds", 1e7, lcd.showing.seconds);
    lcd.playing.rate = positive(arguments, "fps", 1000, lcd.playing.rate);
    lcd.playing.loop = arguments["loop"].as<bool>();
    read_image_options(arguments, lcd);
    lcd.playing.threads = lcd.image.threads;
    return lcd;
}

void check_panel_options(const LcdOptions& lcd)
{
    if (int(lcd.describe) + int(lcd.camera) + int(lcd.card.has_value()) > 1)
        throw UsageError("--describe, --camera and --card do not go together");
    if ((lcd.describe || lcd.camera || lcd.card) && !lcd.inputs.empty())
        throw UsageError(std::string(lcd.describe ? "--describe"
                                     : lcd.camera ? "--camera"
                                                  : "--card") +
                         " takes no INPUT");
    if (lcd.panel.empty())
        throw UsageError("--panel NAME|FILE.json is missing; --list tells the names");
    if (!lcd.describe && !lcd.camera && lcd.output.empty() && !lcd.show)
        throw UsageError("-o FILE is missing, or --show DISPLAY");
    if (!lcd.describe && !lcd.camera && !lcd.card && lcd.inputs.empty())
        throw UsageError("INPUT is missing: a frame, a quilt or views");
    if (lcd.image.lit_view && lcd.card != PanelCard::crosstalk && lcd.card != PanelCard::colours)
        throw UsageError("--view is for --card crosstalk and --card colours");
}

Panel panel_of(const LcdOptions& lcd)
{
    Panel panel;
    try {
        panel = find_panel(lcd.panel);
    } catch (const std::invalid_argument& error) {
        throw UsageError("--panel " + lcd.panel + ": " + error.what());
    }
    if (!lcd.viewing_distance)
        return panel;
    try {
        return seen_from(panel, *lcd.viewing_distance);
    } catch (const std::invalid_argument& error) {
        throw UsageError(lcd.panel + ": " + error.what());
    }
}

const Command lcd_command = {
    "lcd",
    "frames, quilts and views on a light-field panel: its image, test cards; shown or played",
    "INPUT... --panel NAME|FILE.json -o IMAGE | --panel NAME --card CARD -o IMAGE | PICTURE --show "
    "DISPLAY | PICTURE... --play | --list",
    "Makes the image that a panel of pixels under a lens sheet has to be sent: every red, green "
    "and\n"
    "blue of it takes the colour of the view that it is seen in. INPUT is a quilt, or the files of "
    "all\n"
    "views: perspective pictures whose window lies on the panel, from eyes on a line across the\n"
    "viewing zone at the viewing distance, view 0 from the far left (integral views --eyes makes "
    "such).\n"
    "Or it is a frame: one rendered for the panel (--camera says how) is passed through to the "
    "bit; of\n"
    "any other the views of its own zone are drawn first. Several frames or quilts make several "
    "images.\n"
    "\n"
    "Panels with a Looking Glass calibration are interlaced by the mapping that its maker "
    "publishes,\n"
    "others through the exact optics of their lenses. The image carries the geometry of a frame, "
    "so that\n"
    "integral replay shows what eyes see of it; but where the panel is mirrored it does not.\n"
    "\n"
    "--show and --play bring pictures to a display pixel for pixel; they are never scaled. 8-bit "
    "samples\n"
    "reach it as they are; 16-bit ones are rounded, linear light becomes sRGB, transparent parts "
    "black.\n"
    "--play shows one after another at a steady rate and says how many were shown, dropped, and "
    "how late.\n",
    0,
    std::numeric_limits<int>::max(),
    make_options,
    run};

} // namespace integral
