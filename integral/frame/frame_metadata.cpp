// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/frame_metadata.h"

#include "integral/frame/geometry_json.h"

#include <stdexcept>

namespace integral {
namespace {

constexpr int most_samples = 65536; // as the camera allows

Vec3 vec3_at(const JsonObject& object, const char* field)
{
    const auto v = numbers_at(object, field, 3, -largest_figure, largest_figure);
    return {v[0], v[1], v[2]};
}

/// A field that is true or false; false if it is absent.
bool flag_at(const JsonObject& object, const char* field)
{
    if (!object.has(field))
        return false;
    if (!object.at(field).is_boolean())
        throw_field_error(object.path_of(field), "must be true or false");
    return object.at(field).get<bool>();
}

Placement placement_from(const JsonObject& object)
{
    Placement placement;
    placement.origin = vec3_at(object, "origin");
    placement.x = vec3_at(object, "x");
    placement.y = vec3_at(object, "y");
    placement.z = vec3_at(object, "z");
    placement.units_per_mm = number_at(object, "units_per_mm", 1 / largest_figure, largest_figure);
    if (object.has("sheet_distance"))
        placement.sheet_distance = number_at(object, "sheet_distance", 0, largest_figure);
    placement.scale_is_given = flag_at(object, "units_per_mm_given");
    return placement;
}

ProjectionLens projection_from(const JsonObject& object)
{
    ProjectionLens lens;
    lens.focal_length = number_at(object, "focal_length_mm", 1e-2, 1e6);
    lens.distance = number_at(object, "distance_mm", 1e-2, 1e6);
    lens.viewer = number_at(object, "viewing_distance_mm", 1e-2, 1e9);
    if (!(lens.distance > lens.focal_length))
        throw_field_error(object.path_of("distance_mm"), "must be greater than the focal length");
    if (object.has("columns")) {
        constexpr int most = 1000;
        lens.columns = whole_at(object, "columns", 1, most);
        lens.rows = whole_at(object, "rows", 1, most);
        lens.extent = vec2_at(object, "extent_mm", 1e-9, 1e12);
    }
    return lens;
}

Parallax parallax_from(const JsonObject& object)
{
    return {number_at(object, "factor", 0, 100),
            number_at(object, "scene_distance_mm", 1e-2, 1e9)};
}

Encoding encoding_from(const JsonObject& object)
{
    Encoding encoding;
    encoding.kind = kind_at<Encoding::Kind>(object, "kind");
    if (encoding.kind == Encoding::Kind::power)
        encoding.gamma = number_at(object, "gamma", 0.01, 100);
    return encoding;
}

ErrorEstimate error_from(const JsonObject& object)
{
    constexpr long long most_pixels = 1LL * largest_side * largest_side;
    ErrorEstimate error;
    error.rms = number_at(object, "rms", 0, largest_figure);
    error.low = number_at(object, "low", 0, largest_figure);
    error.high = number_at(object, "high", 0, largest_figure);
    error.confidence = number_at(object, "confidence", 0, 1);
    error.method = kind_at<ErrorMethod>(object, "method");
    error.pixels = whole_at(object, "pixels", 0LL, most_pixels);
    error.lit_pixels = whole_at(object, "lit_pixels", 0LL, most_pixels);
    error.samples = whole_at(object, "samples", 0, std::numeric_limits<int>::max());
    if (object.has("seconds"))
        error.seconds = number_at(object, "seconds", 0, largest_figure);
    return error;
}

RenderRecord render_from(const JsonObject& object)
{
    RenderRecord render;
    if (object.has("program"))
        render.program = string_at(object, "program");
    if (object.has("scene"))
        render.scene = string_at(object, "scene");
    if (object.has("mapping"))
        render.mapping = kind_at<LensMapping>(object, "mapping");
    if (object.has("seconds"))
        render.seconds = number_at(object, "seconds", 0, largest_figure);
    if (object.has("model"))
        render.model = kind_at<LensModel>(object, "model");
    if (object.has("pixel_samples"))
        render.pixel_samples = whole_at(object, "pixel_samples", 1, most_samples);
    if (object.has("beam_samples"))
        render.beam_samples = whole_at(object, "beam_samples", 1, most_samples);
    if (object.has("fit"))
        render.fit = string_at(object, "fit");
    if (object.has("draft"))
        render.draft = whole_at(object, "draft", 1, largest_side);
    if (object.has("phase"))
        render.phase = vec2_at(object, "phase", 0, 1);
    render.pseudoscopic = flag_at(object, "pseudoscopic");
    render.display_prefilter = flag_at(object, "display_prefilter");
    if (object.has("error"))
        render.error = error_from(object_at(object, "error"));
    return render;
}

QuiltRecord quilt_from(const JsonObject& object)
{
    constexpr int most_a_side = 4096;
    QuiltRecord quilt;
    quilt.grid = {whole_at(object, "columns", 1, most_a_side),
                  whole_at(object, "rows", 1, most_a_side)};
    if (object.has("view"))
        quilt.view = whole_at(object, "view", 0, quilt.grid.count() - 1);
    if (object.has("eyes")) {
        const JsonObject eyes = object_at(object, "eyes");
        quilt.eyes = EyeGrid{{number_at(eyes, "width_mm", 0, largest_extent),
                              number_at(eyes, "height_mm", 0, largest_extent)},
                             number_at(eyes, "distance_mm", least_distance, largest_distance)};
    }
    return quilt;
}

/// The distance that viewing_distance_mm or the aperture states, if one of them does.
std::optional<double> viewing_distance_in(const JsonObject& document)
{
    if (document.has("aperture"))
        return number_at(object_at(document, "aperture"), "distance_mm", least_distance,
                         largest_distance);
    if (document.has("viewing_distance_mm"))
        return number_at(document, "viewing_distance_mm", least_distance, largest_distance);
    return std::nullopt;
}

/// Throws if the document is a display's calibration: no sheet is computed from it here.
void refuse_calibration(const JsonObject& document)
{
    if (document.has("sheet"))
        return;
    for (const char* const field : {"calibration", "DPI", "lineNumber"})
        if (document.has(field))
            throw std::invalid_argument(
                "it is a display's calibration; integral lcd --panel FILE --describe -o "
                "PANEL.json makes the description that is read here");
}

Json list(Vec3 v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const ProjectionLens& lens)
{
    Json json = {{"focal_length_mm", lens.focal_length},
                 {"distance_mm", lens.distance},
                 {"viewing_distance_mm", lens.viewer}};
    if (lens.columns * lens.rows > 1) {
        json["columns"] = lens.columns;
        json["rows"] = lens.rows;
        json["extent_mm"] = list(lens.extent);
    }
    return json;
}

Json json_of(const Placement& placement)
{
    Json json = {{"origin", list(placement.origin)},
                 {"x", list(placement.x)},
                 {"y", list(placement.y)},
                 {"z", list(placement.z)},
                 {"units_per_mm", placement.units_per_mm}};
    if (placement.sheet_distance > 0)
        json["sheet_distance"] = placement.sheet_distance;
    if (placement.scale_is_given)
        json["units_per_mm_given"] = true;
    return json;
}

Json json_of(const Encoding& encoding)
{
    Json json = {{"kind", name_of(encoding.kind)}};
    if (encoding.kind == Encoding::Kind::power)
        json["gamma"] = encoding.gamma;
    return json;
}

Json json_of(const ErrorEstimate& error)
{
    Json json = {{"rms", error.rms},
                 {"low", error.low},
                 {"high", error.high},
                 {"confidence", error.confidence},
                 {"method", name_of(error.method)},
                 {"pixels", error.pixels},
                 {"lit_pixels", error.lit_pixels},
                 {"samples", error.samples}};
    if (error.seconds > 0)
        json["seconds"] = error.seconds;
    return json;
}

Json json_of(const RenderRecord& render)
{
    Json json = {{"program", render.program},
                 {"scene", render.scene},
                 {"model", name_of(render.model)},
                 {"mapping", name_of(render.mapping)},
                 {"pixel_samples", render.pixel_samples},
                 {"beam_samples", render.beam_samples}};
    if (render.seconds > 0)
        json["seconds"] = render.seconds;
    if (!render.fit.empty())
        json["fit"] = render.fit;
    if (render.draft > 1)
        json["draft"] = render.draft;
    if (render.phase)
        json["phase"] = {render.phase->x, render.phase->y};
    if (render.pseudoscopic)
        json["pseudoscopic"] = true;
    if (render.display_prefilter)
        json["display_prefilter"] = true;
    if (render.error)
        json["error"] = json_of(*render.error);
    return json;
}

Json json_of(const QuiltRecord& quilt)
{
    Json json = {{"columns", quilt.grid.columns}, {"rows", quilt.grid.rows}};
    if (quilt.view)
        json["view"] = *quilt.view;
    if (quilt.eyes)
        json["eyes"] = {{"distance_mm", quilt.eyes->distance},
                        {"width_mm", quilt.eyes->zone.x},
                        {"height_mm", quilt.eyes->zone.y}};
    return json;
}

} // namespace

double viewer_distance(const FrameMetadata& m)
{
    return m.projection ? m.projection->viewer : m.aperture.distance;
}

double scene_distance(const FrameMetadata& m)
{
    return m.parallax ? m.parallax->scene_distance : viewer_distance(m);
}

Collineation relief_of(const FrameMetadata& m)
{
    return m.parallax ? relief_of(*m.parallax, viewer_distance(m)) : Collineation();
}

std::string to_json(const FrameMetadata& metadata)
{
    Json document = {{"sheet", json_of(metadata.sheet)},
                     {"film", json_of(metadata.film)},
                     {"aperture", json_of(metadata.aperture)}};
    if (metadata.placement)
        document["camera"] = json_of(*metadata.placement);
    if (metadata.projection)
        document["projection"] = json_of(*metadata.projection);
    if (metadata.parallax)
        document["parallax"] = {{"factor", metadata.parallax->factor},
                                {"scene_distance_mm", metadata.parallax->scene_distance}};
    document["encoding"] = json_of(metadata.encoding);
    if (metadata.render)
        document["render"] = json_of(*metadata.render);
    if (metadata.quilt)
        document["quilt"] = json_of(*metadata.quilt);
    return text_of(document);
}

FrameMetadata frame_metadata_from_json(const std::string& text)
{
    const Json json = parse_json(text);
    if (!json.is_object())
        throw std::invalid_argument("must be a JSON object with `sheet`, `film` and `aperture`");

    const JsonObject document{json, ""};
    FrameMetadata metadata;
    refuse_calibration(document);
    const JsonObject sheet = object_at(document, "sheet");
    const bool of_panel = document.has("panel") && !document.has("film");
    metadata.film = of_panel ? film_from(object_at(document, "panel"), PitchForm::number_or_pair)
                             : film_from(object_at(document, "film"));
    std::optional<double> distance = viewing_distance_in(document);
    if (of_panel && !distance)
        distance = nominal_viewing_distance(size_of(metadata.film));
    metadata.sheet = sheet_seen_from(sheet, distance);
    check_ranges(metadata.sheet, metadata.film);
    metadata.aperture = distance && !document.has("aperture")
                            ? default_aperture(metadata.sheet, *distance)
                            : aperture_from(object_at(document, "aperture"), metadata.sheet);
    if (document.has("camera"))
        metadata.placement = placement_from(object_at(document, "camera"));
    if (document.has("projection"))
        metadata.projection = projection_from(object_at(document, "projection"));
    if (document.has("parallax"))
        metadata.parallax = parallax_from(object_at(document, "parallax"));
    if (document.has("encoding"))
        metadata.encoding = encoding_from(object_at(document, "encoding"));
    if (document.has("render"))
        metadata.render = render_from(object_at(document, "render"));
    if (document.has("quilt"))
        metadata.quilt = quilt_from(object_at(document, "quilt"));
    return metadata;
}

} // namespace integral
