// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/panel.h"

#include "integral/base/constants.h"
#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"
#include "integral/frame/geometry_json.h"
#include "integral/sheet/cubevi.h"

#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// The zone at a distance whose micro-images are as wide as the lenses; an unlimited zone if there
/// is none. Throws std::invalid_argument if no frame could have that distance.
Aperture zone_at(double distance, const LensSheet& sheet)
{
    if (!(distance >= least_distance && distance <= largest_distance))
        throw_field_error("aperture.distance_mm", "is " + with_digits(distance, 6) +
                                                      ", and must be within " +
                                                      with_digits(least_distance, 6) + " and " +
                                                      with_digits(largest_distance, 6));
    return default_aperture(sheet, distance);
}

/// Reads the field mirrored: x, y or xy.
void read_mirrored(const JsonObject& object, Panel& panel)
{
    if (!object.has("mirrored"))
        return;
    const std::string word = string_at(object, "mirrored");
    if (word != "x" && word != "y" && word != "xy")
        throw_field_error(object.path_of("mirrored"), "must be x, y or xy");
    panel.mirrored_x = word != "y";
    panel.mirrored_y = word != "x";
}

/// Reads the panel's pixels: a frame's film, except that their pitch may be one number.
void read_pixels(const JsonObject& object, Panel& panel)
{
    throw_on_unknown_fields(object,
                            {"name", "width", "height", "pixel_pitch_mm", "subpixels", "mirrored"});
    if (object.has("name"))
        panel.name = string_at(object, "name");
    object.at("width"); // optional in a frame's film
    object.at("pixel_pitch_mm");
    panel.film = film_from(object, PitchForm::number_or_pair);
    read_mirrored(object, panel);
}

/// Reads the sheet, with its own pitch or its micro-images' pitch as seen from a distance.
LensSheet read_sheet(const JsonObject& object, double distance)
{
    throw_on_unknown_fields(object, {"arrangement", "pitch_mm", "micro_image_pitch_mm",
                                     "thickness_mm", "ior", "slant_degrees", "offset_mm"});
    return sheet_seen_from(object, distance);
}

/// Reads a display's calibration, of any known maker, in Looking Glass's form.
LookingGlassCalibration calibration_in(const Json& document)
{
    const auto cubevi = cubevi_from_json(document);
    return cubevi ? *cubevi : looking_glass_from_json(document);
}

LookingGlassCalibration read_calibration(const JsonObject& document)
{
    try {
        return calibration_in(document.at("calibration"));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string("calibration: ") + error.what());
    }
}

Panel read_document(const JsonObject& document)
{
    throw_on_unknown_fields(
        document, {"panel", "sheet", "aperture", "viewing_distance_mm", "calibration", "ior"});
    if (document.has("aperture") && document.has("viewing_distance_mm"))
        throw_field_error("viewing_distance_mm",
                          "cannot stand beside aperture, which has it as distance_mm");
    std::optional<double> distance;
    if (document.has("viewing_distance_mm"))
        distance = number_at(document, "viewing_distance_mm", least_distance, largest_distance);
    else if (document.has("aperture"))
        distance = number_at(object_at(document, "aperture"), "distance_mm", least_distance,
                             largest_distance);

    Panel panel;
    if (document.has("calibration"))
        panel.calibration = read_calibration(document);
    if (panel.calibration && !document.has("panel") && !document.has("sheet")) {
        panel = panel_from(*panel.calibration, distance,
                           document.has("ior") ? number_at(document, "ior", 1.01, 4) : nominal_ior);
    } else {
        if (document.has("ior"))
            throw_field_error("ior", "belongs into sheet");
        read_pixels(object_at(document, "panel"), panel);
        panel.sheet = read_sheet(object_at(document, "sheet"),
                                 distance.value_or(nominal_viewing_distance(size_of(panel.film))));
        check_ranges(panel.sheet, panel.film);
        panel.aperture = zone_at(distance.value_or(nominal_viewing_distance(size_of(panel.film))),
                                 panel.sheet);
    }
    if (panel.calibration && (panel.film.width != panel.calibration->width ||
                              panel.film.height != panel.calibration->height))
        throw_field_error("calibration", "is of a display of another size than panel");
    if (document.has("aperture")) {
        const JsonObject aperture = object_at(document, "aperture");
        throw_on_unknown_fields(aperture, {"distance_mm", "width_mm", "height_mm", "shape"});
        panel.aperture = aperture_from(aperture, panel.sheet);
    }
    return panel;
}

} // namespace

