// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/calibration_report.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/optics/film.h"

#include <cmath>
#include <cstdio>

namespace integral {
namespace {

Json json_of(Estimate estimate)
{
    return {{"value", estimate.value}, {"deviation", estimate.deviation}};
}

std::string text_of(Estimate estimate, int decimals, double unit = 1)
{
    return with_decimals(unit * estimate.value, decimals) + " +- " +
           with_decimals(unit * estimate.deviation, decimals);
}

/// Whether the photo determines t/n better than the nominal figures do.
bool bend_is_measured(const SheetCalibration& found)
{
    return found.thickness_over_index.deviation <
           0.7 * found.expected_thickness_over_index.deviation;
}

/// Light from both sides.
Estimate leak_of(const CalibrationLight& light)
{
    return {light.left.value + light.right.value,
            std::hypot(light.left.deviation, light.right.deviation)};
}

} // namespace

LensSheet calibrated_sheet(LensSheet nominal, const SheetCalibration& found)
{
    nominal.pitch = found.pitch.value;
    nominal.slant += found.turn.value;
    if (std::fabs(nominal.slant) > 90)
        nominal.slant -= std::copysign(180, nominal.slant);
    nominal.offset = found.phase.value *
                     Vec2{std::cos(found.view.angle), std::sin(found.view.angle)};
    nominal.ior = nominal.thickness / found.thickness_over_index.value;
    return nominal;
}

Json calibration_json(const LensSheet& nominal, const SheetCalibration& found)
{
    const LensSheet sheet = calibrated_sheet(nominal, found);
    const CalibrationLight& light = found.light;
    Json json = {{"pitch_mm", json_of(found.pitch)},
                 {"turn_degrees", json_of(found.turn)},
                 {"phase_mm", json_of(found.phase)},
                 {"offset_mm", {sheet.offset.x, sheet.offset.y}},
                 {"thickness_over_index_mm", json_of(found.thickness_over_index)},
                 {"expected_thickness_over_index_mm", json_of(found.expected_thickness_over_index)},
                 {"thickness_over_index_measured", bend_is_measured(found)},
                 {"distance_mm", json_of(found.distance)},
                 {"corners", {{"used", found.corners}, {"of", found.corners_of}}},
                 {"corner_residual_px", found.corner_residual},
                 {"blocks", {{"used", found.blocks}, {"of", found.blocks_of}}},
                 {"phase_residual", found.phase_residual},
                 {"contrast", light.coverage_known ? json_of(light.contrast) : Json(nullptr)}};
    json["leak"] = light.leak_known ? Json{{"own", json_of(light.own)},
                                           {"left", json_of(light.left)},
                                           {"right", json_of(light.right)}}
                                    : Json(nullptr);
    json["coverage"] = light.coverage_known ? Json{{"25", json_of(light.coverage[0])},
                                                   {"50", json_of(light.coverage[1])},
                                                   {"75", json_of(light.coverage[2])}}
                                            : Json(nullptr);
    return json;
}

std::string calibration_text(const LensSheet& nominal, const SheetCalibration& found)
{
    const LensSheet sheet = calibrated_sheet(nominal, found);
    const CalibrationLight& light = found.light;
    std::string text = "lens pitch         " + text_of(found.pitch, 5) + " mm, " +
                       with_decimals(mm_per_inch / found.pitch.value, 4) + " lenses per inch\n" +
                       "turned             " + text_of(found.turn, 4) +
                       " degrees, anticlockwise, against the print\n" + "phase              " +
                       text_of(found.phase, 4) + " mm from the page's middle to a lens's axis, " +
                       with_decimals(100 * found.phase.value / found.pitch.value, 1) +
                       "% of a pitch\n" + "thickness / index  " +
                       text_of(found.thickness_over_index, 4) + " mm, index " +
                       with_decimals(sheet.ior, 3) + " at the nominal thickness; expected " +
                       text_of(found.expected_thickness_over_index, 4) +
                       (bend_is_measured(found) ? "\n" : ", which counts as much as the photo\n");
    if (light.leak_known)
        text += "leak               " + text_of(leak_of(light), 1, 100) + "% from places " +
                with_decimals(leak_line, 3) + " pitch to the left (" + text_of(light.left, 1, 100) +
                "%) and right (" + text_of(light.right, 1, 100) + "%); " +
                text_of(light.own, 1, 100) + "% from its own\n";
    if (light.coverage_known)
        text += "contrast           " + text_of(light.contrast, 1, 100) +
                "% of lines half a pitch wide\n" +
                "dot gain           fine lines of 25, 50, 75% "
                "look like " +
                with_decimals(100 * light.coverage[0].value, 0) + ", " +
                with_decimals(100 * light.coverage[1].value, 0) + ", " +
                with_decimals(100 * light.coverage[2].value, 0) + "%\n";
    if (light.too_light)
        text += "leak, dot gain     unknown, since fine lines look lighter than they are printed; "
                "photograph less exposed and without reflections\n";
    text += "photographed from  " + text_of(found.distance, 0) + " mm\n" + "fit                " +
            std::to_string(found.corners) + " of " + std::to_string(found.corners_of) +
            " squares' corners within " + with_decimals(found.corner_residual, 3) + " pixels, " +
            std::to_string(found.blocks) + " of " + std::to_string(found.blocks_of) +
            " parts of the bands within " + with_decimals(100 * found.phase_residual, 2) +
            "% of a pitch\n";
    return text;
}

} // namespace integral
