// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/depth_pictures.h"

#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/depth/relief_views.h"
#include "integral/io/embedded_depth.h"
#include "integral/replay/arrange.h"
#include "integral/sheet/depth_advice.h"
#include "integral/sheet/panel_quilt.h"
#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cctype>

namespace integral {
namespace {

/// Makes the relief so large that its pictures fit the panel. Returns the rectangle that views
/// show, mm: the panel's or, within 1%, the pictures'. Tells the user of bars and cut sides.
Vec2 fit_on_panel(Relief& relief, const std::string& name, const DepthViewsRequest& request)
{
    const Vec2 panel = size_of(request.panel.film), size = relief.size();
    relief.scale_to(panel, request.fit);
    const FittedPicture picture = fitted(size.x / size.y, panel.x / panel.y, request.fit);
    if (!picture.differs())
        return relief.size();
    say(request.command, name + ": " + fit_text(picture, "the panel"));
    return panel;
}

/// Whether a file's name ends in rgbd, in any case, before its extension, as in photo_rgbd.png.
bool is_rgbd_name(const std::string& path)
{
    const std::string end = "rgbd";
    std::string name = path.substr(0, path.rfind('.'));
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char letter) { return char(std::tolower(letter)); });
    return name.size() >= end.size() &&
           name.compare(name.size() - end.size(), end.size(), end) == 0;
}

/// Where a picture has its own depth: "beside" it, by its name, or "inside" its file.
std::optional<std::string> own_place(const std::string& path)
{
    if (is_rgbd_name(path))
        return "beside";
    return embedded_depth(path) ? std::optional<std::string>("inside") : std::nullopt;
}

} // namespace

PixelSize size_of_view(const DepthViewsRequest& request)
{
    const PanelQuilt quilt = quilt_for(request.panel, request.grid);
    return request.size.value_or(
        PixelSize{quilt.width / quilt.tiles.columns, quilt.height / quilt.tiles.rows});
}

bool has_own_depth(const std::string& path, const DepthSource& source)
{
    return source.depth ? source.depth == "beside" || source.depth == "inside"
                        : own_place(path).has_value();
}

bool shows_by_depth(const std::vector<std::string>& inputs, const DepthSource& source)
{
    if (source.depth)
        return *source.depth != "none";
    return (inputs.size() == 1 && own_place(inputs[0])) || is_pair_of_files(inputs);
}

std::string depth_in_force(const std::vector<std::string>& inputs, const DepthSource& source)
{
    return source.depth.value_or(own_place(inputs[0]).value_or("measured"));
}

ReliefRequest relief_request(const char* command, const std::vector<std::string>& inputs,
                             const DepthSource& source, const GivenPictures& given,
                             const FrameMetadata& seen)
{
    constexpr double otherwise = 0.02; // of the distance, for sheets without a depth budget
    if (given.fit == Fit::stretch)
        throw UsageError("--fit stretch: a scene with depth cannot be stretched; contain or cover");
    ReliefRequest request;
    request.size = size_of(seen.film);
    request.distance = seen.aperture.distance;
    request.fit = given.fit;
    request.input.aspect = given.aspect;
    request.input.right_to_left = given.right_to_left;
    request.input.grid = given.grid;
    if (given.eyes)
        request.input.zone = GivenZone{
            {viewing_zone(seen, request.distance), request.distance}, request.size.x, seen.sheet};
    request.tell = [command](const std::string& what) { say(command, what); };
    const std::string depth = depth_in_force(inputs, source);
    request.own = depth == "beside"   ? OwnDepth::beside
                  : depth == "inside" ? OwnDepth::inside
                                      : OwnDepth::none;
    if (request.own != OwnDepth::none && inputs.size() > 1)
        throw UsageError("--depth " + depth + " is for one picture");
    if (request.own == OwnDepth::none && depth != "measured")
        request.depth_file = depth;
    if (source.range) {
        const auto mm = parse_numbers("depth-range", *source.range, "WHITE,BLACK", 2, 2);
        request.ends = DepthSpan{mm[0], mm[1]};
    }
    const auto budget = seen_budget(seen);
    request.limit = budget ? soft_budgets * *budget : otherwise * request.distance;
    return request;
}

ViewInput views_by_depth(const std::vector<std::string>& inputs, const DepthSource& source,
                         const DepthViewsRequest& request)
{
    const FrameMetadata geometry = frame_geometry(request.panel);
    const Progress bar = progress_bar(request.command);
    ViewInput made;
    usage_checked(inputs[0] + ": ", [&] {
        GivenPictures given;
        given.fit = request.fit;
        given.right_to_left = request.right_to_left;
        ReliefRequest relief = relief_request(request.command, inputs, source, given, geometry);
        relief.width = size_of_view(request).width;
        ReliefInput input = read_relief(inputs, relief, request.threads, piece_of(bar, 0, 2));
        const Vec2 shown = fit_on_panel(input.relief, inputs[0], request);
        const double distance = geometry.aperture.distance;
        made.grid = quilt_for(request.panel, request.grid).tiles;
        ReliefViews drawn = views_of_relief(
            std::move(input.relief), {viewing_zone(geometry, distance), distance},
            directions_of(made.grid, geometry.sheet), shown, size_of_view(request), input.form,
            request.threads, piece_of(bar, 1, 2));
        say(request.command, inputs[0] + ": " + holes_text(drawn.figures));
        made.views = std::move(drawn.views);
        made.shape = shape_of(request.panel.film);
    });
    return made;
}

} // namespace integral
