// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/layers.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/frame/names.h"
#include "integral/io/frame_rows.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"
#include "integral/sheet/depth_advice.h"
#include "integral/sheet/sheet_report.h"
#include "integral/views/made_frame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

std::string name_of(const PictureLayer& layer)
{
    if (!layer.name.empty())
        return layer.path + " " + layer.name;
    return layer.path + (layer.picture ? " " + std::to_string(*layer.picture + 1) : "");
}

void check_distance(const PictureLayer& layer, double viewing_distance)
{
    if (!(layer.distance > -viewing_distance))
        throw std::invalid_argument(
            name_of(layer) + ": a layer " + with_digits(-layer.distance, 6) +
            " mm in front of the sheet is not before the viewer, who is at " +
            with_digits(viewing_distance, 6) + " mm; give it a distance greater than -" +
            with_digits(viewing_distance, 6));
}

/// The rectangle of a picture of that shape on the sheet.
LayerWindow window_of(const PictureLayer& layer, double shape, const LayersRequest& request)
{
    if (layer.width || layer.height)
        return {layer.place,
                {layer.width ? *layer.width : shape * *layer.height,
                 layer.height ? *layer.height : *layer.width / shape}};
    const FittedPicture fit = fitted(shape, shape_of(request.geometry.film), request.fit);
    if (fit.differs())
        request.tell(name_of(layer) + ": " + fit_text(fit, "the film", "transparent bars"));
    const Vec2 film = size_of(request.geometry.film);
    return {layer.place, {fit.size.x * film.x, fit.size.y * film.y}};
}

LayerSharpness sharpness_at(double distance, std::optional<double> budget)
{
    if (!budget)
        return LayerSharpness::unknown;
    const double budgets = std::fabs(distance) / *budget;
    return budgets <= 1              ? LayerSharpness::sharp
           : budgets <= soft_budgets ? LayerSharpness::soft
                                     : LayerSharpness::beyond;
}

/// The BareEdge of the farthest layer, if it has one. `shape`: the picture's; `zone`: width and
/// height.
std::optional<BareEdge> bare_edge(const PictureLayer& layer, const LayerWindow& window,
                                  double shape, const FrameMetadata& geometry, Vec2 zone)
{
    constexpr double tolerance = 0.01; // of the film; fitted pictures may differ by that much
    const double parallax = layer_parallax(layer.distance, geometry.aperture.distance);
    const Vec2 film = size_of(geometry.film);
    BareEdge bare{name_of(layer)};
    bool fills = true;
    const auto filling = [&](double picture, double middle, double target, double extent) {
        const double beside = 0.5 * picture - std::fabs(middle) - 0.5 * target, // from the middle
            needed = 0.5 * std::fabs(parallax) * extent;
        bare.margin = std::max(bare.margin, needed - beside);
        fills = fills && beside >= -tolerance * target;
        return target + 2 * (needed + std::fabs(middle));
    };
    const Vec2 least{filling(window.size.x, window.middle.x, film.x, zone.x),
                     filling(window.size.y, window.middle.y, film.y, zone.y)};
    if (!fills || bare.margin <= tolerance * std::min(film.x, film.y))
        return std::nullopt;
    const double ratio = window.size.x / window.size.y / shape;
    bare.stretched = (layer.width && layer.height) || std::fabs(ratio - 1) > tolerance;
    const Vec2 unit = bare.stretched ? window.size : Vec2{shape, 1};
    const double scale = std::max(least.x / unit.x, least.y / unit.y);
    bare.width = scale * unit.x;
    bare.height = scale * unit.y;
    return bare;
}

/// Reads the pictures of layers. The layers of a file of several pictures must follow each other.
class LayerImages {
public:
    /// Throws std::invalid_argument if it is a frame, or the file has too few pictures.
    Image read(const PictureLayer& layer)
    {
        if (!layer.picture) {
            Frame frame = read_frame(layer.path);
            if (frame.metadata)
                throw std::invalid_argument(layer.path +
                                            ": it is a frame, which has its own depth; merge it "
                                            "with integral combine");
            return std::move(frame.image);
        }
        if (*layer.picture == 0)
            pictures_ = read_list_of_views(layer.path, std::size_t(layer.pictures));
        if (*layer.picture >= int(pictures_.size()))
            throw std::invalid_argument(layer.path + ": it holds " +
                                        std::to_string(pictures_.size()) +
                                        (pictures_.size() == 1 ? " picture" : " pictures") +
                                        "; give as many distances, or fewer");
        return std::move(pictures_[std::size_t(*layer.picture)]);
    }

private:
    std::vector<Image> pictures_;
};

