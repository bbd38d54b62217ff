// SPDX-License-Identifier: AGPL-3.0-or-later
// integral views --to-frame: makes frames from views, or from pictures and their depth; and views
// of pictures with depth.
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/cli/views_options.h"
#include "integral/depth/relief_frame.h"
#include "integral/depth/relief_input.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"
#include "integral/sheet/panel_quilt.h"
#include "integral/views/frame_of_views.h"

#include <iostream>

namespace integral {
namespace {

/// Reads the views of --to-frame.
ViewInput given_views(const ViewsOptions& o)
{
    ViewsRequest request;
    if (o.views)
        request.grid = parse_view_grid(*o.views);
    request.needs_geometry = !o.sheet;
    request.of_eyes = o.eyes;
    request.aspect = o.given_views.aspect();
    if (o.at)
        request.video_time = parse_video_time(*o.at);
    return read_given_views(o.inputs, request);
}

/// Throws UsageError if the geometry of `file` has no frame size.
void check_film(const std::string& file, const Film& film)
{
    if (film.width < 1)
        throw UsageError(file + ": says no film.width and film.height, the frame's pixels");
}

} // namespace

int make_frame(const ViewsOptions& o, const std::string& output, int threads)
{
    const std::string& input = o.inputs[0];
    check_writable(output);
    const Fit fit = o.fit.value();
    ViewInput given = given_views(o);
    const std::string sheet = o.sheet.value_or("");
    if (sheet.empty() && !given.metadata)
        throw UsageError("--to-frame needs --sheet FILE.json here, the geometry of the frame "
                         "(integral sheet FRAME --json writes it): " +
                         input + " carries none");
    const FrameMetadata geometry = sheet.empty() ? *given.metadata : read_metadata(sheet);
    check_film(sheet, geometry.film);
    stop_if_interrupted();
    std::optional<EyeGrid> eyes;
    if (given.metadata)
        eyes = given.metadata->quilt->eyes;
    if (o.eyes && given.metadata && !eyes)
        throw UsageError(input + ": it says that it holds parallel views, not those of --eyes");
    const double distance = geometry.aperture.distance;
    if (o.eyes && !eyes)
        eyes = EyeGrid{viewing_zone(geometry, distance), distance};
    if (o.given_views.right_to_left)
        turn_right_to_left(given.views, directions_of(given.grid, geometry.sheet));
    const FittedPicture picture = fitted(given.shape, shape_of(geometry.film), fit);
    if (eyes && picture.differs())
        say("views", input + ": " + fit_text(given, picture, "the film"));
    usage_checked(input + ": ", [&] {
        write_frame_of_views(output, given, geometry, eyes, picture, threads,
                             progress_bar("views"));
    });
    return exit_done;
}

namespace {

/// The new frame's geometry: from --sheet, else from the views' own frame.
FrameMetadata geometry_of(const ViewsOptions& o)
{
    FrameMetadata geometry;
    try {
        geometry = read_metadata(o.sheet ? *o.sheet : o.inputs[0]);
    } catch (const InputError& error) {
        if (o.sheet)
            throw;
        throw UsageError(o.inputs[0] + ": --sheet FILE.json is missing, the geometry of the frame "
                                       "to make (integral sheet --json writes it)");
    }
    check_film(o.sheet.value_or(""), geometry.film);
    return geometry;
}

} // namespace

int make_frame_with_depth(const ViewsOptions& o, const std::string& output, int threads)
{
    check_writable(output);
    const FrameMetadata geometry = geometry_of(o);
    if (o.depth.depth == "none")
        throw UsageError("--depth none: leave --depth out");
    const ReliefRequest request = relief_request(
        "views", o.inputs, o.depth,
        {o.fit.value(), o.given_views.aspect(), o.given_views.right_to_left,
         o.views ? std::optional(parse_view_grid(*o.views)) : std::nullopt, o.eyes},
        geometry);
    const Progress bar = progress_bar("views");
    usage_checked(o.inputs[0] + ": ", [&] {
        ReliefInput input = read_relief(o.inputs, request, threads, piece_of(bar, 0, 2));
        const Vec2 size = input.relief.size();
        const FittedPicture picture = fitted(size.x / size.y, shape_of(geometry.film), request.fit);
        if (picture.differs())
            say("views", o.inputs[0] + ": " + fit_text(picture, "the film"));
        const ReliefFigures figures = write_relief_frame(output, std::move(input.relief), geometry,
                                                         input.form, request.fit, threads,
                                                         piece_of(bar, 1, 2));
        say("views", holes_text(figures));
    });
    return exit_done;
}

namespace {

/// The panel of --panel, or one of the lenses and pixels of --sheet.
Panel panel_of(const ViewsOptions& o)
{
    if (o.panel)
        return usage_checked("--panel " + *o.panel + ": ", [&] { return find_panel(*o.panel); });
    if (!o.sheet)
        throw UsageError(
            o.inputs[0] +
            ": it is a picture with depth; give --panel NAME (integral lcd --list), or "
            "--sheet FILE.json, for whose eyes the views are");
    const FrameMetadata geometry = read_metadata(*o.sheet);
    check_film(*o.sheet, geometry.film);
    Panel panel;
    panel.film = geometry.film;
    panel.sheet = geometry.sheet;
    panel.aperture = geometry.aperture;
    return panel;
}

EyeViews form_of_views(const DepthViewsRequest& request)
{
    FrameMetadata geometry = frame_geometry(request.panel);
    const double distance = geometry.aperture.distance;
    EyeViews form;
    form.grid = quilt_for(request.panel, request.grid).tiles;
    form.directions = directions_of(form.grid, geometry.sheet);
    form.size = size_of_view(request);
    form.shape = shape_of(geometry.film);
    geometry.quilt = QuiltRecord{form.grid, std::nullopt,
                                 EyeGrid{viewing_zone(geometry, distance), distance}};
    form.metadata = geometry;
    return form;
}

} // namespace

int make_views_by_depth(const ViewsOptions& o, const ViewExport& requested)
{
    DepthViewsRequest request;
    request.panel = panel_of(o);
    request.grid = requested.grid;
    request.size = requested.size;
    request.fit = requested.fit;
    request.right_to_left = o.given_views.right_to_left;
    request.command = "views";
    request.threads = requested.threads;
    check_writable(requested.output);
    EyeViews form = form_of_views(request);
    check_views_of_eyes(form, requested);
    ViewInput made = views_by_depth(o.inputs, o.depth, request);
    form.metadata->encoding = made.views[0].encoding;
    const std::string path = write_views_of_eyes(std::move(made.views), form, requested);
    if (path != requested.output)
        std::cout << path << '\n';
    return exit_done;
}

} // namespace integral
