// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/picture_input.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/depth/relief_pictures.h"
#include "integral/depth/relief_views.h"
#include "integral/frame/view_eyes.h"
#include "integral/io/markup.h"
#include "integral/optics/film.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace integral {
namespace {

/// The distance from the scene's eye of a surface of parallax p. `eye`: from the eye to the window.
double distance_of(double p, double eye) { return p < 1 ? eye / (1 - p) : HUGE_VAL; }

/// The view from an eye. `window`, mm: what `size` pixels show. `distance`: of the scene's eye from
/// the window.
ProbeView view_of_relief(const Relief& relief, Vec2 eye, Vec2 window, PixelSize size,
                         double distance)
{
    const ReliefEyeView seen(relief, eye, 1, window, size);
    Image picture = make_image<std::uint8_t>(size.width, size.height, 3, Encoding{});
    ReliefFigures figures;
    ProbeView view;
    view.eye = eye;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            store_linear(picture, x, y, seen.pixel(x, y, figures, false));
            view.nearness.push_back(float(1 / distance_of(seen.parallax(x, y), distance)));
        }
    for (int y = 0; y < size.height; ++y)
        view.colours.insert(view.colours.end(), row_bytes(picture, y),
                            row_bytes(picture, y) + 3 * size.width);
    return view;
}

/// The scene's geometry for figures: a window on a film of that raster, seen from that distance.
FrameMetadata scene_of(const Film& raster, double distance)
{
    FrameMetadata scene;
    scene.film = raster;
    scene.aperture.distance = distance;
    scene.parallax = Parallax{1, distance};
    Placement placement;
    placement.x = {1, 0, 0};
    placement.y = {0, 1, 0};
    placement.z = {0, 0, 1};
    placement.sheet_distance = distance;
    scene.placement = placement;
    return scene;
}

/// The frame without its place in the scene: a frame of pictures is in the viewer's space.
FrameMetadata print_geometry(const FrameMetadata& frame)
{
    FrameMetadata geometry = frame;
    geometry.placement.reset();
    geometry.parallax.reset();
    return geometry;
}

} // namespace

PictureInput::PictureInput(const std::vector<std::string>& inputs,
                           const std::vector<std::string>& words, const ReliefRequest& request,
                           const Progress& progress)
    : inputs_(inputs), words_(words), request_(request)
{
    request_.tell = ReliefRequest().tell;
    const ReliefInput input = placed(request, progress);
    if (input.unit == DepthUnit::ends)
        throw std::invalid_argument("views with grey depths have no place for another sheet; give "
                                    "a .pfm file, or --depth measured");
    aspect_ = input.relief.size().x / input.relief.size().y;
    has_eyes_ = input.unit == DepthUnit::pair ||
                (input.unit == DepthUnit::mm && request.depth_file.empty());
}

std::string PictureInput::name() const { return std::filesystem::path(inputs_[0]).stem().string(); }

std::vector<std::string> PictureInput::files() const
{
    std::vector<std::string> files = inputs_;
    if (!request_.depth_file.empty())
        files.push_back(request_.depth_file);
    return files;
}

void PictureInput::forget() { relief_.reset(); }

/// The inputs' relief, placed as requested. Reads the inputs, unless they have been read. A file of
/// depths in mm is read anew for another distance, as it gives another parallax.
ReliefInput PictureInput::placed(const ReliefRequest& request, const Progress& progress)
{
    const bool is_in_mm = relief_ && relief_->unit == DepthUnit::mm && !request.depth_file.empty();
    if (!relief_ || (is_in_mm && read_distance_ != request.distance)) {
        relief_.reset();
        relief_ = read_unplaced_relief(inputs_, request, 0, progress);
        read_distance_ = request.distance;
        if (request.distance == request_.distance)
            set_ends();
    }
    ReliefInput input = *relief_;
    ReliefRequest quiet = request; // the page says where depths are put
    quiet.tell = request_.tell;
    place(input, inputs_[0], quiet);
    return input;
}

void PictureInput::set_ends()
{
    const bool are_given = relief_->unit != DepthUnit::mm || request_.ends;
    const std::lock_guard lock(mutex_);
    ends_ = are_given ? requested_span(inputs_[0], request_, request_.distance)
                      : relief_->relief.span();
}

