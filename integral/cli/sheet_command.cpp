// SPDX-License-Identifier: AGPL-3.0-or-later
// integral sheet: what a sheet, a film and a viewer give, before anything is rendered.
#include "integral/batch/scene_depths.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/io/sheet_plots.h"
#include "integral/lightfield/scene_depth_report.h"
#include "integral/lightfield/sheet_report.h"

#include <nlohmann/json.hpp>

namespace integral {
namespace {

struct SheetCommandOptions : CommonOptions {
    SheetOptions sheet;
    FilmOptions film;
    ApertureOptions aperture;
    std::optional<std::string> pupil, detail;
    std::string depths = "10,20,50,100,200,300";
    std::optional<std::string> report, plot, start, output;
    bool json = false;
};

void declare(options::options_description& all, SheetCommandOptions& o)
{
    declare(all, o.sheet);
    declare(all, o.film);
    declare(all, o.aperture);
    all.add_options()("pupil", fills(o.pupil, "MM"), "diameter of the eye's pupil (default 5)")(
        "depths", fills(o.depths, "MM,..."), "depths to tabulate (default 10,20,50,100,200,300)")(
        "detail", fills(o.detail, "MM"),
        "distance between the edges that sampling errors are foretold for (default 5)")(
        "report", fills(o.report, "SCENE"),
        "add how deep a scene reaches against the depth budget: a .pov or .ini, which "
        "povray-integral looks through (what else is on "
        "the command line is for it, as +W900 +H600), or a depth frame (.exr); the geometry is the "
        "scene's")(
        "plot", fills(o.plot, "KIND"),
        "draw instead: spread, lens, sheets, resolution or film; needs -o FILE.svg or FILE.png")(
        "sheet", fills(o.start, "FILE.json"),
        "start from this geometry: a JSON document, or a frame")(
        "json", sets(o.json),
        "print the geometry and the figures as JSON, which --sheet of every command reads")(
        "output,o", fills(o.output, "FILE"),
        "print to FILE instead of standard output")("help", sets(o.help), "print this");
}

/// Reads a number that has to be greater than 0, if it was given.
void read_positive(const char* option, const std::optional<std::string>& text, double& value)
{
    read_number(option, text, value);
    if (!(value > 0))
        throw UsageError(std::string("--") + option + " " + text.value_or("") +
                         ": it must be greater than 0");
}

Viewer viewer_of(const SheetCommandOptions& o)
{
    Viewer viewer; // its pupil and its detail are 5 mm, as in the thesis's figure 4-8
    read_positive("pupil", o.pupil, viewer.pupil);
    read_positive("detail", o.detail, viewer.detail);
    viewer.depths = parse_numbers("depths", o.depths, "numbers separated by commas", 1, 1000);
    for (const double depth : viewer.depths)
        if (!(depth > 0))
            throw UsageError("--depths " + o.depths + ": they must be greater than 0");
    return viewer;
}

void draw(const SheetCommandOptions& o, const FrameMetadata& geometry, const Viewer& viewer)
{
    const std::string output = o.output.value_or("");
    if (o.json)
        throw UsageError("--plot and --json ask for different things; give one of them");
    if (output.empty())
        throw UsageError("--plot " + *o.plot + " needs -o FILE.svg or -o FILE.png");
    try {
        plot_format(output);
        write_plot(sheet_plot(*o.plot, geometry, viewer), output);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

/// Throws UsageError for options that say another geometry than the scene's.
void refuse_geometry(const SheetCommandOptions& o)
{
    const char* option = first_given({{"plot", o.plot}, {"sheet", o.start}});
    if (!option)
        option = first_given(o.sheet);
    if (!option)
        option = first_given({{"dpi", o.film.dpi},
                              {"pixel-pitch", o.film.pixel_pitch},
                              {"size", o.film.size},
                              {"distance", o.aperture.distance},
                              {"aperture", o.aperture.aperture}});
    if (option)
        throw UsageError(std::string("--report and --") + option +
                         " do not go together: the geometry is the scene's");
}

int report_scene(const SheetCommandOptions& o)
{
    refuse_geometry(o);
    const Viewer viewer = viewer_of(o);
    if (o.output) // before a long look through the scene, rather than after it
        check_writable(*o.output);
    const DepthFrame depths = depths_of_scene(*o.report, o.inputs);
    stop_if_interrupted();
    if (o.json) {
        nlohmann::ordered_json json = sheet_report_json(depths.metadata, viewer);
        json["scene_depths"] = scene_depth_json(*o.report, depths);
        print_result(o.output, json.dump(2) + "\n");
    } else {
        print_result(o.output, sheet_report_text(depths.metadata, viewer) +
                                   scene_depth_text(*o.report, depths));
    }
    return exit_done;
}

int run(const SheetCommandOptions& o)
{
    if (o.report)
        return report_scene(o);
    if (o.inputs.size() > 1)
        throw UsageError("one FRAME is expected");
    std::string start = o.start.value_or("");
    if (!o.inputs.empty() && !start.empty())
        throw UsageError("FRAME and --sheet both give the geometry; give one of them");
    if (!o.inputs.empty())
        start = o.inputs[0];

    FrameMetadata geometry = start.empty() ? default_geometry() : read_metadata(start);
    change_sheet(o.sheet, geometry.sheet);
    change_film(o.film, geometry.film);
    check_geometry(geometry);
    change_aperture(o.aperture, geometry, !start.empty() && !changes_lenses(o.sheet, o.aperture));

    const Viewer viewer = viewer_of(o);
    if (o.plot) {
        draw(o, geometry, viewer);
        return exit_done;
    }
    print_result(o.output, o.json ? sheet_report_json(geometry, viewer).dump(2) + "\n"
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
    described<SheetCommandOptions>,
    run_with<SheetCommandOptions, run>};

} // namespace integral