Panel panel_from(const LookingGlassCalibration& calibration, std::optional<double> viewing_distance,
                 double ior)
{
    Panel panel;
    panel.name = calibration.serial.empty() ? "Looking Glass" : calibration.serial;
    panel.calibration = calibration;
    panel.mirrored_x = calibration.flip_x;
    panel.mirrored_y = calibration.flip_y;
    const double pixel = mm_per_inch / calibration.dpi;
    Subpixels layout = calibration.cells;
    if (layout != Subpixels::cells)
        layout = calibration.flip_subpixels ? Subpixels::bgr : Subpixels::rgb;
    panel.film = {calibration.width,
                  calibration.height,
                  {pixel, pixel},
                  mirrored(layout, calibration.width, calibration.height, calibration.flip_x,
                           calibration.flip_y)};
    const double distance = viewing_distance.value_or(
        nominal_viewing_distance(size_of(panel.film)));

    const double slant = std::atan((calibration.flip_x != calibration.flip_y ? -1 : 1) /
                                   calibration.slope);
    const double cosine = std::cos(slant);
    // A lens's cell, 2 c = p/cos(slant) wide, fills the cone: sin(cone/2) = n c/sqrt(c^2 + t^2).
    // This gives t = p quotient.
    const double sine = std::sin(0.5 * calibration.view_cone * radians_per_degree);
    const double quotient = std::sqrt((ior - sine) * (ior + sine)) / (2 * sine * cosine);
    const double micro_image = mm_per_inch / calibration.pitch;
    // M = p (1 + p quotient/(n d))
    panel.sheet.pitch = 2 * micro_image /
                        (1 + std::sqrt(1 + 4 * micro_image * quotient / (ior * distance)));
    panel.sheet.thickness = panel.sheet.pitch * quotient;
    panel.sheet.ior = ior;
    panel.sheet.slant = slant / radians_per_degree;

    // Finds the phase at the sheet's centre, and from there the nearest point across the lenses at
    // which the phase is a half.
    const double per_pixel = calibration.pitch / calibration.dpi *
                             cosine; // change of phase per pixel
    double phase = 0.5 * per_pixel *
                       (calibration.width +
                        calibration.height / calibration.slope * (calibration.flip_x ? -1 : 1)) -
                   calibration.center;
    if (layout != Subpixels::cells)
        phase += per_pixel * (panel.film.subpixels == Subpixels::bgr ? -1 : 1) / 3;
    const double nearest = std::round(phase - 0.5) + 0.5 - phase;
    panel.sheet.offset = {nearest * panel.sheet.pitch / cosine, 0};
    check_ranges(panel.sheet, panel.film);
    panel.aperture = zone_at(distance, panel.sheet);
    return panel;
}

Panel panel_from_json(const std::string& text)
{
    const Json json = parse_json(text);
    for (const char* const field : {"panel", "sheet", "aperture", "viewing_distance_mm", "ior"})
        if (json.is_object() && json.contains(field))
            return read_document({json, ""});
    try {
        return panel_from(calibration_in(json));
    } catch (const NoCalibration&) {
        throw std::invalid_argument(std::string("holds neither a panel's description: an object "
                                                "with panel, sheet and viewing_distance_mm, "
                                                "nor a Looking Glass calibration: ") +
                                    NoCalibration::requested +
                                    ", nor a CubeVi one, with lineNumber, obliquity and deviation");
    }
}

Panel find_panel(const std::string& name)
{
    if (const auto known = panel_named(name))
        return *known;
    if (extension_of(name) != "json")
        throw std::invalid_argument(
            "no panel has this name; take one of integral lcd --list, or a description, whose name "
            "ends in .json");
    const std::string bytes = read_file(name);
    try {
        return panel_from_json(bytes);
    } catch (const std::invalid_argument& error) {
        throw InputError(name + ": " + error.what());
    }
}

Panel seen_from(const Panel& panel, double distance)
{
    Panel seen = panel;
    if (panel.calibration) {
        const Panel made = panel_from(*panel.calibration, distance, panel.sheet.ior);
        seen.sheet = made.sheet;
        seen.aperture = made.aperture;
        return seen;
    }
    const auto filling = filling_aperture(panel.sheet, distance);
    if (!filling)
        throw std::invalid_argument(
            "no zone fills its lenses; a description with an aperture would do");
    seen.aperture = *filling;
    return seen;
}

std::string to_json(const Panel& panel)
{
    Json pixels = {{"name", panel.name}};
    pixels.update(json_of(panel.film));
    if (panel.mirrored_x || panel.mirrored_y)
        pixels["mirrored"] = std::string(panel.mirrored_x ? "x" : "") +
                             (panel.mirrored_y ? "y" : "");
    Json document = {
        {"panel", pixels}, {"sheet", json_of(panel.sheet)}, {"aperture", json_of(panel.aperture)}};
    if (panel.calibration)
        document["calibration"] = json_of(*panel.calibration);
    return text_of(document);
}

FrameMetadata frame_geometry(const Panel& panel)
{
    FrameMetadata geometry;
    geometry.sheet = panel.sheet;
    geometry.film = panel.film;
    geometry.aperture = panel.aperture;
    return geometry;
}

} // namespace integral