/// Throws std::invalid_argument for a tilted layer that the viewer's distance cuts.
PicturePlane plane_of(const PictureLayer& layer, const LayerWindow& window, double viewing)
{
    const auto gradient = [](double degrees) { return std::tan(radians_per_degree * degrees); };
    const auto plane = picture_plane(layer.distance, {gradient(layer.turn), gradient(layer.tilt)},
                                     window.middle, viewing);
    if (!plane || !(parallax_range(*plane, window).greatest < 1))
        throw std::invalid_argument(name_of(layer) +
                                    ": turned and tilted so far, its plane goes on to infinity or "
                                    "behind the eye within the picture; give a smaller angle, size "
                                    "or offset");
    return *plane;
}

/// Adds the depths of a tilted layer to the figures of the last one.
void set_range(const PicturePlane& plane, const LayerWindow& window, double viewing,
               LayersView& view)
{
    const ParallaxRange range = parallax_range(plane, window);
    LayerFigures& figures = view.layers.back();
    figures.tilted = {layer_depth(range.least, viewing), layer_depth(range.greatest, viewing)};
    figures.sharpness = std::max(sharpness_at(figures.tilted->nearest, view.budget),
                                 sharpness_at(figures.tilted->farthest, view.budget));
}

struct Inputs {
    std::vector<DrawnLayer> layers;
    Image form; ///< of the frame
};

/// Reads the pictures and adds their figures to `view`.
Inputs read_layers(const LayersRequest& request, LayersView& view)
{
    const FrameMetadata& geometry = request.geometry;
    const double viewing = geometry.aperture.distance;
    const Vec2 zone = viewing_zone(geometry, viewing);
    const PictureLayer* farthest = nullptr;
    view.budget = seen_budget(geometry);
    Inputs all;
    LayerImages images;
    int bits = 8;
    for (const PictureLayer& layer : request.layers) {
        stop_if_interrupted();
        const Image image = images.read(layer);
        bits = std::max(bits, sample_bits(image));
        if (all.layers.empty())
            all.form = form_of(image);
        const double shape = double(image.width) / image.height;
        const LayerWindow window = window_of(layer, shape, request);
        const PicturePlane plane = plane_of(layer, window, viewing);
        const double there = (viewing + layer.distance) / viewing,
                     parallax = layer_parallax(layer.distance, viewing);
        view.layers.push_back({name_of(layer),
                               layer.distance,
                               there * window.size,
                               parallax * (lenses_lie_across(geometry.sheet) ? zone.y : zone.x),
                               sharpness_at(layer.distance, view.budget),
                               {}});
        if (plane.tilted())
            set_range(plane, window, viewing, view);
        if (!farthest || layer.distance > farthest->distance) {
            farthest = &layer;
            view.bare = plane.tilted() ? std::nullopt
                                       : bare_edge(layer, window, shape, geometry, zone);
        }
        all.layers.push_back(drawn_layer(image, plane, window, geometry, request.threads));
    }
    const bool exr = format_for(request.output) == ImageFormat::exr;
    bits = exr ? 32 : request.bits.value_or(bits);
    all.form = form_of(bits, geometry.film.width, geometry.film.height, request.transparent ? 4 : 3,
                       exr ? Encoding{Encoding::Kind::linear, 1}
                           : encoding_of_made(bits, all.form));
    return all;
}

/// Throws std::invalid_argument unless layers can be drawn for the lenses of a start geometry.
void check_rays(const FrameMetadata& geometry)
{
    const RenderRecord render = geometry.render.value_or(RenderRecord());
    if (render.model != LensModel::extended_pinhole)
        throw std::invalid_argument(std::string("the sheet's render.model is ") +
                                    name_of(render.model) +
                                    "; start from a frame of the model extended_pinhole");
    if (render.pseudoscopic)
        throw std::invalid_argument("the sheet is of a pseudoscopic frame; start from a frame "
                                    "that is not");
}

} // namespace

LayersView write_layers(const LayersRequest& request, const Progress& progress)
{
    check_rays(request.geometry);
    for (const PictureLayer& layer : request.layers)
        check_distance(layer, request.geometry.aperture.distance);
    LayersView view;
    Inputs inputs = read_layers(request, view);
    FrameMetadata geometry = request.geometry;
    geometry.placement.reset(); // the frame shows no rendered scene
    geometry.parallax.reset();
    geometry.render.reset();
    geometry.encoding = inputs.form.encoding;
    Frame form{inputs.form, std::nullopt};
    set_metadata(form, geometry);
    const FrameOfLayers drawing(std::move(inputs.layers), geometry, request.transparent);
    const bool has_depth = !request.depth_output.empty();
    const int steps = has_depth ? 2 : 1;
    write_drawn_rows(request.output, drawing, form, request.threads, piece_of(progress, 0, steps));
    if (has_depth)
        write_depths(request.depth_output,
                     drawing.depths(request.threads, piece_of(progress, 1, steps)));
    return view;
}

} // namespace integral
