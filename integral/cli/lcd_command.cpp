// SPDX-License-Identifier: AGPL-3.0-or-later
// integral lcd: frames, quilts and views as a light-field panel's image; and pictures shown on a
// display.
#include "integral/base/number_text.h"
#include "integral/cli/lcd_options.h"
#include "integral/io/image_file.h"
#include "integral/io/picture_series.h"
#include "integral/lightfield/camera_words.h"
#include "integral/output/quilt.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <set>

namespace integral {
namespace {

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

/// The path of one of several images. A panel's image is no quilt, so that its name in a folder
/// loses a quilt's end.
std::string path_of(const std::string& output, const std::vector<std::string>& group, int index,
                    int count)
{
    if (std::filesystem::is_directory(output))
        return (std::filesystem::path(output) /
                std::filesystem::path(without_grid(group[0])).filename())
            .string();
    return count == 1 ? output : numbered(output, index + 1, count);
}

/// Throws UsageError for the name of a quilt, which a panel's image would be taken for.
void check_name(const std::string& path)
{
    if (grid_in_name(path))
        throw UsageError("-o " + path + ": such a name says that it is a quilt; " +
                         without_grid(path) + " would do");
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
    std::set<std::string> paths;
    for (int k = 0; k < count; ++k) {
        const std::string path = path_of(output, groups[k], k, count);
        check_name(path);
        if (!paths.insert(path).second)
            throw UsageError("-o " + output + ": two inputs would make " + path +
                             "; -o NAME.png numbers the images");
        format_for(path);
        check_writable(path);
        for (const std::string& input : groups[k])
            if (std::filesystem::exists(path) && std::filesystem::equivalent(path, input))
                throw UsageError("-o " + output + ": it would overwrite the input " + input);
    }
}

void make_images(const LcdOptions& o, const LcdRequest& lcd, const Panel& panel)
{
    PanelImages images(panel, lcd.image);
    const auto groups = lcd.card ? std::vector<std::vector<std::string>>{{"--card"}}
                                 : images.groups(o.inputs);
    if (o.show && groups.size() > 1)
        throw UsageError("--show shows one image; -o makes several, which --play plays");
    if (!lcd.output.empty() && lcd.card) {
        check_name(lcd.output);
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
        if (o.show)
            return show_picture(frame.image, groups[k][0], lcd.showing);
    }
    if (o.json)
        std::cout << nlohmann::ordered_json{{"panel", panel.name}, {"images", report}}.dump(2)
                  << '\n';
}

/// An INI file's lines that render for a panel: its image, or a quilt of so many views.
std::string settings_for(Panel panel, const std::optional<ViewGrid>& quilt)
{
    constexpr int longer_side = 4096; // of a quilt, pixels at least
    Film& film = panel.film;
    if (quilt) {
        const int finer = (longer_side - 1) / std::max(film.width, film.height) + 1;
        film = {film.width * finer, film.height * finer, (1.0 / finer) * film.pixel_pitch};
    }
    return "Width=" + std::to_string(film.width) + "\nHeight=" + std::to_string(film.height) +
           "\nIntegral_Camera=\"" + camera_words(frame_geometry(panel)) + "\"\n" +
           (quilt ? "Integral_Quilt=" + size_text(quilt->columns, quilt->rows) + "\n" : "");
}

/// All that --panel does: makes images, or prints what the panel is.
void use_panel(const LcdOptions& o, const LcdRequest& lcd)
{
    if (o.play || o.list_displays)
        throw UsageError("--panel does not go with --play or --list-displays: make the images "
                         "with -o, then play them");
    if (o.fps || o.loop)
        throw UsageError(std::string(o.fps ? "--fps" : "--loop") + " is for --play");
    if (o.seconds && !o.show)
        throw UsageError("--seconds is for --show and --play");
    check_panel_options(o, lcd);
    const Panel panel = panel_of(lcd);
    if (panel.calibration)
        for (const std::string& what : panel.calibration->assumed)
            say("lcd", lcd.panel + ": " + what);
    if (o.describe)
        return print_result(o.output, to_json(panel));
    if (o.camera)
        return print_result(o.output, settings_for(panel, lcd.image.views));
    make_images(o, lcd, panel);
}

/// Throws UsageError where the options of showing make no sense together.
void check_show_options(const LcdOptions& o)
{
    if (o.list_displays && (o.play || o.show || !o.inputs.empty()))
        throw UsageError("--list-displays stands alone");
    if (!o.play && (o.fps || o.loop))
        throw UsageError(std::string(o.fps ? "--fps" : "--loop") + " is for --play");
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

/// All that is done without --panel.
void use_display(const LcdOptions& o, const LcdRequest& lcd)
{
    if (o.output || o.card || o.camera || o.describe)
        throw UsageError("--panel NAME|FILE.json is missing; --list tells the names");
    check_show_options(o);
    if (o.list_displays)
        return list_displays(o.json);
    if (o.play) {
        const PlayReport report = play_files(o.inputs, lcd.playing, lcd.showing);
        if (report.shown > 0)
            print_report(report, o.json);
        if (report.interrupted)
            throw Interrupted();
        return;
    }
    if (!o.show)
        throw UsageError("there is nothing to do; --panel NAME with -o FILE makes a panel's image, "
                         "--show and --play show pictures");
    const Image picture = read_views(o.inputs[0], false).image;
    stop_if_interrupted();
    show_picture(picture, o.inputs[0], lcd.showing);
}

int run(const LcdOptions& o)
{
    const LcdRequest request = lcd_request(o);
    try {
        if (o.list) {
            if (!o.inputs.empty() || o.panel)
                throw UsageError("--list stands alone");
            list_panels(o.json);
        } else if (o.panel) {
            use_panel(o, request);
        } else {
            use_display(o, request);
        }
    } catch (const RequestError& error) {
        throw UsageError(error.what());
    }
    return exit_done;
}

} // namespace

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
    "Panels with a maker's calibration are interlaced by the mapping that its maker "
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
    described<LcdOptions>,
    run_with<LcdOptions, run>};

} // namespace integral
