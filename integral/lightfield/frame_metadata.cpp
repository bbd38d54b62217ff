// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/frame_metadata.h"

#include "integral/lightfield/names.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <sstream>
#include <stdexcept>

namespace integral {
namespace {

using Json = nlohmann::ordered_json;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr int largest_side = 1000000; // pixels
constexpr int most_samples = 65536;    // as the camera allows
constexpr double least_distance = 1e-2, largest_distance = 1e9; // mm, as make_camera allows
constexpr double largest_extent = 1e30;                         // mm; an aperture's
constexpr double largest_figure = 1e100; // of what is only handed on; no few of them overflow

[[noreturn]] void refuse(const std::string& field, const std::string& what)
{
    throw std::invalid_argument(field + " " + what);
}

std::string text_of(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

/// An object of the document, with the path by which messages name it.
struct Object {
    const Json& json;
    std::string path;

    std::string path_of(const char* field) const
    {
        return path.empty() ? field : path + "." + field;
    }
    bool has(const char* field) const { return json.contains(field); }
    const Json& at(const char* field) const
    {
        if (!has(field))
            refuse(path_of(field), "is missing");
        return json.at(field);
    }
};

Object object_at(const Object& parent, const char* field)
{
    const Json& json = parent.at(field);
    if (!json.is_object())
        refuse(parent.path_of(field), "must be an object");
    return {json, parent.path_of(field)};
}

/// A number in [least, greatest].
double number_in(const Json& json, const std::string& path, double least, double greatest)
{
    if (!json.is_number())
        refuse(path, "must be a number");
    const double value = json.get<double>();
    if (!(value >= least && value <= greatest))
        refuse(path, "is " + text_of(value) + ", and must be within " + text_of(least) + " and " +
                         text_of(greatest));
    return value;
}

double number_at(const Object& object, const char* field, double least, double greatest)
{
    return number_in(object.at(field), object.path_of(field), least, greatest);
}

/// A list of `count` numbers in [least, greatest].
std::vector<double> numbers_in(const Json& json, const std::string& path, std::size_t count, double least, double greatest)
{
    if (!json.is_array() || json.size() != count)
        refuse(path, "must be a list of " + std::to_string(count) + " numbers");
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(
            number_in(json[i], path + "[" + std::to_string(i) + "]", least, greatest));
    return values;
}

std::vector<double> numbers_at(const Object& object, const char* field, std::size_t count,
                               double least, double greatest)
{
    return numbers_in(object.at(field), object.path_of(field), count, least, greatest);
}

Vec2 vec2_at(const Object& object, const char* field, double least, double greatest)
{
    const auto v = numbers_at(object, field, 2, least, greatest);
    return {v[0], v[1]};
}

Vec3 vec3_at(const Object& object, const char* field)
{
    const auto v = numbers_at(object, field, 3, -largest_figure, largest_figure);
    return {v[0], v[1], v[2]};
}

std::string string_at(const Object& object, const char* field)
{
    if (!object.at(field).is_string())
        refuse(object.path_of(field), "must be a string");
    return object.at(field).get<std::string>();
}

template <class Kind> Kind kind_at(const Object& object, const char* field)
{
    const auto kind = kind_named<Kind>(string_at(object, field));
    if (!kind)
        refuse(object.path_of(field), "must be " + legal_names<Kind>());
    return *kind;
}

/// A whole number in [least, greatest].
template <class Whole> Whole whole_at(const Object& object, const char* field, Whole least, Whole greatest)
{
    if (!object.at(field).is_number_integer())
        refuse(object.path_of(field), "must be a whole number");
    return static_cast<Whole>(number_at(object, field, double(least), double(greatest)));
}

int side_at(const Object& object, const char* field) { return whole_at(object, field, 1, largest_side); }

/// The ranges of sheet and film are the scene language's: one list of them, in find_value_errors.
void check_ranges(const LensSheet& sheet, const Film& film)
{
    CameraParameters parameters;
    parameters.sheet = sheet;
    parameters.film.pixel_pitch = film.pixel_pitch;
    const auto errors = find_value_errors(parameters);
    if (!errors.empty())
        throw std::invalid_argument(errors.front());
}

LensSheet sheet_from(const Object& object)
{
    LensSheet sheet;
    sheet.arrangement = kind_at<Arrangement>(object, "arrangement");
    sheet.pitch = number_at(object, "pitch_mm", 0, largest_figure);
    sheet.thickness = number_at(object, "thickness_mm", 0, largest_figure);
    sheet.ior = number_at(object, "ior", 0, largest_figure);
    if (object.has("slant_degrees"))
        sheet.slant = number_at(object, "slant_degrees", -90, 90);
    if (object.has("offset_mm"))
        sheet.offset = vec2_at(object, "offset_mm", -largest_figure, largest_figure);
    return sheet;
}

/// A list of red's, green's and blue's places in a pixel.
PixelCell cell_from(const Json& json, const std::string& path)
{
    if (!json.is_array() || json.size() != 3)
        refuse(path, "must be a list of three places: red's, green's and blue's");
    PixelCell cell;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto place = numbers_in(json[channel], path + "[" + std::to_string(channel) + "]", 2, -1, 1);
        cell[channel] = {place[0], place[1]};
    }
    return cell;
}

/// A word for stripes, or an object of cells.
Subpixels subpixels_from(const Object& film)
{
    if (!film.at("subpixels").is_object()) {
        const auto order = kind_at<Subpixels::Order>(film, "subpixels");
        if (order == Subpixels::cells)
            refuse(film.path_of("subpixels"), "must be an object of pattern and cells, where it is no stripes");
        return order;
    }
    const Object object = object_at(film, "subpixels");
    Subpixels subpixels;
    subpixels.order = Subpixels::cells;
    subpixels.pattern = kind_at<CellPattern>(object, "pattern");
    const Json& cells = object.at("cells");
    if (!cells.is_array() || cells.empty() || cells.size() > Subpixels::most_cells)
        refuse(object.path_of("cells"), "must be a list of 1 to " + std::to_string(Subpixels::most_cells) + " cells");
    for (const Json& cell : cells) {
        subpixels.cell[subpixels.number] = cell_from(cell, object.path_of("cells") + "[" + std::to_string(subpixels.number) + "]");
        ++subpixels.number;
    }
    return subpixels;
}

Film film_from(const Object& object)
{
    Film film;
    if (object.has("width") || object.has("height")) {
        film.width = side_at(object, "width");
        film.height = side_at(object, "height");
    }
    film.pixel_pitch = vec2_at(object, "pixel_pitch_mm", 0, largest_figure);
    if (object.has("subpixels"))
        film.subpixels = subpixels_from(object);
    return film;
}

double extent_at(const Object& object, const char* field)
{
    if (object.at(field).is_null())
        return infinity;
    return number_at(object, field, 0, largest_extent);
}

/// Extents that are absent are those that fill the lens on the axis, or none where nothing does.
Aperture aperture_from(const Object& object, const LensSheet& sheet)
{
    Aperture aperture;
    aperture.distance = number_at(object, "distance_mm", least_distance, largest_distance);
    const auto filling = filling_aperture(sheet, aperture.distance);
    aperture.width = filling ? filling->width : infinity;
    aperture.height = filling ? filling->height : infinity;
    if (object.has("width_mm"))
        aperture.width = extent_at(object, "width_mm");
    if (object.has("height_mm"))
        aperture.height = extent_at(object, "height_mm");
    if (object.has("shape"))
        aperture.shape = kind_at<ApertureShape>(object, "shape");
    return aperture;
}

Placement placement_from(const Object& object)
{
    Placement placement;
    placement.origin = vec3_at(object, "origin");
    placement.x = vec3_at(object, "x");
    placement.y = vec3_at(object, "y");
    placement.z = vec3_at(object, "z");
    placement.units_per_mm =
        number_at(object, "units_per_mm", 1 / largest_figure, largest_figure);
    return placement;
}

Encoding encoding_from(const Object& object)
{
    Encoding encoding;
    encoding.kind = kind_at<Encoding::Kind>(object, "kind");
    if (encoding.kind == Encoding::Kind::power)
        encoding.gamma = number_at(object, "gamma", 0.01, 100);
    return encoding;
}

ErrorEstimate error_from(const Object& object)
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
    error.seconds = number_at(object, "seconds", 0, largest_figure);
    return error;
}

RenderRecord render_from(const Object& object)
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
    const auto flag = [&](const char* name) {
        if (!object.has(name))
            return false;
        if (!object.at(name).is_boolean())
            refuse(object.path_of(name), "must be true or false");
        return object.at(name).get<bool>();
    };
    render.pseudoscopic = flag("pseudoscopic");
    render.display_prefilter = flag("display_prefilter");
    if (object.has("error"))
        render.error = error_from(object_at(object, "error"));
    return render;
}

