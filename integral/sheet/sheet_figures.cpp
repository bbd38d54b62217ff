// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/sheet_figures.h"

#include "integral/base/constants.h"
#include "integral/optics/visual_pitch.h"

#include <cmath>

namespace integral {
namespace {

constexpr double line_pairs = 0.5; // of a pixel or a lens: two make a pair

/// The angle in air, in degrees, of a ray that moves by `lateral` through the sheet's thickness.
/// Empty if the ray is totally reflected.
std::optional<double> refracted_angle(const LensSheet& sheet, double lateral)
{
    const double s = sheet.ior * std::sin(std::atan(lateral / sheet.thickness));
    if (s > 1)
        return std::nullopt;
    return std::asin(s) * degrees_per_radian;
}

} // namespace

std::optional<double> greatest_angle(const LensSheet& sheet)
{
    return refracted_angle(sheet, sheet.pitch / 2);
}

std::optional<double> half_lost_angle(const LensSheet& sheet)
{
    return refracted_angle(sheet, sheet.pitch / 4);
}

double field_lens_focus(const LensSheet& sheet) { return sheet.thickness / 2; }

double macro_lens_depth(double focal_length, double nearest)
{
    return focal_length * focal_length / (nearest - focal_length);
}

double macro_lens_nearest(double focal_length, double depth)
{
    return focal_length + focal_length * focal_length / depth;
}

double pinhole_spread(const LensSheet& sheet, double distance, double width)
{
    return sheet.thickness * width / distance;
}

double filling_distance(const LensSheet& sheet, double width, double cell)
{
    return width * sheet.thickness / (sheet.ior * cell);
}

double pixels_seen(const LensSheet& sheet, double pixel, double pupil, double distance)
{
    return sheet.thickness / pixel * pupil / distance;
}

std::optional<double> pixel_angle(const LensSheet& sheet, double pixel)
{
    return refracted_angle(sheet, pixel);
}

double pixel_spread(double angle, double distance)
{
    return 2 * distance * std::tan(angle / degrees_per_radian / 2);
}

std::optional<double> depth_resolution(const LensSheet& sheet, double pixel, double depth)
{
    const double t = sheet.thickness, p = sheet.pitch, n = sheet.ior;
    const double square = 4 * t * t + p * p - n * n * p * p;
    if (!(square >= 0))
        return std::nullopt;
    return line_pairs / pixel / n * std::sqrt(square) / (2 * depth);
}

std::optional<double> depth_budget(const LensSheet& sheet, double pixel)
{
    const auto at_unit_depth = depth_resolution(sheet, pixel, 1);
    if (!at_unit_depth)
        return std::nullopt;
    return *at_unit_depth * sheet.pitch / line_pairs;
}

double observer_resolution(double pitch, double viewing, double object)
{
    return line_pairs / ((viewing - object) * (pitch / viewing));
}

double discrete_view_distance(const LensSheet& sheet, double pixel, double width)
{
    return width * sheet.thickness / pixel;
}

std::optional<double> moire_pitch(double pitch, const LensSheet& sheet, double pixel,
                                  double distance)
{
    const double pixels = visual_pitch(pitch, sheet, distance) / pixel;
    const double odd = std::fabs(pixels - std::round(pixels));
    if (odd < 1e-9 * pixels)
        return std::nullopt;
    return pitch / odd;
}

WholePicture whole_picture(double distance, double zone, double width)
{
    const double zones = zone / width;
    return {distance / (1 + zones),
            zones < 1 ? std::optional<double>(distance / (1 - zones)) : std::nullopt};
}

} // namespace integral
