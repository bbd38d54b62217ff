// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/lcd_show.h"

#include "integral/base/number_text.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/output/screen_window.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <thread>

namespace integral {
namespace {

/// A positive number of an option, `fallback` if it was not given.
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

double parse_fps(const options::variables_map& arguments)
{
    return positive(arguments, "fps", 1000, 30);
}
double parse_seconds(const options::variables_map& arguments)
{
    return positive(arguments, "seconds", 1e7, 0);
}

std::string wanted_display(const options::variables_map& arguments)
{
    return given(arguments, "show") ? text_of(arguments, "show") : "auto";
}

/// The sizes of files that are to be played: all the same.
PixelSize common_size(const std::vector<std::string>& files)
{
    PixelSize first;
    for (const std::string& file : files) {
        stop_if_interrupted();
        if (file == "-")
            throw UsageError("--play reads files, not standard input");
        const auto [width, height] = picture_size(file);
        if (&file == &files.front())
            first = {width, height};
        else if (width != first.width || height != first.height)
            throw InputError(file + ": it has " + size_text(width, height) + " pixels, and " +
                             files.front() + " " + size_text(first.width, first.height) +
                             "; pictures that are played have one size");
    }
    return first;
}

ScreenPicture load_picture(const std::string& file, PixelSize size)
{
    ScreenPicture picture = screen_picture(read_views(file, false).image);
    if (picture.width != size.width || picture.height != size.height)
        throw InputError(file + ": it has " + size_text(picture.width, picture.height) +
                         " pixels, and had " + size_text(size.width, size.height) + " before");
    return picture;
}

void print_report(const options::variables_map& arguments, const PlayReport& report)
{
    char text[300];
    if (given(arguments, "json")) {
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

} // namespace

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

void check_show_options(const options::variables_map& arguments, int inputs)
{
    const bool plays = arguments["play"].as<bool>(), lists = arguments["list-displays"].as<bool>(),
               shows = given(arguments, "show");
    if (lists && (plays || shows || inputs > 0))
        throw UsageError("--list-displays stands alone");
    if (!plays && (given(arguments, "fps") || arguments["loop"].as<bool>()))
        throw UsageError(std::string(given(arguments, "fps") ? "--fps" : "--loop") +
                         " is for --play");
    if (!plays && !shows && given(arguments, "seconds"))
        throw UsageError("--seconds is for --show and --play");
    if ((plays || shows) && inputs == 0)
        throw UsageError("a picture to show is missing");
    if (shows && !plays && inputs > 1)
        throw UsageError("--show shows one picture; --play shows several one after another");
    parse_fps(arguments);
    parse_seconds(arguments);
}

int list_displays(const options::variables_map& arguments)
{
    const Desktop desktop;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    int number = 0;
    for (const Screen& screen : desktop.screens()) {
        ++number;
        if (given(arguments, "json"))
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
    if (given(arguments, "json"))
        std::cout << list.dump(2) << '\n';
    return exit_done;
}

int show_picture(const options::variables_map& arguments, const Image& picture,
                 const std::string& name)
{
    const Desktop desktop;
    const std::size_t k = choose_screen(desktop.screens(), wanted_display(arguments), name,
                                        picture.width, picture.height);
    ScreenWindow window(desktop.screens()[k], call(desktop.screens(), k));
    if (!show_still(window, screen_picture(picture), parse_seconds(arguments),
                    [] { return !interrupted(); }))
        throw Interrupted();
    return exit_done;
}

int play_files(const options::variables_map& arguments, const std::vector<std::string>& files)
{
    const PixelSize size = common_size(files);
    const int threads = in_range(arguments, "threads", 0, 1024);
    Playing playing;
    playing.rate = parse_fps(arguments);
    playing.seconds = parse_seconds(arguments);
    playing.source.count = static_cast<long long>(files.size());
    playing.source.loop = arguments["loop"].as<bool>();
    playing.source.keep = pictures_to_keep(sizeof(std::uint32_t) * std::size_t(size.width) *
                                           std::size_t(size.height));
    playing.source.threads = threads > 0 ? threads
                                         : std::max(1, int(std::thread::hardware_concurrency()));
    playing.source.load = [&](long long file) {
        return load_picture(files[std::size_t(file)], size);
    };

    const Desktop desktop;
    const std::size_t k = choose_screen(desktop.screens(), wanted_display(arguments), files.front(),
                                        size.width, size.height);
    PlayReport report;
    {
        ScreenWindow window(desktop.screens()[k], call(desktop.screens(), k));
        report = play(window, playing, [] { return !interrupted(); });
    }
    if (report.shown > 0)
        print_report(arguments, report);
    if (report.interrupted)
        throw Interrupted();
    return exit_done;
}

} // namespace integral