Making PictureInput::probe(const ProbeRequest& request, const ScratchFolder&)
{
    return {
        {}, [this, request](const Progress& progress) {
            ReliefInput input = placed(request_, piece_of(progress, 0, 2));
            Relief& relief = input.relief;
            Probe probe;
            probe.request = request;
            probe.width = request.width;
            probe.height = request.height();
            const Vec2 window{request_.size.x, request_.size.x / request.aspect};
            relief.scale_to(window, request_.fit);
            probe.window = {std::min(1.0, relief.size().x / window.x),
                            std::min(1.0, relief.size().y / window.y)};
            relief.thin(spacing_of_lines(relief, window, {probe.width, probe.height}));
            const Film raster{
                probe.width, probe.height, {window.x / probe.width, window.y / probe.height}};
            const double distance = request_.distance;
            probe.sheet_distance = distance;
            probe.views.resize(std::size_t(request.grid.count()));
            const EyeGrid eyes{{request.zone.x * window.x, request.zone.y * window.x}, distance};
            const auto draw = [&](int view) {
                probe.views[std::size_t(view)] = view_of_relief(
                    relief, eye_of_view(eyes, request.grid, view), window,
                    {probe.width, probe.height}, distance);
            };
            if (!for_each_row(request.grid.count(), 0, draw, piece_of(progress, 1, 2)))
                throw Interrupted();
            std::swap(probe.views.front(), probe.views[request.middle()]);
            probe.depths.metadata = scene_of(raster, distance);
            for (const float nearness : probe.views.front().nearness)
                probe.depths.eye_distances.push_back(1 / nearness);
            probe_ = std::move(probe);
        }};
}

Probe PictureInput::made_probe(const ProbeRequest&, const ScratchFolder&)
{
    return std::move(probe_);
}

/// The range of depths, mm behind the sheet, for a frame's placement. Rounded to 0.1 micrometres.
DepthSpan PictureInput::depth_range(const FrameMetadata& frame) const
{
    ParallaxSpan ends;
    {
        const std::lock_guard lock(mutex_);
        ends = ends_;
    }
    const auto seen = [&](double p) {
        // Nearness is linear in parallax, and so is a relief's parallax in nearness (optics.md 8).
        const double parallax = frame.parallax->factor *
                                (1 - frame.placement->sheet_distance * (1 - p) / request_.distance);
        if (parallax > 1 + 1e-6)
            throw std::invalid_argument("a depth would be seen beyond infinity; choose a smaller "
                                        "parallax");
        const double depth = frame.aperture.distance * parallax / std::max(1e-6, 1 - parallax);
        return std::round(1e4 * depth) / 1e4 + 0.0; // no -0
    };
    const DepthSpan range{seen(ends.near), seen(ends.far)};
    if (has_eyes_ && !(range.near < range.far))
        throw std::invalid_argument("so small a parallax leaves no depth to pictures from several "
                                    "eyes; choose a larger one");
    return range;
}

Making PictureInput::print(const PlacementSettings&, const FrameMetadata& frame,
                           std::optional<int> draft, const std::string& file)
{
    ReliefRequest request = request_;
    request.ends = depth_range(frame);
    request.size = size_of(frame.film);
    request.distance = frame.aperture.distance;
    FrameMetadata geometry = print_geometry(frame);
    if (draft.value_or(1) > 1) {
        geometry.film = draft_of(frame.film, *draft);
        geometry.render.emplace();
        geometry.render->draft = *draft;
    }
    return {{}, [this, request, geometry, file](const Progress& progress) {
                ReliefInput input = placed(request, piece_of(progress, 0, 2));
                write_relief_frame(file, std::move(input.relief), geometry, input.form, request.fit,
                                   0, piece_of(progress, 1, 2));
            }};
}

/// The command that makes the print `file`. `sheet`: the file with its geometry.
std::string PictureInput::command(const FrameMetadata& frame, const std::string& sheet,
                                  const std::string& file) const
{
    if (!frame.placement)
        return "integral views --to-frame";
    const DepthSpan range = depth_range(frame);
    std::string line = "integral views --to-frame";
    for (const std::string& word : words_)
        line += " " + for_shell(word);
    return line + " --depth-range=" + with_digits(range.near, 10) + "," +
           with_digits(range.far, 10) + " --sheet " + for_shell(sheet) + " -o " + for_shell(file);
}

std::string PictureInput::words(const PlacementSettings& settings, const FrameMetadata& frame) const
{
    const std::string file = name() + (settings.panel ? "-on-panel" : "-on-sheet");
    try {
        return command(frame, file + ".json", file + ".png");
    } catch (const std::invalid_argument& error) {
        return std::string("integral views: ") + error.what(); // the page's other figures stay
    }
}

SavedPlacement PictureInput::save(const PlacementSettings& settings, const FrameMetadata& frame,
                                  const std::string& picture) const
{
    const std::string file = std::filesystem::path(picture).replace_extension(".json").string();
    std::string line = command(frame, file, picture);
    if (settings.panel)
        line += " && integral lcd " + for_shell(picture) + " --panel " +
                for_shell(settings.panel->name) + " --show auto";
    write_file(file, to_json(print_geometry(frame)));
    return {file, line};
}

} // namespace integral
