// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/rectify_report.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"

#include <cstdio>

namespace integral {

void LightReport::add_text(const std::string& what) { text_ += (text_.empty() ? "" : ", ") + what; }

void LightReport::add_evened(bool by_flat, bool by_surface, double ratio)
{
    json_["uneven_light"] = {
        {"by", by_surface ? (by_flat ? "flat and surface" : "surface") : "flat"}, {"ratio", ratio}};
    add_text("light evened that differed " + with_digits(ratio, 3) + " times");
}

void LightReport::add_balanced(bool by_white_patch, Colour gains)
{
    json_["colour"] = {{"by", by_white_patch ? "white patch" : "grey world"},
                       {"gains", {gains.r, gains.g, gains.b}}};
    add_text("red, green, blue times " + with_digits(gains.r, 4) + ", " + with_digits(gains.g, 4) +
             ", " + with_digits(gains.b, 4));
}

void LightReport::add_flattened(double least)
{
    json_["vignetting"] = {{"least", least}};
    add_text("micro-images flattened that fell to " + with_digits(least, 3));
}

Json rectify_json(const FoundLattice& found, const LatticeSearch& search, const Film& film,
                  const LightReport& light)
{
    const ScanMap& m = found.map;
    const double pitch = search.sheet.pitch;
    return {{"rotation_degrees", m.rotation / radians_per_degree},
            {"pitch_mm", pitch},
            {"pitch_px", {pitch * m.scale.x, pitch * m.scale.y}},
            {"micro_image_pitch_mm",
             pitch * (1 + search.sheet.thickness / (search.sheet.ior * search.aperture.distance))},
            {"middle_px", {m.middle.x, m.middle.y}},
            {"sheet_offset_mm", {search.sheet.offset.x, search.sheet.offset.y}},
            {"scan_dpi", {mm_per_inch * m.scale.x, mm_per_inch * m.scale.y}},
            {"scale", {m.scale.x / search.about.scale.x, m.scale.y / search.about.scale.y}},
            {"standard_error",
             found.errors_known
                 ? Json{{"rotation_degrees", found.rotation_error / radians_per_degree},
                        {"pitch_relative", {found.scale_error.x, found.scale_error.y}},
                        {"middle_px", {found.offset_error.x, found.offset_error.y}}}
                 : Json(nullptr)},
            {"contrast", found.contrast},
            {"significance", found.significance},
            {"rival_share", found.rival_share},
            {"parts", {{"agreeing", found.agreeing_parts}, {"of", found.parts}}},
            {"film",
             {{"width", film.width},
              {"height", film.height},
              {"pixel_pitch_mm", {film.pixel_pitch.x, film.pixel_pitch.y}}}},
            {"corrections", light.json()}};
}

namespace {

/// "0.012, 0.015%"; "unknown"
std::string errors_text(const FoundLattice& found, std::initializer_list<double> errors,
                        int decimals, const char* unit)
{
    if (!found.errors_known)
        return "unknown";
    std::string text;
    for (const double error : errors)
        text += (text.empty() ? "" : ", ") + with_decimals(error, decimals);
    return text + unit;
}

} // namespace

std::string rectify_text(const FoundLattice& found, const LatticeSearch& search, const Film& film,
                         const LightReport& light)
{
    const ScanMap& m = found.map;
    const double pitch = search.sheet.pitch;
    char text[1400];
    std::snprintf(
        text, sizeof text,
        "turned                   %.4f degrees, anticlockwise, +- %s\n"
        "lens pitch               %.4f, %.4f pixels of the scan +- %s\n"
        "the scan's resolution    %.3f, %.3f dpi (%+.3f%%, %+.3f%% against what it says)\n"
        "the sheet's middle       at %.3f, %.3f pixels of the scan +- %s\n"
        "edge on the lens borders %+.0f%%, %.0f deviations above lattices at random\n"
        "the next best lattice    has %.0f%% of the edge\n"
        "parts of the scan        %d of %d show this lattice when it is fitted without them\n"
        "frame                    %d x %d pixels of %.5g x %.5g mm\n"
        "light                    %s\n",
        m.rotation / radians_per_degree,
        errors_text(found, {found.rotation_error / radians_per_degree}, 4, "").c_str(),
        pitch * m.scale.x, pitch * m.scale.y,
        errors_text(found, {100 * found.scale_error.x, 100 * found.scale_error.y}, 4, "%").c_str(),
        mm_per_inch * m.scale.x, mm_per_inch * m.scale.y,
        100 * (m.scale.x / search.about.scale.x - 1), 100 * (m.scale.y / search.about.scale.y - 1),
        m.middle.x, m.middle.y,
        errors_text(found, {found.offset_error.x, found.offset_error.y}, 3, "").c_str(),
        100 * found.contrast, found.significance, 100 * found.rival_share, found.agreeing_parts,
        found.parts, film.width, film.height, film.pixel_pitch.x, film.pixel_pitch.y,
        light.text().empty() ? "left as it is" : light.text().c_str());
    return text;
}

} // namespace integral
