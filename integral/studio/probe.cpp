// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/probe.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/batch/renderer_options.h"
#include "integral/frame/geometry_json.h"
#include "integral/frame/quilt_name.h"
#include "integral/frame/view_eyes.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int fine_width = 640;     // of a view with side views beside it, pixels
constexpr double sheet_width = 100; // mm; any width serves, since the probe's sheet shows no lenses

std::string picture_path(const ProbeRequest& request, const ScratchFolder& scratch)
{
    return quilt_name(scratch.path("probe.png"), request.grid, request.aspect);
}

std::string depth_path(const ScratchFolder& scratch) { return scratch.path("probe.exr"); }

/// A camera with those views. Its lenses only have to let a wide aperture through.
std::string camera_of(const ProbeRequest& request)
{
    const auto number = [](double value) { return Json(value).dump(); };
    const double pixel = sheet_width / request.width;
    std::string words = "lens_sheet { square pitch 1 thickness 0.2 ior 1 } film { pixel_pitch <" +
                        number(pixel / request.grid.columns) + ", " +
                        number(pixel / request.grid.rows) + "> } parallax 1";
    if (request.grid.count() > 1) {
        const auto extent = [&](double part) { // greater than 0 even where the views do not differ
            return number(std::max(part, 1e-3) * sheet_width);
        };
        words += " capture_aperture <" + extent(request.zone.x) + ", " + extent(request.zone.y) +
                 ">";
    }
    return words;
}

} // namespace

int ProbeRequest::height() const { return std::max(1, int(std::lround(width / aspect))); }

ProbeRequest probe_for(const FrameMetadata& frame, double probe_distance)
{
    constexpr int views = 3;
    // The outer eyes of N are at (N - 1) / N of the zone's edges.
    constexpr double to_edges = double(views) / (views - 1);
    const Vec2 print = size_of(frame.film), zone = viewing_zone(frame.sheet, frame.aperture);
    const double scale = to_edges * frame.parallax->factor / print.x *
                         frame.placement->sheet_distance / probe_distance;
    ProbeRequest request;
    request.width = fine_width;
    request.aspect = print.x / print.y;
    request.zone = {scale * zone.x, scale * zone.y};
    request.grid = {request.zone.x > 0 ? views : 1, request.zone.y > 0 ? views : 1};
    return request;
}

bool serves(const ProbeRequest& present, const ProbeRequest& required)
{
    const auto is_near = [](double a, double b, double ratio) {
        return (a == 0) == (b == 0) && a <= ratio * b && b <= ratio * a;
    };
    return present.width == required.width && is_near(present.aspect, required.aspect, 1.01) &&
           present.grid.columns == required.grid.columns &&
           present.grid.rows == required.grid.rows &&
           is_near(present.zone.x, required.zone.x, 1.5) &&
           is_near(present.zone.y, required.zone.y, 1.5);
}

std::vector<std::string> probe_words(const std::string& scene,
                                     const std::vector<std::string>& options,
                                     const ProbeRequest& request, const ScratchFolder& scratch)
{
    std::vector<std::string> words = scene_words(scene, options);
    for (const char* word : {"-A", "-P", "+FN8", "Integral_Audit=off", "Integral_Draft=1",
                             "Integral_Fit=", "Integral_Error_Image="})
        words.push_back(word);
    words.push_back("+W" + std::to_string(request.width * request.grid.columns));
    words.push_back("+H" + std::to_string(request.height() * request.grid.rows));
    words.push_back("Integral_Camera=" + camera_of(request));
    words.push_back("Integral_Quilt=" + std::to_string(request.grid.columns) + "x" +
                    std::to_string(request.grid.rows));
    words.push_back("Integral_Depth_Image=" + quoted(depth_path(scratch)));
    words.push_back("+O" + quoted(picture_path(request, scratch)));
    return words;
}

ProbeView probe_view(const Image& picture, const DepthFrame& depths, int view)
{
    const FrameMetadata& frame = depths.metadata;
    const ViewGrid grid = frame.quilt->grid;
    const int width = picture.width / grid.columns, height = picture.height / grid.rows,
              left = view % grid.columns * width,
              top = picture.height - (view / grid.columns + 1) * height;
    const double unit = frame.placement->units_per_mm;
    const Collineation relief = relief_of(frame);
    ProbeView result;
    result.eye = unit * eye_of_view(*frame.quilt->eyes, directions_of(grid, frame.sheet), view);
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x) {
            const Colour colour = stored_pixel(picture, x, y);
            for (const float part : {colour.r, colour.g, colour.b})
                result.colours.push_back(std::uint8_t(std::lround(255 * part)));
            const auto at = std::size_t(y) * picture.width + x;
            const float depth = depths.depth[at];
            const auto z = depths.imaged[at] > 0 && std::isfinite(depth)
                               ? preimage_depth(relief, depth)
                               : std::nullopt;
            const double distance = z ? (scene_distance(frame) + *z) * unit : 0;
            result.nearness.push_back(distance > 0 ? float(1 / distance) : 0);
        }
    return result;
}

Probe read_probe(const ProbeRequest& request, const ScratchFolder& scratch)
{
    DepthFrame depths = read_depths(depth_path(scratch));
    const Image picture = converted(read_views(picture_path(request, scratch), true).image, 8,
                                    Encoding{}, false);
    Probe probe;
    probe.request = request;
    probe.width = request.width;
    probe.height = request.height();
    const int columns = request.grid.columns, rows = request.grid.rows;
    if (!depths.metadata.placement || !depths.metadata.quilt || !depths.metadata.quilt->eyes ||
        picture.width != probe.width * columns || picture.height != probe.height * rows ||
        depths.depth.size() != std::size_t(picture.width) * picture.height)
        throw InputError("the scene's camera gives no views for the studio");
    for (int view = 0; view < request.grid.count(); ++view)
        probe.views.push_back(probe_view(picture, depths, view));
    std::swap(probe.views.front(), probe.views[request.middle()]);
    probe.sheet_distance = depths.metadata.placement->sheet_distance;
    probe.depths.metadata = depths.metadata;
    probe.depths.metadata.quilt.reset();
    // The film of one view, for its shape and scale.
    Film& film = probe.depths.metadata.film;
    film.width = probe.width;
    film.height = probe.height;
    film.pixel_pitch = {film.pixel_pitch.x * columns, film.pixel_pitch.y * rows};
    probe.depths.eye_distances = std::move(depths.eye_distances);
    return probe;
}

std::string probe_bytes(const Probe& probe)
{
    Json head = {{"width", probe.width},
                 {"height", probe.height},
                 {"sheet_distance", probe.sheet_distance},
                 {"window", list(probe.window)},
                 {"eyes", Json::array()}};
    for (const ProbeView& view : probe.views)
        head["eyes"].push_back(list(view.eye));
    std::string bytes = padded_line(head.dump());
    for (const ProbeView& view : probe.views) {
        bytes.append(reinterpret_cast<const char*>(view.colours.data()), view.colours.size());
        bytes.append((4 - bytes.size() % 4) % 4, '\0');
        bytes.append(reinterpret_cast<const char*>(view.nearness.data()),
                     view.nearness.size() * sizeof(float));
    }
    return bytes;
}

std::string padded_line(std::string json)
{
    json.append(3 - json.size() % 4, ' ');
    return json + '\n';
}

} // namespace integral
