// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/geometry_json.h"

#include "integral/optics/aperture_error.h"
#include "integral/optics/visual_pitch.h"

#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

int side_at(const JsonObject& object, const char* field)
{
    return whole_at(object, field, 1, largest_side);
}

/// A list of the positions of red, green and blue in a pixel.
PixelCell cell_from(const Json& json, const std::string& path)
{
    if (!json.is_array() || json.size() != 3)
        throw_field_error(path, "must be a list of three places: red's, green's and blue's");
    PixelCell cell;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto place = numbers_in(json[channel], path + "[" + std::to_string(channel) + "]", 2,
                                      -1, 1);
        cell[channel] = {place[0], place[1]};
    }
    return cell;
}

double extent_at(const JsonObject& object, const char* field)
{
    if (object.at(field).is_null())
        return infinity;
    return number_at(object, field, 0, largest_extent);
}

} // namespace

void check_ranges(const LensSheet& sheet, const Film& film)
{
    CameraParameters parameters;
    parameters.sheet = sheet;
    parameters.film.pixel_pitch = film.pixel_pitch;
    parameters.film.bleed = film.bleed;
    const auto errors = find_value_errors(parameters);
    const std::string error = errors.empty() ? bleed_error(film) : errors.front();
    if (!error.empty())
        throw std::invalid_argument(error);
}

LensSheet sheet_from(const JsonObject& object, const char* pitch_field)
{
    LensSheet sheet;
    sheet.arrangement = kind_at<Arrangement>(object, "arrangement");
    sheet.pitch = number_at(object, pitch_field, 0, largest_figure);
    sheet.thickness = number_at(object, "thickness_mm", 0, largest_figure);
    sheet.ior = number_at(object, "ior", 0, largest_figure);
    if (object.has("slant_degrees"))
        sheet.slant = number_at(object, "slant_degrees", -90, 90);
    if (object.has("offset_mm"))
        sheet.offset = vec2_at(object, "offset_mm", -largest_figure, largest_figure);
    return sheet;
}

LensSheet sheet_seen_from(const JsonObject& object, std::optional<double> distance)
{
    const char* const field = "micro_image_pitch_mm";
    if (!object.has(field))
        return sheet_from(object);
    if (object.has("pitch_mm"))
        throw_field_error(object.path_of(field),
                          "cannot stand beside pitch_mm: one follows from the other");
    if (!distance)
        throw_field_error(object.path_of(field),
                          "needs aperture.distance_mm, from where it is seen");
    LensSheet sheet = sheet_from(object, field);
    check_ranges(sheet, {1, 1, {1, 1}});
    sheet.pitch = pitch_of_visual(sheet.pitch, sheet, *distance);
    return sheet;
}

double nominal_viewing_distance(Vec2 size) { return 2.5 * std::sqrt(dot(size, size)); }

Subpixels subpixels_from(const JsonObject& film)
{
    if (!film.at("subpixels").is_object()) {
        const auto order = kind_at<Subpixels::Order>(film, "subpixels");
        if (order == Subpixels::cells)
            throw_field_error(film.path_of("subpixels"),
                              "must be an object of pattern and cells, where it is no stripes");
        return order;
    }
    const JsonObject object = object_at(film, "subpixels");
    Subpixels subpixels;
    subpixels.order = Subpixels::cells;
    subpixels.pattern = kind_at<CellPattern>(object, "pattern");
    const Json& cells = object.at("cells");
    if (!cells.is_array() || cells.empty() || cells.size() > Subpixels::most_cells)
        throw_field_error(object.path_of("cells"), "must be a list of 1 to " +
                                                       std::to_string(Subpixels::most_cells) +
                                                       " cells");
    for (const Json& cell : cells) {
        subpixels.cell[subpixels.number] = cell_from(
            cell, object.path_of("cells") + "[" + std::to_string(subpixels.number) + "]");
        ++subpixels.number;
    }
    return subpixels;
}

Film film_from(const JsonObject& object, PitchForm form)
{
    Film film;
    if (object.has("width") || object.has("height")) {
        film.width = side_at(object, "width");
        film.height = side_at(object, "height");
    }
    const char* const field = "pixel_pitch_mm";
    if (form == PitchForm::number_or_pair && object.at(field).is_number()) {
        const double pitch = number_at(object, field, 0, largest_figure);
        film.pixel_pitch = {pitch, pitch};
    } else {
        film.pixel_pitch = vec2_at(object, field, 0, largest_figure);
    }
    if (object.has("subpixels"))
        film.subpixels = subpixels_from(object);
    if (object.has("bleed_mm"))
        film.bleed = number_at(object, "bleed_mm", 0, largest_extent);
    return film;
}

Aperture default_aperture(const LensSheet& sheet, double distance)
{
    const auto filling = filling_aperture(sheet, distance);
    Aperture aperture;
    aperture.distance = distance;
    aperture.width = filling ? filling->width : infinity;
    aperture.height = filling ? filling->height : infinity;
    return aperture;
}

Aperture aperture_from(const JsonObject& object, const LensSheet& sheet)
{
    Aperture aperture = default_aperture(
        sheet, number_at(object, "distance_mm", least_distance, largest_distance));
    if (object.has("width_mm"))
        aperture.width = extent_at(object, "width_mm");
    if (object.has("height_mm"))
        aperture.height = extent_at(object, "height_mm");
    if (object.has("shape"))
        aperture.shape = kind_at<ApertureShape>(object, "shape");
    const std::string error = aperture_error(sheet, {aperture.width, aperture.height});
    if (!error.empty())
        throw std::invalid_argument(error);
    return aperture;
}

Json json_of(const LensSheet& sheet)
{
    return {{"arrangement", name_of(sheet.arrangement)},
            {"pitch_mm", sheet.pitch},
            {"thickness_mm", sheet.thickness},
            {"ior", sheet.ior},
            {"slant_degrees", sheet.slant},
            {"offset_mm", list(sheet.offset)}};
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
    if (film.bleed > 0)
        json["bleed_mm"] = film.bleed;
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

Vec2 vec2_at(const JsonObject& object, const char* field, double least, double greatest)
{
    const auto v = numbers_at(object, field, 2, least, greatest);
    return {v[0], v[1]};
}

Json list(Vec2 v) { return Json::array({v.x, v.y}); }

} // namespace integral