QuiltRecord quilt_from(const Object& object)
{
    constexpr int most_a_side = 4096;
    QuiltRecord quilt;
    quilt.grid = {whole_at(object, "columns", 1, most_a_side), whole_at(object, "rows", 1, most_a_side)};
    if (object.has("view"))
        quilt.view = whole_at(object, "view", 0, quilt.grid.count() - 1);
    if (object.has("eyes")) {
        const Object eyes = object_at(object, "eyes");
        quilt.eyes = EyeGrid{{number_at(eyes, "width_mm", 0, largest_extent), number_at(eyes, "height_mm", 0, largest_extent)},
                             number_at(eyes, "distance_mm", least_distance, largest_distance)};
    }
    return quilt;
}

Json list(Vec2 v) { return Json::array({v.x, v.y}); }
Json list(Vec3 v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const LensSheet& sheet)
{
    return {{"arrangement", name_of(sheet.arrangement)}, {"pitch_mm", sheet.pitch},
            {"thickness_mm", sheet.thickness},           {"ior", sheet.ior},
            {"slant_degrees", sheet.slant},              {"offset_mm", list(sheet.offset)}};
}

Json json_of(const Subpixels& subpixels)
{
    if (subpixels != Subpixels::cells)
        return name_of(subpixels.order);
    Json cells = Json::array();
    for (int k = 0; k < subpixels.number; ++k) {
        const PixelCell& cell = subpixels.cell[k];
        cells.push_back({list(cell[0]), list(cell[1]), list(cell[2])});
    }
    return {{"pattern", name_of(subpixels.pattern)}, {"cells", cells}};
}

