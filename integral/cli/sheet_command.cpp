// SPDX-License-Identifier: AGPL-3.0-or-later
// integral sheet: figures of a sheet, a film and a viewer, before anything is rendered.
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/batch/renderer_options.h"
#include "integral/batch/scene_depths.h"
#include "integral/batch/scene_look.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/depth/depth_page.h"
#include "integral/io/image_file.h"
#include "integral/sheet/camera_words.h"
#include "integral/sheet/scene_depth_report.h"
#include "integral/sheet/sheet_figures.h"
#include "integral/sheet/sheet_list.h"
#include "integral/sheet/sheet_plots.h"
#include "integral/sheet/sheet_report.h"
#include "integral/views/zone_view.h"

namespace integral {
namespace {

struct SheetCommandOptions : CommonOptions {
    SheetOptions sheet;
    FilmOptions film;
    ApertureOptions aperture;
    std::optional<std::string> pupil, detail, macro_lens;
    std::string depths = "10,20,50,100,200,300";
    std::optional<std::string> print, bleed, report, picture, plot, start, output;
    bool list = false, camera = false, json = false;
};

void declare(options::options_description& all, SheetCommandOptions& o)
{
    declare(all, o.sheet);
    declare(all, o.film);
    declare(all, o.aperture);
    add(all, "pupil", o.pupil, "MM", "diameter of the eye's pupil (default 5)");
    add(all, "depths", o.depths, "MM,...", "depths to tabulate (default 10,20,50,100,200,300)");
    add(all, "detail", o.detail, "MM",
        "distance between the edges that sampling errors are foretold for (default 5)");
    add(all, "macro-lens", o.macro_lens, "MM",
        "focal length, less than 300, of macro-lenses before two such sheets back to back (the "
        "thesis's two-tier screen): how deep the image is that they make of a scene");
    add(all, "print", o.print, "WxH", "size of the picture in mm, instead of --size");
    add(all, "bleed", o.bleed, "MM",
        "margin that is cut off all around after printing: --print plus this margin is the film");
    add(all, "list", o.list,
        "a table of known sheets, after the given one, if any: what each gives for that --print, "
        "--distance and --dpi");
    add(all, "camera", o.camera,
        "print the sheet and the film as the camera's words, for a scene or Integral_Camera; with "
        "viewing_distance for a frame or where --distance is given, and then fit 2");
    add(all, "report", o.report, "SCENE",
        "how much of a scene is within the depth budget, and what would help: a .pov or .ini, "
        "which povray-integral looks through (what else is on the command line is for it, as +W900 "
        "+H600), or a depth frame (.exr); the geometry is the scene's");
    add(all, "picture", o.picture, "FILE.png",
        "with --report: the scene tinted blue where it is sharp, yellow where soft, red beyond; -o "
        "FILE.html is a page with the report, this picture, and what an eye sees of a draft as it "
        "is and "
        "with Integral_Fit=2");
    add(all, "plot", o.plot, "KIND",
        "draw instead: spread, lens, sheets, resolution, pixels-seen, pixel-spread or film; needs "
        "-o FILE.svg or FILE.png");
    declare_start_geometry(all, o.start);
    add(all, "json", o.json,
        "print the geometry and the figures as JSON, which --sheet of every command reads");
    add(all, "output,o", o.output, "FILE", "print to FILE instead of standard output");
}

Viewer viewer_of(const SheetCommandOptions& o)
{
    Viewer viewer; // default pupil and detail: 5 mm, as in the thesis's figure 4-8
    read_positive("pupil", o.pupil, viewer.pupil);
    read_positive("detail", o.detail, viewer.detail);
    if (o.macro_lens) {
        read_positive("macro-lens", o.macro_lens, viewer.macro_lens.emplace());
        if (!(*viewer.macro_lens < nearest_in_two_tiers))
            throw UsageError("--macro-lens " + *o.macro_lens +
                             ": it must be less than 300, the nearest that the thesis's screen "
                             "shows");
    }
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
    plot_format(output);
    write_plot(sheet_plot(*o.plot, geometry, viewer), output);
}

/// Throws UsageError for options that would change the scene's geometry.
void refuse_geometry(const SheetCommandOptions& o)
{
    const char* option = first_given({{"plot", o.plot}, {"sheet", o.start}});
    if (!option)
        option = first_given(o.sheet);
    if (!option)
        option = first_given({{"dpi", o.film.dpi},
                              {"pixel-pitch", o.film.pixel_pitch},
                              {"size", o.film.size},
                              {"print", o.print},
                              {"bleed", o.bleed},
                              {"list", o.list},
                              {"camera", o.camera},
                              {"distance", o.aperture.distance},
                              {"aperture", o.aperture.aperture}});
    if (option)
        throw UsageError(std::string("--report and --") + option +
                         " do not go together: the geometry is the scene's");
}

/// Pictures of the scene as an eye will see it, for the page; empty for a depth frame.
std::optional<SceneLooks> looks_of(const SheetCommandOptions& o, const FrameMetadata& print)
{
    constexpr int longest = 480; // pixels
    const std::string fit = "2";
    if (!names_scene(*o.report))
        return std::nullopt;
    const auto look = [&](const std::string& value, const char* label) {
        return look_of_scene(*o.report, o.inputs, print, value, longest, progress_bar(label));
    };
    return SceneLooks{look("", "as it is"), look(fit, "fitted"), fit};
}

int report_scene(const SheetCommandOptions& o)
{
    refuse_geometry(o);
    Viewer viewer = viewer_of(o);
    check_outputs({o.output, o.picture});
    if (o.picture)
        format_for(*o.picture);
    const bool page = o.output && extension_of(*o.output) == "html";
    if (page && o.json)
        throw UsageError("-o FILE.html is a page; --json goes to another file");
    const SceneDepths scene = depths_of_scene(*o.report, o.inputs, o.picture || page,
                                              progress_bar("depths"));
    stop_if_interrupted();
    const DepthFrame& depths = scene.depths;
    viewer.ghost = ghost_in_zone(depths.metadata);
    std::optional<Image> picture;
    if (o.picture || page)
        picture = scene_picture(depths, scene.colours);
    if (o.picture)
        write_frame(*o.picture, {*picture, std::nullopt});
    if (o.json) {
        Json json = sheet_report_json(depths.metadata, viewer);
        json["scene_depths"] = scene_depth_json(*o.report, depths);
        print_result(o.output, json.dump(2) + "\n");
        return exit_done;
    }
    const std::string verdict = scene_verdict_text(*o.report, depths),
                      tables = scene_depth_text(depths) + "\n" +
                               sheet_report_text(depths.metadata, viewer);
    print_result(o.output, page ? depth_page(*o.report, verdict, *picture,
                                             looks_of(o, depths.metadata), tables)
                                : verdict + tables);
    return exit_done;
}

/// The geometry on the line.
FrameMetadata geometry_of(const SheetCommandOptions& o)
{
    if (o.inputs.size() > 1)
        throw UsageError("one FRAME is expected");
    const auto none_if_empty = [](const std::string& name) {
        return name.empty() ? std::nullopt : std::optional<std::string>(name);
    };
    std::optional<std::string> start = none_if_empty(o.start.value_or(""));
    if (!o.inputs.empty() && start)
        throw UsageError("FRAME and --sheet both give the geometry; give one of them");
    if (!o.inputs.empty())
        start = none_if_empty(o.inputs[0]);
    FrameMetadata geometry = given_geometry(start, o.sheet, o.film, o.print);
    if (o.bleed) {
        read_number("bleed", o.bleed, geometry.film.bleed);
        if (o.print)
            set_film_size("print", *o.print, geometry.film);
        check_geometry(geometry);
    }
    change_aperture(o.aperture, geometry, start && !changes_lenses(o.sheet, o.aperture));
    return geometry;
}

/// The camera's words for a scene; with viewing distance and print size only if these were given.
std::string words_for_scene(const SheetCommandOptions& o, const FrameMetadata& geometry)
{
    std::string words = geometry.render || o.aperture.distance
                            ? camera_words(geometry)
                            : sheet_words(geometry.sheet) + " " + film_words(geometry.film);
    if (o.aperture.distance && !geometry.render)
        words += " " + fit_words();
    if (o.print) {
        const Vec2 size = parse_paper_size("print", *o.print);
        words += " print_size <" + with_digits(size.x, 9) + ", " + with_digits(size.y, 9) + ">";
    }
    return words;
}

int run(const SheetCommandOptions& o)
{
    if (o.report)
        return report_scene(o);
    if (o.picture)
        throw UsageError("--picture is for --report");
    if (o.plot && (o.list || o.camera))
        throw UsageError("--plot, --list and --camera ask for different things; give one of them");
    if (o.camera && (o.list || o.json))
        throw UsageError("--camera prints words alone; give it without --list and --json");
    const FrameMetadata geometry = geometry_of(o);
    if (o.camera) {
        print_result(o.output, words_for_scene(o, geometry) + "\n");
        return exit_done;
    }
    if (o.list) {
        const bool own = first_given(o.sheet) || o.start || !o.inputs.empty();
        print_result(o.output, o.json ? sheet_list_json(geometry, own).dump(2) + "\n"
                                      : sheet_list_text(geometry, own));
        return exit_done;
    }
    Viewer viewer = viewer_of(o);
    viewer.ghost = ghost_in_zone(geometry);
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
    R"(Prints pixels per lens, fill, angles, depth budget, resolution against depth and moire
pitch of a lens sheet over a film, each with the number of its equation in the thesis;
then what error the camera's beam_samples and pixel_samples will leave, for how many rays.
Starts from the thesis's sheet and printer, from a frame, or from a geometry document; the
options change that.

--report looks through a scene before it is rendered, and says how much of it lies within the
depth budget.

--plot draws instead: spread, the width of a micro-image against the distance, by the
pinhole, the extended pinhole and a real lens (figure 3-26); lens, the real lens's beam
against the extended pinhole's ray from axis to margin; sheets, the same for the thesis's
sheets; resolution, against depth (figures 4-12 and 4-15); pixels-seen, how many of a lens an
eye sees at once, against its distance (figure 4-8); pixel-spread, what a pixel covers against
distance (figure 4-11); film, what of it a lens shows with the film at its focus, nearer and
farther (figures 4-3 to 4-6).
)",
    0,
    1000,
    described<SheetCommandOptions>,
    run_with<SheetCommandOptions, run>};

} // namespace integral
