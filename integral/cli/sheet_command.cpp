// SPDX-License-Identifier: AGPL-3.0-or-later
// integral sheet: what a sheet, a film and a viewer give, before anything is rendered.
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/scene_depth.h"
#include "integral/cli/sheet_plots.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/sheet_report.h"

#include <nlohmann/json.hpp>

namespace integral {
namespace {

constexpr double default_pupil = 5; // mm; the thesis's figure 4-8
constexpr double default_detail = 5;
constexpr char default_depths[] = "10,20,50,100,200,300";

options::options_description make_options()
{
    options::options_description all("Options");
    const auto value = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    add_sheet_options(all);
    add_film_options(all);
    add_aperture_options(all);
    all.add_options()("pupil", value("MM"), "diameter of the eye's pupil (default 5)")(
        "depths", value("MM,..."), "depths to tabulate (default 10,20,50,100,200,300)")(
        "detail", value("MM"),
        "distance between the edges that sampling errors are foretold for (default 5)")(
        "report", value("SCENE"),
        "add how deep a scene reaches against the depth budget: a .pov or .ini, which "
        "povray-integral looks through (what else is on "
        "the command line is for it, as +W900 +H600), or a depth frame (.exr); the geometry is the "
        "scene's")(
        "plot", value("KIND"),
        "draw instead: spread, lens, sheets, resolution or film; needs -o FILE.svg or FILE.png")(
        "sheet", value("FILE.json"), "start from this geometry: a JSON document, or a frame")(
        "json", "print the geometry and the figures as JSON, which --sheet of every command reads")(
        "output,o", value("FILE"), "print to FILE instead of standard output")("help",
                                                                               "print this");
    return all;
}

double positive(const options::variables_map& arguments, const char* option, double value)
{
    read_number(arguments, option, value);
    if (!(value > 0))
        throw UsageError(std::string("--") + option + " " + text_of(arguments, option) +
                         ": it must be greater than 0");
    return value;
}

Viewer read_viewer(const options::variables_map& arguments)
{
    Viewer viewer;
    viewer.pupil = positive(arguments, "pupil", default_pupil);
    viewer.detail = positive(arguments, "detail", default_detail);
    const std::string depths = given(arguments, "depths") ? text_of(arguments, "depths")
                                                          : default_depths;
    viewer.depths = parse_numbers("depths", depths, "numbers separated by commas", 1, 1000);
    for (const double depth : viewer.depths)
        if (!(depth > 0))
            throw UsageError("--depths " + depths + ": they must be greater than 0");
    return viewer;
}

void draw(const options::variables_map& arguments, const FrameMetadata& geometry,
          const Viewer& viewer)
{
    const std::string kind = text_of(arguments, "plot"), output = text_of(arguments, "output");
    if (given(arguments, "json"))
        throw UsageError("--plot and --json ask for different things; give one of them");
    if (output.empty())
        throw UsageError("--plot " + kind + " needs -o FILE.svg or -o FILE.png");
    try {
        plot_format(output);
        write_plot(sheet_plot(kind, geometry, viewer), output);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

int report_scene(const options::variables_map& arguments)
{
    const std::string scene = text_of(arguments, "report");
    for (const char* option : {"plot", "sheet", "arrangement", "pitch", "thickness", "ior", "slant",
                               "offset", "dpi", "pixel-pitch", "size", "distance", "aperture"})
        if (given(arguments, option))
            throw UsageError(std::string("--report and --") + option +
                             " do not go together: the geometry is the scene's");
    const Viewer viewer = read_viewer(arguments);
    if (given(arguments, "output"))
        check_writable(text_of(arguments, "output")); // rather than after a long look through the
                                                      // scene
    const DepthFrame depths = depths_of_scene(scene, inputs_of(arguments));
    stop_if_interrupted();
    if (given(arguments, "json")) {
        nlohmann::ordered_json json = sheet_report_json(depths.metadata, viewer);
        json["scene_depths"] = scene_depth_json(scene, depths);
        print_result(arguments, json.dump(2) + "\n");
    } else {
        print_result(arguments,
                     sheet_report_text(depths.metadata, viewer) + scene_depth_text(scene, depths));
    }
    return exit_done;
}

int run(const options::variables_map& arguments)
{
    if (given(arguments, "report"))
        return report_scene(arguments);
    const auto inputs = inputs_of(arguments);
    if (inputs.size() > 1)
        throw UsageError("one FRAME is expected");
    std::string start = text_of(arguments, "sheet");
    if (!inputs.empty() && !start.empty())
        throw UsageError("FRAME and --sheet both give the geometry; give one of them");
    if (!inputs.empty())
        start = inputs[0];

    FrameMetadata geometry = start.empty() ? default_geometry() : read_metadata(start);
    change_sheet(arguments, geometry.sheet);
    change_film(arguments, geometry.film);
    check_geometry(geometry);
    change_aperture(arguments, geometry, !start.empty() && !changes_lenses(arguments));

    const Viewer viewer = read_viewer(arguments);
    if (given(arguments, "plot")) {
        draw(arguments, geometry, viewer);
        return exit_done;
    }
    print_result(arguments, given(arguments, "json")
                                ? sheet_report_json(geometry, viewer).dump(2) + "\n"
                                : sheet_report_text(geometry, viewer));
    return exit_done;
}

} // namespace

const Command sheet_command = {
    "sheet",
    "what a sheet, a film and a viewer give, before anything is rendered",
    "[FRAME | --sheet FILE.json] [--pitch MM] [--dpi D] ... | --report SCENE [+W +H ...]",
    "Prints pixels per lens, fill, angles, depth budget, resolution against depth and moire\n"
    "pitch of a lens sheet over a film, each with the number of its equation in the thesis;\n"
    "then what error the camera's beam_samples and pixel_samples will leave, for how many rays.\n"
    "Starts from the thesis's sheet and printer, from a frame, or from a geometry document; the\n"
    "options change that.\n"
    "\n"
    "--report looks through a scene before it is rendered, and says how much of it lies within "
    "the\n"
    "depth budget.\n"
    "\n"
    "--plot draws instead: spread, the width of a micro-image against the distance, by the\n"
    "pinhole, the extended pinhole and a real lens (figure 3-26); lens, the real lens's beam\n"
    "against the extended pinhole's ray from axis to margin; sheets, the same for the thesis's\n"
    "sheets; resolution, against depth (figures 4-12 and 4-15); film, what of it a lens shows with "
    "the\n"
    "film at its focus, nearer and farther (figures 4-3 to 4-6).\n",
    0,
    1000,
    make_options,
    run_from_map<run>};

} // namespace integral
