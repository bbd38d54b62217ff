// SPDX-License-Identifier: AGPL-3.0-or-later
// integral studio: a page on which a scene is placed on a sheet.
#include "integral/batch/renderer_options.h"
#include "integral/cli/geometry_options.h"
#include "integral/io/image_file.h"
#include "integral/studio/scene_input.h"
#include "integral/studio/studio.h"

#include <cstdio>

namespace integral {
namespace {

struct StudioOptions : CommonOptions {
    SheetOptions sheet;
    std::optional<std::string> start, panel, dpi, print, distance;
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
        "size of the picture in mm (default: 150 on the longer side, of the scene's shape)");
    add(all, "distance", o.distance, "MM", "from the viewer to the sheet (default 400)");
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

int run(const StudioOptions& o)
{
    const std::string& scene = o.inputs.front();
    if (!names_scene(scene))
        throw UsageError(scene + ": not a scene; give a .pov or .ini file");
    const std::vector<std::string> words(o.inputs.begin() + 1, o.inputs.end());
    const PlacementSettings first = settings_of(o);
    SceneInput input(scene, words);
    StudioRenders renders(input, aspect_of(first));
    PanelWindow window;
    Studio studio(input, first, renders, window);
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
    "a page on which a scene is placed on a sheet by dragging, live",
    "SCENE [+W +H ...] [--panel NAME | --lpi N ...] [--dpi D] [--print WxH] [--distance MM]",
    R"(Opens a page in a browser on this machine and prints its address. The page shows
the scene through a lens sheet: drag the sheet through the scene, change the parallax,
choose sheet, print size, printer and viewing distance, or a panel, move the eye, and
see what is sharp, soft and beyond the depth budget. While nothing moves, povray-integral
renders a draft of the print, and the page shows what an eye sees of it. Save writes a
settings file that povray-integral renders.

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