Json json_of(const Film& film)
{
    Json json = Json::object();
    if (film.width > 0 && film.height > 0) {
        json["width"] = film.width;
        json["height"] = film.height;
    }
    json["pixel_pitch_mm"] = list(film.pixel_pitch);
    if (film.subpixels != Subpixels::none)
        json["subpixels"] = json_of(film.subpixels);
    return json;
}

Json json_of(const Aperture& aperture)
{
    const auto extent = [](double mm) { return std::isfinite(mm) ? Json(mm) : Json(nullptr); };
    return {{"distance_mm", aperture.distance},
            {"width_mm", extent(aperture.width)},
            {"height_mm", extent(aperture.height)},
            {"shape", name_of(aperture.shape)}};
}

Json json_of(const Placement& placement)
{
    return {{"origin", list(placement.origin)},
            {"x", list(placement.x)},
            {"y", list(placement.y)},
            {"z", list(placement.z)},
            {"units_per_mm", placement.units_per_mm}};
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
    return {{"rms", error.rms},
            {"low", error.low},
            {"high", error.high},
            {"confidence", error.confidence},
            {"method", name_of(error.method)},
            {"pixels", error.pixels},
            {"lit_pixels", error.lit_pixels},
            {"samples", error.samples},
            {"seconds", error.seconds}};
}

Json json_of(const RenderRecord& render)
{
    Json json = {{"program", render.program},
                 {"scene", render.scene},
                 {"model", name_of(render.model)},
                 {"mapping", name_of(render.mapping)},
                 {"pixel_samples", render.pixel_samples},
                 {"beam_samples", render.beam_samples},
                 {"seconds", render.seconds}};
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
        json["eyes"] = {{"distance_mm", quilt.eyes->distance}, {"width_mm", quilt.eyes->zone.x}, {"height_mm", quilt.eyes->zone.y}};
    return json;
}

} // namespace

std::string to_json(const FrameMetadata& metadata)
{
    std::string text;
    // One line per object: short enough for a chunk, plain enough to read.
    const auto add = [&](const char* name, const Json& json) {
        text += text.empty() ? "{\"" : ",\n \"";
        text += name;
        text += "\": " + json.dump(-1, ' ', false, Json::error_handler_t::replace);
    };
    add("sheet", json_of(metadata.sheet));
    add("film", json_of(metadata.film));
    add("aperture", json_of(metadata.aperture));
    if (metadata.placement)
        add("camera", json_of(*metadata.placement));
    add("encoding", json_of(metadata.encoding));
    if (metadata.render)
        add("render", json_of(*metadata.render));
    if (metadata.quilt)
        add("quilt", json_of(*metadata.quilt));
    return text + "}\n";
}

FrameMetadata frame_metadata_from_json(const std::string& text)
{
    Json json;
    try {
        json = Json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        throw std::invalid_argument("is not JSON at byte " + std::to_string(error.byte));
    } catch (const nlohmann::json::exception&) {
        throw std::invalid_argument("holds a number that is out of range");
    }
    if (!json.is_object())
        throw std::invalid_argument("must be a JSON object with `sheet`, `film` and `aperture`");

    const Object document{json, ""};
    FrameMetadata metadata;
    metadata.sheet = sheet_from(object_at(document, "sheet"));
    metadata.film = film_from(object_at(document, "film"));
    check_ranges(metadata.sheet, metadata.film);
    metadata.aperture = aperture_from(object_at(document, "aperture"), metadata.sheet);
    if (document.has("camera"))
        metadata.placement = placement_from(object_at(document, "camera"));
    if (document.has("encoding"))
        metadata.encoding = encoding_from(object_at(document, "encoding"));
    if (document.has("render"))
        metadata.render = render_from(object_at(document, "render"));
    if (document.has("quilt"))
        metadata.quilt = quilt_from(object_at(document, "quilt"));
    return metadata;
}

} // namespace integral
