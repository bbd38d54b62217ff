// SPDX-License-Identifier: AGPL-3.0-or-later
// integral studio: a page on which a scene, or a picture with depth, is placed on a sheet.
#include "integral/batch/renderer_options.h"
#include "integral/cli/depth_pictures.h"
#include "integral/cli/fit_options.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/frame/quilt_name.h"
#include "integral/io/image_file.h"
#include "integral/studio/mesh_input.h"
#include "integral/studio/picture_input.h"
#include "integral/studio/scene_input.h"
#include "integral/studio/studio.h"
#include "integral/wireframe/mesh_file.h"

#include <cstdio>

namespace integral {
namespace {

struct StudioOptions : CommonOptions {
    SheetOptions sheet;
    std::optional<std::string> start, panel, dpi, print, distance, views, turn;
    DepthSource depth;
    ViewOrderOptions given_views;
    FitOptions fit;
    std::optional<int> port;
    bool no_browser = false;
};

void declare(options::options_description& all, StudioOptions& o)
{
    declare(all, o.sheet);
    declare_start_geometry(all, o.start);
    add(all, "panel", o.panel, "NAME|FILE.json",
        "a panel, as integral lcd has it, in place of a sheet and a printer");
    add(all, "dpi", o.dpi, "D", "of the printer (default 720)");
    add(all, "print", o.print, "WxH",
        "size of the picture in mm (default: 150 on the longer side, of the input's shape)");
    add(all, "distance", o.distance, "MM", "from the viewer to the sheet (default 400)");
    add(all, "depth", o.depth.depth, "HOW",
        "where the depth of a picture is, as in integral views: beside, inside, FILE or measured "
        "(default: by the picture)");
    add(all, "depth-range", o.depth.range, "WHITE,BLACK",
        "its depths to begin with, as in integral views");
    add(all, "views", o.views, "CxR", "views of a quilt whose name has no number, across and up");
    declare(all, o.given_views);
    declare(all, o.fit);
    add(all, "turn", o.turn, "X,Y,Z",
        "degrees by which a mesh is turned about x, then y, then z, as by POV-Ray's rotate (90,0,0 "
        "for files whose z is up)");
    add(all, "port", o.port, "PORT", "the port of the page (default: a free one)");
    add(all, "no-browser", o.no_browser, "print the page's address and do not open a browser");
}

/// The settings to begin with. Throws UsageError and InputError.
PlacementSettings settings_of(const StudioOptions& o)
{
    PlacementSettings settings = first_settings();
    if (o.panel) {
        const char* const reason = "does not work with --panel; leave it out";
        if (const char* const given = first_given(o.sheet))
            throw UsageError(std::string("--") + given + " " + reason);
        throw_if_given(
            {{"sheet", o.start}, {"dpi", o.dpi}, {"print", o.print}, {"distance", o.distance}},
            reason);
        settings.panel = usage_checked("--panel " + *o.panel + ": ",
                                       [&] { return find_panel(*o.panel); });
        settings.panel->name = *o.panel;
        return settings;
    }
    if (o.start) {
        const FrameMetadata start = read_metadata(*o.start);
        settings.sheet = start.sheet;
        settings.dpi = mm_per_inch / start.film.pixel_pitch.x;
        settings.viewing_distance = start.aperture.distance;
    } else if (first_given(o.sheet))
        settings.sheet = default_geometry().sheet;
    change_sheet(o.sheet, settings.sheet);
    read_positive("dpi", o.dpi, settings.dpi);
    read_positive("distance", o.distance, settings.viewing_distance);
    if (o.print)
        settings.print = parse_paper_size("print", *o.print);
    FrameMetadata frame;
    frame.sheet = settings.sheet;
    frame.film.pixel_pitch = {mm_per_inch / settings.dpi, mm_per_inch / settings.dpi};
    check_geometry(frame);
    return settings;
}

/// Width / height of the print or panel; empty: as the scene's picture.
std::optional<double> aspect_of(const PlacementSettings& settings)
{
    const Vec2 size = settings.panel ? size_of(settings.panel->film) : settings.print;
    return size.x > 0 ? std::optional(size.x / size.y) : std::nullopt;
}

/// The scene or mesh, and further words for povray-integral.
std::unique_ptr<StudioInput> scene_input(const StudioOptions& o)
{
    const std::string& scene = o.inputs[0];
    const bool is_mesh = names_mesh(scene);
    throw_if_given({{"depth", o.depth.depth},
                    {"depth-range", o.depth.range},
                    {"views", o.views},
                    {"aspect", o.given_views.given_aspect},
                    {"fit", o.fit.given},
                    {"right-to-left", o.given_views.right_to_left}},
                   "is for pictures, not for a scene or a mesh");
    const std::vector<std::string> options(o.inputs.begin() + 1, o.inputs.end());
    if (!is_mesh) {
        throw_if_given({{"turn", o.turn}}, "is for a mesh");
        return std::make_unique<SceneInput>(scene, options);
    }
    Vec3 turn;
    read_vector("turn", o.turn, turn);
    MeshReading reading;
    reading.plain = {0.7f, 0.7f, 0.7f, 1};
    reading.warn = [](const std::string& what) { say("studio", what); };
    auto input = usage_checked(
        scene + ": ", [&] { return std::make_unique<MeshInput>(scene, turn, reading, options); });
    say("studio", scene + ": the scene around it is " + scene_of_mesh(scene));
    return input;
}

/// Throws UsageError if the inputs are not pictures, or if --depth does not work with them.
void check_pictures(const StudioOptions& o, const std::string& depth)
{
    throw_if_given({{"turn", o.turn}}, "is for a mesh");
    for (const std::string& input : o.inputs)
        if (input[0] == '+')
            throw UsageError(input + ": it is a word for a scene; a picture takes none");
    if (depth == "none")
        throw UsageError("--depth none: the studio needs depth; leave it out");
    if (depth != "measured" && o.inputs.size() == 2)
        throw UsageError("--depth " + depth + ": the depth of a pair is measured; leave it out");
    if (depth == "measured" && o.inputs.size() == 1 && !o.views && is_plain_picture(o.inputs[0]))
        throw UsageError(o.inputs[0] +
                         ": it is a picture without depth; give --depth FILE, a grey picture or "
                         ".pfm, or a second picture, from another eye");
}

/// Pictures with depth, to begin with as integral views puts them on the first sheet.
std::unique_ptr<StudioInput> picture_input(const StudioOptions& o, PlacementSettings first)
{
    const std::string depth = depth_in_force(o.inputs, o.depth);
    check_pictures(o, depth);
    if (!(first.print.x > 0))
        first.print = print_of_aspect(1);
    const FrameMetadata geometry = frame_of_settings(first, nullptr);
    GivenPictures given{o.fit.value(),
                        o.given_views.aspect(),
                        o.given_views.right_to_left,
                        {},
                        o.views || o.inputs.size() > 2 || quilt_in_name(o.inputs[0])};
    std::vector<std::string> words = o.inputs;
    words.insert(words.end(), {"--depth", depth});
    if (o.views) {
        given.grid = parse_view_grid(*o.views);
        words.insert(words.end(), {"--views", *o.views});
    }
    if (o.given_views.given_aspect)
        words.insert(words.end(), {"--aspect", *o.given_views.given_aspect});
    if (given.right_to_left)
        words.push_back("--right-to-left");
    if (o.fit.given)
        words.insert(words.end(), {"--fit", *o.fit.given});
    if (given.eyes)
        words.push_back("--eyes");
    const ReliefRequest request = relief_request("studio", o.inputs, o.depth, given, geometry);
    return usage_checked(o.inputs[0] + ": ", [&] {
        return std::make_unique<PictureInput>(o.inputs, words, request, progress_bar("studio"));
    });
}

/// The settings to begin with for pictures: of a frame, unless options say otherwise, its own.
PlacementSettings settings_of_picture(StudioOptions o)
{
    const std::optional<FrameMetadata> own = FrameReader(o.inputs[0]).frame().metadata;
    if (!own || o.panel || o.start)
        return settings_of(o);
    o.start = o.inputs[0];
    PlacementSettings settings = settings_of(o);
    if (!o.print && !o.dpi)
        settings.print = size_of(own->film);
    return settings;
}

int run(const StudioOptions& o)
{
    const bool is_scene = names_scene(o.inputs[0]) || names_mesh(o.inputs[0]);
    const PlacementSettings first = is_scene ? settings_of(o) : settings_of_picture(o);
    const std::unique_ptr<StudioInput> input = is_scene ? scene_input(o) : picture_input(o, first);
    StudioRenders renders(*input, aspect_of(first));
    PanelWindow window;
    Studio studio(*input, first, renders, window);
    Server server(o.port ? in_range("port", *o.port, 1, 65535) : 0,
                  [&](const ServerRequest& request) { return studio.answer(request); });
    std::printf("the studio is at %s (Ctrl+C ends it)\n", server.address().c_str());
    std::fflush(stdout);
    if (!o.no_browser)
        open_in_browser(server.address());
    server.run([&] {
        renders.work();
        window.work();
        if (interrupted())
            renders.end();
        return false;
    });
    return exit_done;
}

} // namespace

const Command studio_command = {
    "studio",
    "a page on which a scene or a picture is placed on a sheet by dragging, live",
    "SCENE [+W +H ...] | MESH | PICTURE [--depth HOW] | LEFT RIGHT [--panel NAME | --lpi N ...] "
    "[--dpi D] "
    "[--print WxH] [--distance MM]",
    R"(Opens a page in a browser on this machine and prints its address. The page shows
the scene through a lens sheet: drag the sheet through the scene, change the parallax,
choose sheet, print size, printer and viewing distance, or a panel, move the eye, and
see what is sharp, soft and beyond the depth budget. While nothing moves, povray-integral
renders a draft of the print, and the page shows what an eye sees of it. Save writes a
settings file that povray-integral renders.

The same is done with a picture and its depth (a grey picture, .pfm, RGBD, a phone's), a
stereo pair, a quilt or a frame, whose depth is measured: integral views makes the print,
and Save writes the geometry for that.

Around a mesh (OBJ; STL, PLY, glTF and others where the program was built with Assimp) a
scene with camera, lights, floor and wall is written: MESH.obj gives MESH.pov, which may be
changed, and MESH-mesh.inc, which is written anew when the mesh changes.

The options describe the sheet, printer and print, or the panel, to begin with (without
them 60 lenses per inch); the page also lists the known sheets and panels. Words
after the scene are for povray-integral, as +W900 +H600, which set the picture's shape.
The page notices when the scene's files change. Only this machine can reach the page.
Ctrl+C ends the command.
)",
    1,
    1000,
    described<StudioOptions>,
    run_with<StudioOptions, run>};

} // namespace integral
