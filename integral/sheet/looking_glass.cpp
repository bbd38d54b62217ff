// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/looking_glass.h"

#include "integral/base/number_text.h"
#include "integral/frame/geometry_json.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace integral {
namespace {

constexpr int deepest = 12;               // levels of wrappers around a calibration
constexpr std::size_t most_displays = 16; // more are not counted

/// Parses a text as a JSON document; nothing if it is not one.
std::optional<Json> document_in(const std::string& text)
{
    if (text.find('{') == std::string::npos)
        return std::nullopt;
    try {
        return parse_json(text);
    } catch (const JsonError&) {
        return std::nullopt;
    }
}

/// Collects the different calibrations in a document, wrapped or not; at most most_displays + 1.
void collect(const Json& json, int depth, std::vector<Json>& found)
{
    if (depth > deepest || found.size() > most_displays)
        return;
    if (json.is_object() && json.contains("pitch") && json.contains("slope")) {
        if (std::find(found.begin(), found.end(), json) == found.end())
            found.push_back(json);
    } else if (json.is_structured()) {
        for (const Json& item : json)
            collect(item, depth + 1, found);
    } else if (json.is_string()) {
        if (const auto document = document_in(json.get_ref<const std::string&>()))
            collect(*document, depth + 1, found);
    }
}

/// A number, plain or as {"value": x}; nothing if it is absent or null.
std::optional<double> optional_number(const JsonObject& object, const char* field, double least,
                                      double greatest)
{
    if (!object.has(field) || object.at(field).is_null())
        return std::nullopt;
    if (object.at(field).is_object())
        return number_at(object_at(object, field), "value", least, greatest);
    return number_at(object, field, least, greatest);
}

double number(const JsonObject& object, const char* field, double least, double greatest)
{
    const auto value = optional_number(object, field, least, greatest);
    if (!value)
        throw_field_error(object.path_of(field), "is missing");
    return *value;
}

int whole(const JsonObject& object, const char* field, int least, int greatest)
{
    const double value = number(object, field, least, greatest);
    if (value != std::floor(value))
        throw_field_error(object.path_of(field), "must be a whole number");
    return int(value);
}

bool flag(const JsonObject& object, const char* field, bool otherwise)
{
    if (object.has(field) && object.at(field).is_boolean())
        return object.at(field).get<bool>();
    return optional_number(object, field, 0, 1).value_or(otherwise ? 1 : 0) >= 0.5;
}

/// Collects the different quilts in a document, wrapped or not.
void collect_quilts(const Json& json, int depth, std::vector<Json>& found)
{
    if (depth > deepest || found.size() > most_displays)
        return;
    if (json.is_object() && json.contains("quiltX") && json.contains("tileX")) {
        if (std::find(found.begin(), found.end(), json) == found.end())
            found.push_back(json);
    } else if (json.is_structured()) {
        for (const Json& item : json)
            collect_quilts(item, depth + 1, found);
    } else if (json.is_string()) {
        if (const auto document = document_in(json.get_ref<const std::string&>()))
            collect_quilts(*document, depth + 1, found);
    }
}

/// The only quilt in a document; nothing if there are none or several.
std::optional<PanelQuilt> quilt_in(const Json& document)
{
    constexpr int most_tiles = 256;
    std::vector<Json> found;
    collect_quilts(document, 0, found);
    if (found.size() != 1)
        return std::nullopt;
    const JsonObject quilt{found.front(), "defaultQuilt"};
    return PanelQuilt{{whole(quilt, "tileX", 1, most_tiles), whole(quilt, "tileY", 1, most_tiles)},
                      whole(quilt, "quiltX", most_tiles, largest_side),
                      whole(quilt, "quiltY", most_tiles, largest_side)};
}

constexpr CellPattern cell_patterns[] = {CellPattern::same, CellPattern::checkerboard,
                                         CellPattern::columns, CellPattern::staggered,
                                         CellPattern::rows}; // by CellPatternMode
constexpr const char* offsets[3][2] = {
    {"ROffsetX", "ROffsetY"}, {"GOffsetX", "GOffsetY"}, {"BOffsetX", "BOffsetY"}};

/// Reads the cells as an upside-down panel's with +y down: the file counts rows from the bottom.
Subpixels cells_from(const JsonObject& calibration, int width, int height,
                     std::vector<std::string>& assumed)
{
    const bool listed = calibration.has("subpixelCells") &&
                        !calibration.at("subpixelCells").is_null();
    const Json cells = listed ? calibration.at("subpixelCells") : Json::array();
    if (!cells.is_array())
        throw_field_error(calibration.path_of("subpixelCells"), "must be a list of cells");
    const auto mode = optional_number(calibration, "CellPatternMode", -largest_figure,
                                      largest_figure);
    if (cells.empty()) {
        if (mode.value_or(0) != 0)
            assumed.push_back(
                "CellPatternMode is " + with_digits(*mode, 6) +
                ", but there are no subpixelCells: stripes of red, green and blue are taken");
        return Subpixels::none;
    }
    Subpixels upside_down;
    upside_down.order = Subpixels::cells;
    if (mode)
        upside_down.pattern = cell_patterns[whole(calibration, "CellPatternMode", 0,
                                                  int(std::size(cell_patterns)) - 1)];
    else if (cells.size() > 1)
        assumed.push_back(
            "CellPatternMode is missing: every pixel is taken to be as the first of subpixelCells");
    // Cells beyond the number that the patterns distinguish are never used.
    upside_down.number = int(std::min<std::size_t>(cells.size(), Subpixels::most_cells));
    for (int k = 0; k < upside_down.number; ++k) {
        const JsonObject cell{cells[k],
                              calibration.path_of("subpixelCells") + "[" + std::to_string(k) + "]"};
        if (!cell.json.is_object())
            throw_field_error(cell.path, "must be an object");
        for (int channel = 0; channel < 3; ++channel)
            upside_down.cell[k][channel] = {number(cell, offsets[channel][0], -1, 1),
                                            0 - number(cell, offsets[channel][1], -1, 1)};
    }
    return mirrored(upside_down, width, height, false, true);
}

LookingGlassCalibration calibration_from(const JsonObject& file)
{
    LookingGlassCalibration calibration;
    if (file.has("configVersion"))
        calibration.version = file.at("configVersion").is_string()
                                  ? string_at(file, "configVersion")
                                  : file.at("configVersion").dump();
    if (file.has("serial"))
        calibration.serial = string_at(file, "serial");
    calibration.pitch = number(file, "pitch", 1e-3, 1e4);
    calibration.slope = number(file, "slope", -1e9, 1e9);
    if (std::fabs(calibration.slope) < 0.01)
        throw_field_error(file.path_of("slope"),
                          "is too near to 0, which would be lenses that lie level");
    calibration.center = number(file, "center", -1e6, 1e6);
    const auto view_cone = optional_number(file, "viewCone", 0.1, 175);
    if (!view_cone)
        calibration.assumed.push_back(
            "viewCone is missing: " + with_digits(calibration.view_cone, 6) +
            " degrees are taken, and the viewing zone follows from them");
    calibration.view_cone = view_cone.value_or(calibration.view_cone);
    calibration.vertical_angle = optional_number(file, "verticalAngle", -180, 180).value_or(0);
    calibration.fringe = optional_number(file, "fringe", -1e6, 1e6).value_or(0);
    calibration.dpi = number(file, "DPI", 1, 1e5);
    calibration.width = whole(file, "screenW", 1, largest_side);
    calibration.height = whole(file, "screenH", 1, largest_side);
    calibration.inverted_views = flag(file, "invView", true);
    if (!calibration.inverted_views)
        calibration.assumed.push_back("invView is 0: the makers' shaders do not read it, and views "
                                      "are taken as if it were 1");
    calibration.flip_x = flag(file, "flipImageX", false);
    calibration.flip_y = flag(file, "flipImageY", false);
    calibration.flip_subpixels = flag(file, "flipSubp", false);
    for (const auto& [field, set] : {std::pair{"flipImageX", calibration.flip_x},
                                     std::pair{"flipSubp", calibration.flip_subpixels}})
        if (set)
            calibration.assumed.push_back(
                std::string(field) +
                " is 1, as in no published calibration: the picture follows the makers' "
                "shaders and has not been seen on a display; check it by integral lcd --card");
    calibration.cells = cells_from(file, calibration.width, calibration.height,
                                   calibration.assumed);
    return calibration;
}

} // namespace

