// SPDX-License-Identifier: AGPL-3.0-or-later
// integral lcd: frames, quilts and views as a light-field panel's image; and pictures shown on a
// display.
#include "integral/cli/lcd_image.h"
#include "integral/cli/lcd_show.h"
#include "integral/cli/progress.h"
#include "integral/io/image_file.h"
#include "integral/io/picture_series.h"
#include "integral/lightfield/names.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>

namespace integral {
namespace {

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

void list_panels(const options::variables_map& arguments)
{
    if (given(arguments, "json")) {
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

int make_images(const options::variables_map& arguments)
{
    check_panel_options(arguments);
    const Panel panel = panel_of(arguments);
    if (panel.calibration)
        for (const std::string& what : panel.calibration->assumed)
            say("lcd", text_of(arguments, "panel") + ": " + what);
    if (arguments["describe"].as<bool>()) {
        print_result(arguments, to_json(panel));
        return exit_done;
    }
    if (arguments["camera"].as<bool>()) {
        print_result(arguments, "Width=" + std::to_string(panel.film.width) +
                                    "\nHeight=" + std::to_string(panel.film.height) +
                                    "\nIntegral_Camera=\"" + camera_words(panel) + "\"\n");
        return exit_done;
    }
    const std::string output = text_of(arguments, "output");
    PanelImages images(arguments, panel);
    const bool card = given(arguments, "card");
    const auto groups = card ? std::vector<std::vector<std::string>>{{"card"}}
                             : images.groups(inputs_of(arguments));
    if (given(arguments, "show") && groups.size() > 1)
        throw UsageError("--show shows one image; -o makes several, which --play plays");
    if (!output.empty() && card) {
        format_for(output);
        check_writable(output);
    } else if (!output.empty()) {
        check_outputs(output, groups);
    }
    nlohmann::ordered_json report = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < groups.size(); ++k) {
        stop_if_interrupted();
        const auto begun = std::chrono::steady_clock::now();
        Frame frame = card ? images.card() : images.image_of(groups[k]);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
        const std::string path = output.empty() ? ""
                                 : card         ? output
                                        : path_of(output, groups[k], int(k), int(groups.size()));
        report.push_back({{"output", path},
                          {"width", frame.image.width},
                          {"height", frame.image.height},
                          {"views", images.views()},
                          {"seconds", taken.count()}});
        if (!path.empty())
            write_frame(path, frame);
        if (given(arguments, "show"))
            return show_picture(arguments, frame.image, card ? "--card" : groups[k][0]);
    }
    if (given(arguments, "json"))
        std::cout << nlohmann::ordered_json{{"panel", panel.name}, {"images", report}}.dump(2)
                  << '\n';
    return exit_done;
}

int run(const options::variables_map& arguments)
{
    const auto inputs = inputs_of(arguments);
    const bool makes = given(arguments, "panel");
    if (arguments["list"].as<bool>()) {
        if (!inputs.empty() || makes)
            throw UsageError("--list stands alone");
        list_panels(arguments);
        return exit_done;
    }
    if (makes) {
        if (arguments["play"].as<bool>() || arguments["list-displays"].as<bool>())
            throw UsageError("--panel does not go with --play or --list-displays: make the images "
                             "with -o, then play them");
        if (given(arguments, "fps") || arguments["loop"].as<bool>())
            throw UsageError(std::string(given(arguments, "fps") ? "--fps" : "--loop") +
                             " is for --play");
        if (given(arguments, "seconds") && !given(arguments, "show"))
            throw UsageError("--seconds is for --show and --play");
        return make_images(arguments);
    }
    if (given(arguments, "output") || given(arguments, "card") || arguments["camera"].as<bool>() ||
        arguments["describe"].as<bool>())
        throw UsageError("--panel NAME|FILE.json is missing; --list tells the names");
    check_show_options(arguments, int(inputs.size()));
    if (arguments["list-displays"].as<bool>())
        return list_displays(arguments);
    if (arguments["play"].as<bool>())
        return play_files(arguments, inputs);
    if (!given(arguments, "show"))
        throw UsageError("there is nothing to do; --panel NAME with -o FILE makes a panel's image, "
                         "--show and --play show pictures");
    const Image picture = read_views(inputs[0], false).image;
    stop_if_interrupted();
    return show_picture(arguments, picture, inputs[0]);
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
    run_from_map<run>};

} // namespace integral
