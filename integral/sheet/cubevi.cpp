// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/cubevi.h"

#include "integral/base/json_fields.h"
#include "integral/base/number_text.h"

#include <cmath>
#include <vector>

namespace integral {
namespace {

/// Prefix of OpenSSL's encrypted data, in base64.
constexpr char encrypted_text[] = "U2FsdGVkX1";

/// Collects the objects with a calibration's fields, wherever they are in a document.
void collect(const Json& json, std::vector<const Json*>& found)
{
    if (json.is_object() && json.contains("lineNumber") && json.contains("obliquity"))
        found.push_back(&json);
    else if (json.is_structured())
        for (const Json& item : json)
            collect(item, found);
}

bool is_encrypted(const Json& document)
{
    if (!document.is_object() || !document.contains("config") || !document["config"].is_string())
        return false;
    return document["config"].get_ref<const std::string&>().rfind(encrypted_text, 0) == 0;
}

/// Reads fields that a file may lack; adds a line about the missing ones to `assumed`.
void read_screen(const JsonObject& file, CubeViCalibration& display,
                 std::vector<std::string>& assumed)
{
    std::string missing;
    const auto has = [&](const char* field) {
        if (!file.has(field))
            missing += (missing.empty() ? "" : ", ") + std::string(field);
        return file.has(field);
    };
    if (has("screenW"))
        display.width = whole_at(file, "screenW", 1, 32768);
    if (has("screenH"))
        display.height = whole_at(file, "screenH", 1, 32768);
    if (has("DPI"))
        display.dpi = number_at(file, "DPI", 1, 1e5);
    if (has("viewCone"))
        display.view_cone = number_at(file, "viewCone", 0.1, 175);
    if (!missing.empty())
        assumed.push_back("it has no " + missing + ": those of a CubeVi C1 are taken, " +
                          std::to_string(display.width) + "x" + std::to_string(display.height) +
                          " pixels, " + with_digits(display.dpi, 6) + " to the inch, " +
                          with_digits(display.view_cone, 6) + " degrees");
}

} // namespace

LookingGlassCalibration looking_glass_from(const CubeViCalibration& display)
{
    // Looking Glass's phase of a pixel (column and row from 0 at the top left, the picture W by H)
    // is ((column + 1/2)/W + colour/(3 W) + tilt (H - row - 1/2)/H) P - center, tilt = H/(W slope),
    // where P is the number of micro-images in the picture's width. With P = 3 W/line_number and
    // slope = -1/obliquity the two formulas differ by a constant, which is the center.
    constexpr double steepest = 1e9; // stands for the infinite slope of upright lenses
    const double o = display.obliquity, n = display.line_number;
    LookingGlassCalibration calibration;
    calibration.serial = "CubeVi";
    calibration.pitch = 3 * display.dpi * std::sqrt(1 + o * o) / n;
    calibration.slope = std::fabs(o) > 1 / steepest ? -1 / o : steepest;
    const double center = -(1.5 + 3 * o * (display.height + 0.5) + display.deviation) / n;
    calibration.center = center - std::floor(center);
    calibration.view_cone = display.view_cone;
    calibration.dpi = display.dpi;
    calibration.width = display.width;
    calibration.height = display.height;
    return calibration;
}

std::optional<LookingGlassCalibration> cubevi_from_json(const Json& document)
{
    if (is_encrypted(document))
        throw std::invalid_argument(
            "config is encrypted; write the lineNumber, obliquity and deviation that Cubestage or "
            "OpenStageAI tells into a file: {\"lineNumber\": 19.64, \"obliquity\": 0.105, "
            "\"deviation\": 16.3}");
    std::vector<const Json*> found;
    collect(document, found);
    if (found.empty())
        return std::nullopt;
    if (found.size() > 1)
        throw std::invalid_argument("holds " + std::to_string(found.size()) +
                                    " calibrations with a lineNumber; leave one");
    const JsonObject file{*found.front(), ""};
    CubeViCalibration display;
    display.line_number = number_at(file, "lineNumber", 1, 1e4);
    display.obliquity = number_at(file, "obliquity", -50, 50);
    display.deviation = number_at(file, "deviation", -1e6, 1e6);
    std::vector<std::string> assumed;
    read_screen(file, display, assumed);
    LookingGlassCalibration calibration = looking_glass_from(display);
    if (file.has("deviceNumber") && file.at("deviceNumber").is_string())
        calibration.serial = string_at(file, "deviceNumber");
    calibration.assumed = std::move(assumed);
    return calibration;
}

} // namespace integral
