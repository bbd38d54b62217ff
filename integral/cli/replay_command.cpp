// SPDX-License-Identifier: AGPL-3.0-or-later
// integral replay: what an eye sees of a frame through its sheet.
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/replay/replay.h"

#include <cmath>

namespace integral {
namespace {

constexpr int default_longer_side = 1000, largest_side = 32768, most_samples = 64;
constexpr double farthest = 1e9; // mm

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()
        ("output,o", options::value<std::string>()->value_name("VIEW"),
         "the picture to write: .png, .exr or .tiff; - writes a PNG to standard output")
        ("eye", options::value<std::string>()->value_name("X,Y,DISTANCE"),
         "the eye: mm to the right of and above the sheet's centre, and mm in front of the sheet "
         "(default: the centre of the frame's capture aperture)")
        ("size", options::value<std::string>()->value_name("WxH"),
         "pixels of the view (default: the film's shape, 1000 on the longer side)")
        ("samples", options::value<int>()->value_name("N")->default_value(3),
         "N by N samples in each pixel, 1 to 64, averaged in linear light")
        ("sheet", options::value<std::string>()->value_name("FILE.json"),
         "geometry for a frame that carries none, or instead of its own")
        ("threads", options::value<int>()->value_name("N")->default_value(0),
         "threads to work with (0: one per core)")
        ("help", "print this");
    return all;
}

Eye parse_eye(const std::string& text)
{
    constexpr char form[] = "X,Y,DISTANCE (mm, DISTANCE greater than 0)";
    const auto v = parse_numbers("eye", text, form, 3, 3);
    if (!(v[2] > 0 && v[2] <= farthest && std::fabs(v[0]) <= farthest && std::fabs(v[1]) <= farthest))
        throw UsageError("--eye " + text + ": " + form + " is expected, each at most 1e9");
    return {v[0], v[1], v[2]};
}

int in_range(const options::variables_map& arguments, const char* option, int least, int most)
{
    const int value = arguments[option].as<int>();
    if (value < least || value > most)
        throw UsageError(std::string("--") + option + " " + std::to_string(value) +
                         ": a whole number from " + std::to_string(least) + " to " +
                         std::to_string(most) + " is expected");
    return value;
}

int run(const options::variables_map& arguments)
{
    const std::string output = text_of(arguments, "output");
    if (output.empty())
        throw UsageError("-o VIEW is missing");
    View view;
    view.samples = in_range(arguments, "samples", 1, most_samples);
    const int threads = in_range(arguments, "threads", 0, 1024);
    if (given(arguments, "eye"))
        view.eye = parse_eye(text_of(arguments, "eye"));
    if (given(arguments, "size")) {
        const PixelSize size = parse_size("size", text_of(arguments, "size"), largest_side);
        view.width = size.width;
        view.height = size.height;
    }
    format_for(output);
    check_writable(output);

    const Frame frame =
        read_frame_with_metadata(inputs_of(arguments)[0], text_of(arguments, "sheet"));
    stop_if_interrupted();
    if (!given(arguments, "eye"))
        view.eye = centre_eye(*frame.metadata);
    if (!given(arguments, "size"))
        set_view_size(view, frame.metadata->film, default_longer_side);

    auto image = replay(frame, view, threads, progress_bar("replay"));
    if (!image)
        throw Interrupted();
    write_frame(output, Frame{std::move(*image), std::nullopt});
    return exit_done;
}

} // namespace

const Command replay_command = {
    "replay",
    "what an eye sees of a frame through its lens sheet",
    "FRAME -o VIEW [--eye X,Y,DISTANCE] [--size WxH]",
    "Draws the view that an eye at a given place has of a frame under its lens sheet. The sheet\n"
    "fills the picture. From the aperture's centre (the default) it is the picture that the\n"
    "scene's perspective camera takes; beyond the viewing zone the eye sees side lobes, and black\n"
    "where it looks past the film.\n",
    1, 1, make_options, run};

} // namespace integral