LookingGlassCalibration looking_glass_from_json(const Json& document)
{
    std::vector<Json> found;
    collect(document, 0, found);
    if (found.empty())
        throw NoCalibration();
    if (found.size() > 1)
        throw std::invalid_argument("holds the calibrations of " +
                                    (found.size() > most_displays
                                         ? "more than " + std::to_string(most_displays)
                                         : std::to_string(found.size())) +
                                    " displays; leave one");
    LookingGlassCalibration calibration = calibration_from({found.front(), ""});
    calibration.quilt = quilt_in(document);
    return calibration;
}

Json json_of(const LookingGlassCalibration& calibration)
{
    Json file = {{"configVersion", calibration.version},
                 {"serial", calibration.serial},
                 {"pitch", calibration.pitch},
                 {"slope", calibration.slope},
                 {"center", calibration.center},
                 {"fringe", calibration.fringe},
                 {"viewCone", calibration.view_cone},
                 {"invView", int(calibration.inverted_views)},
                 {"verticalAngle", calibration.vertical_angle},
                 {"DPI", calibration.dpi},
                 {"screenW", calibration.width},
                 {"screenH", calibration.height},
                 {"flipImageX", int(calibration.flip_x)},
                 {"flipImageY", int(calibration.flip_y)},
                 {"flipSubp", int(calibration.flip_subpixels)}};
    if (const auto& quilt = calibration.quilt)
        file["defaultQuilt"] = {{"quiltX", quilt->width},
                                {"quiltY", quilt->height},
                                {"tileX", quilt->tiles.columns},
                                {"tileY", quilt->tiles.rows}};
    if (calibration.cells == Subpixels::cells) {
        const Subpixels upside_down = mirrored(calibration.cells, calibration.width,
                                               calibration.height, false, true);
        file["CellPatternMode"] = std::find(std::begin(cell_patterns), std::end(cell_patterns),
                                            upside_down.pattern) -
                                  cell_patterns;
        for (int k = 0; k < upside_down.number; ++k) {
            Json cell;
            for (int channel = 0; channel < 3; ++channel) {
                cell[offsets[channel][0]] = upside_down.cell[k][channel].x;
                cell[offsets[channel][1]] = 0 - upside_down.cell[k][channel].y;
            }
            file["subpixelCells"].push_back(cell);
        }
    }
    return file;
}

double view_of_subpixel(const LookingGlassCalibration& calibration, int column, int row,
                        int channel)
{
    // The pixel's centre, from the image's bottom left, as parts of its width and height.
    double u = (column + 0.5) / calibration.width;
    double v = (calibration.height - row - 0.5) / calibration.height;
    if (calibration.cells == Subpixels::cells) {
        const Vec2 shift = subpixel_shift(calibration.cells, {column + 0.5, row + 0.5}, channel);
        u += shift.x / calibration.width;
        v -= shift.y / calibration.height;
    } else {
        u += (calibration.flip_subpixels ? -channel : channel) / (3.0 * calibration.width);
    }
    const double pitch = calibration.pitch * calibration.width / calibration.dpi *
                         std::cos(std::atan(1 / calibration.slope));
    const double tilt = calibration.height / (calibration.width * calibration.slope);
    // In a mirror, the image's right is seen on the left: u becomes 1 - u, and the tilt is negated.
    const double across = calibration.flip_x ? 1 - u - v * tilt : u + v * tilt;
    const double phase = across * pitch - calibration.center;
    const double fraction = phase - std::floor(phase);
    return std::min(1 - fraction, 1 - 0.5 * std::numeric_limits<double>::epsilon());
}

} // namespace integral
