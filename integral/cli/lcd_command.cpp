// SPDX-License-Identifier: AGPL-3.0-or-later
// integral lcd: pictures on a panel under a lens sheet.
#include "integral/cli/command.h"
#include "integral/cli/lcd_show.h"
#include "integral/cli/progress.h"
#include "integral/io/image_file.h"

#include <limits>

namespace integral {
namespace {

options::options_description make_options()
{
    options::options_description all("Options");
    add_show_options(all);
    all.add_options()
        ("threads", options::value<int>()->value_name("N")->default_value(0), "with --play: threads that read pictures ahead (0: one per core)")
        ("json", "with --play and --list-displays: print figures as JSON")
        ("help", "print this");
    return all;
}

int run(const options::variables_map& arguments)
{
    const auto inputs = inputs_of(arguments);
    check_show_options(arguments, int(inputs.size()));
    if (arguments["list-displays"].as<bool>())
        return list_displays(arguments);
    if (arguments["play"].as<bool>())
        return play_files(arguments, inputs);
    if (!given(arguments, "show"))
        throw UsageError("there is nothing to do; --show, --play or --list-displays is missing");
    const Image picture = read_views(inputs[0], false).image;
    stop_if_interrupted();
    return show_picture(arguments, picture, inputs[0]);
}

} // namespace

const Command lcd_command = {
    "lcd",
    "pictures on a panel, pixel for pixel: shown or played",
    "PICTURE --show DISPLAY | PICTURE... --play [--fps N] | --list-displays",
    "Shows pictures that are made for a panel on that panel: in a window without borders, each pixel\n"
    "of the picture on one of the display's. Pictures are never scaled: they have exactly as many\n"
    "pixels as the display, and a display that its desktop or its own electronics scale is refused.\n"
    "8-bit samples reach the display as they are; 16-bit ones are rounded, linear light becomes sRGB,\n"
    "transparent parts black.\n"
    "\n"
    "--play shows one picture after another at a steady rate, says at the end how many were shown and\n"
    "how many came too late and were dropped, and how late the latest was on its way to the display.\n",
    0, std::numeric_limits<int>::max(), make_options, run};

} // namespace integral
