// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures the error of frames against their run time. Renders six scenes behind two sheets with
// each setting of a ladder, and compares frames and their replayed views with a converged frame of
// many pixel_samples and beam_samples (doc/six-scenes.md).
#include "bench/error_against_time.h"
#include "bench/program.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdlib>
#include <regex>

namespace {

namespace options = boost::program_options;
namespace files = std::filesystem;
using namespace integral;
using namespace integral::bench;

std::string all_scenes()
{
    std::string text;
    for (const std::string& name : scene_names())
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()("output,o", options::value<std::string>()->value_name("FOLDER"),
                      "where the table, the plots and the frames are written")(
        "quick", "fewer settings and smaller frames: minutes instead of an hour")(
        "samplers", "only the settings that compare anti-aliasing with brute force")(
        "light-field", "only anti-aliasing in the light field and brute force; the reference has a "
                       "quarter of the samples")(
        "scene", options::value<std::vector<std::string>>()->value_name("NAME"),
        ("only this scene: " + all_scenes() + "; may be given again").c_str())(
        "size", options::value<std::string>()->value_name("WxH"),
        "pixels of the frames, multiples of 10 from 60 to 2000 (default: 240x160; 120x80 with "
        "--quick, --samplers or --light-field; K times that)")(
        "finer", options::value<int>()->value_name("K")->default_value(1),
        "make pixels and lenses K times finer, 1 to 8, as if the scene were K times as large")(
        "renderer", options::value<std::string>()->value_name("FILE"),
        "povray-integral (default: the one built beside this program)")(
        "scenes", options::value<std::string>()->value_name("FOLDER"),
        "the scenes (default: bench/scenes of this build's source)")("help", "print this");
    return all;
}

std::vector<std::string> chosen_scenes(const options::variables_map& arguments)
{
    if (!arguments.count("scene"))
        return scene_names();
    const auto chosen = arguments["scene"].as<std::vector<std::string>>();
    for (const std::string& name : chosen)
        if (std::count(scene_names().begin(), scene_names().end(), name) == 0)
            throw UsageError("--scene " + name + ": the scenes are " + all_scenes());
    return chosen;
}

Extent chosen_extent(const options::variables_map& arguments)
{
    return arguments.count("quick")         ? Extent::quick
           : arguments.count("light-field") ? Extent::light_field
           : arguments.count("samplers")    ? Extent::samplers
                                            : Extent::all;
}

void set_size(Renderer& renderer, const options::variables_map& arguments)
{
    const bool small = chosen_extent(arguments) != Extent::all;
    renderer.finer = arguments["finer"].as<int>();
    if (renderer.finer < 1 || renderer.finer > 8)
        throw UsageError("--finer " + std::to_string(renderer.finer) + ": 1 to 8 is expected");
    renderer.width = renderer.finer * (small ? 120 : 240);
    renderer.height = renderer.finer * (small ? 80 : 160);
    if (!arguments.count("size"))
        return;
    const std::string text = arguments["size"].as<std::string>();
    std::smatch match;
    const auto legal = [&](int side) {
        return side >= 60 && side <= 2000 && side % (10 * renderer.finer) == 0;
    };
    if (std::regex_match(text, match, std::regex("([0-9]{1,4})x([0-9]{1,4})"))) {
        renderer.width = std::stoi(match[1]);
        renderer.height = std::stoi(match[2]);
        if (legal(renderer.width) && legal(renderer.height))
            return;
    }
    throw UsageError("--size " + text + ": WIDTHxHEIGHT is expected, each a multiple of " +
                     std::to_string(10 * renderer.finer) + " from 60 to 2000");
}

Renderer make_renderer(const options::variables_map& arguments, const std::string& folder)
{
    Renderer renderer;
    set_size(renderer, arguments);
    const auto path = [&](const char* option, const files::path& usual) {
        return arguments.count(option) ? arguments[option].as<std::string>()
                                       : usual.lexically_normal().string();
    };
    renderer.program = path("renderer", own_folder() / "../bin/povray-integral");
    renderer.scene_folder = path("scenes", own_folder() / "../../bench/scenes");
    if (!files::exists(renderer.program))
        throw UsageError(renderer.program +
                         ": there is no renderer here; build it (make) or name it with --renderer");
    if (!files::is_directory(renderer.scene_folder))
        throw UsageError(renderer.scene_folder +
                         ": there are no scenes here; name their folder with --scenes");
    renderer.work_folder = folder + "/frames";
    return renderer;
}

std::string all_speedups(const std::vector<Panel>& panels)
{
    std::string text = speedups_summary(panels) + "\n";
    for (const Panel& panel : panels)
        text += speedups(panel);
    return text;
}

int run(const options::variables_map& arguments)
{
    if (!arguments.count("output"))
        throw UsageError("-o FOLDER is missing");
    const std::string folder = arguments["output"].as<std::string>();
    const std::vector<std::string> scenes = chosen_scenes(arguments);
    const Renderer renderer = make_renderer(arguments, folder);
    files::create_directories(renderer.work_folder);
    check_writable(folder + "/error-against-time.csv");

    const auto say = [](const std::string& line) { std::cout << line << std::endl; };
    std::vector<Panel> panels;
    for (const std::string& scene : scenes)
        for (const Sheet& sheet : sheets()) {
            panels.push_back(measure(renderer, scene, sheet, chosen_extent(arguments), say));
            say(speedups(panels.back()));
            // Written after each panel, so that an interruption loses only what is not finished.
            write_file(folder + "/error-against-time.csv", csv(panels));
            write_file(folder + "/fronts.md", fronts_table(panels));
            write_file(folder + "/eyes.csv", eyes_table(panels));
            write_file(folder + "/speedups.md", all_speedups(panels));
        }
    say(speedups_summary(panels));
    write_plots(panels, folder);
    const Honesty counts = honesty(panels);
    std::cout << "The program's own interval of 95% contains the measured error in " << counts.held
              << " of " << counts.intervals
              << " frames.\nWritten: error-against-time.csv, speedups.md, fronts.md, eyes.csv and "
                 "the plots in "
              << folder << std::endl;
    return 0;
}

} // namespace

int main(int count, char** words)
{
    return status_of("error_against_time", [&] {
        const options::options_description all = make_options();
        const options::variables_map arguments = parsed(count, words, all);
        if (!arguments.count("help"))
            return run(arguments);
        std::cout << "error_against_time [--quick | --samplers | --light-field] [--scene NAME] -o "
                     "FOLDER\n\n"
                  << all;
        return 0;
    });
}
