// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/error_against_time.h"

#include <stdexcept>

namespace integral::bench {

namespace {

Setting beam(int samples)
{
    const std::string n = std::to_string(samples);
    return {Family::beam, n, "beam_samples " + n, {}};
}

Setting pixel(int samples)
{
    const std::string n = std::to_string(samples);
    return {Family::pixel, n, "pixel_samples " + n, {}};
}

Setting both(int pixel_samples, int beam_samples)
{
    return {Family::both,
            std::to_string(pixel_samples) + "x" + std::to_string(beam_samples),
            "pixel_samples " + std::to_string(pixel_samples) + " beam_samples " +
                std::to_string(beam_samples),
            {}};
}

Setting mapping(const std::string& name)
{
    return {Family::one_ray, name, "lens_mapping " + name, {}};
}

Setting model(const std::string& name, const std::string& words)
{
    return {Family::model, name, "lens_model " + words, {}};
}

/// Anti-aliasing in the light field. `rule`: the options +A, +R and +AM. `sharing`: the value of
/// Integral_Sharing; empty: its default.
Setting light_field(const std::string& name, std::vector<std::string> rule,
                    const std::string& sharing = "")
{
    if (!sharing.empty())
        rule.push_back("Integral_Sharing=" + sharing);
    return {Family::light_field, name, "", rule};
}

/// POV-Ray's own anti-aliasing on the grid of pixels.
Setting antialias(const std::string& name, std::vector<std::string> rule,
                  const std::string& words = "")
{
    rule.push_back("Integral_Antialiasing=pixels");
    return {Family::antialias, name, words, rule};
}

std::vector<Setting> light_field_settings()
{
    return {
        light_field("0.3", {"+A0.3", "+R5", "+AM2"}),
        light_field("0.1", {"+A0.1", "+R5", "+AM2"}),
        light_field("0.05", {"+A0.05", "+R5", "+AM2"}),
        light_field("0.03", {"+A0.03", "+R5", "+AM2"}),
        light_field("0.02", {"+A0.02", "+R5", "+AM2"}),
        light_field("0.01", {"+A0.01", "+R5", "+AM2"}),
        light_field("0.1 alone", {"+A0.1", "+R5", "+AM2"}, "off"),
        light_field("0.03 alone", {"+A0.03", "+R5", "+AM2"}, "off"),
        light_field("0.03 shared 4", {"+A0.03", "+R5", "+AM2"}, "4"),
        light_field("0.01 shared 4", {"+A0.01", "+R5", "+AM2"}, "4"),
        light_field("AM1 R3", {"+A0.1", "+R3", "+AM1"}),
        light_field("AM1 R5", {"+A0.1", "+R5", "+AM1"}),
        light_field("AM1 R8", {"+A0.03", "+R8", "+AM1"}),
    };
}

/// POV-Ray's methods 1 and 2, without and with beam_samples.
std::vector<Setting> pixel_grid_settings()
{
    return {
        antialias("AM1", {"+A0.3", "+R3", "+AM1"}),
        antialias("AM2", {"+A0.3", "+R3", "+AM2"}),
        antialias("AM1 0.1", {"+A0.1", "+R3", "+AM1"}),
        antialias("AM1 0", {"+A0.0", "+R3", "+AM1"}),
        antialias("AM2 0.1", {"+A0.1", "+R3", "+AM2"}),
        antialias("AM2 0", {"+A0.0", "+R3", "+AM2"}),
        antialias("AM1 +R2 beam 4", {"+A0.3", "+R2", "+AM1"}, "beam_samples 4"),
        antialias("AM1 beam 4", {"+A0.3", "+R3", "+AM1"}, "beam_samples 4"),
        antialias("AM1 0.1 beam 4", {"+A0.1", "+R3", "+AM1"}, "beam_samples 4"),
        antialias("AM1 0 beam 4", {"+A0.0", "+R3", "+AM1"}, "beam_samples 4"),
        antialias("AM2 0.1 beam 4", {"+A0.1", "+R3", "+AM2"}, "beam_samples 4"),
    };
}

void append(std::vector<Setting>& list, const std::vector<Setting>& more)
{
    list.insert(list.end(), more.begin(), more.end());
}

} // namespace

const char* title_of(Family family)
{
    switch (family) {
    case Family::one_ray: return "one ray, by lens_mapping";
    case Family::beam: return "beam_samples N";
    case Family::pixel: return "pixel_samples N";
    case Family::both: return "pixel_samples N beam_samples M (NxM)";
    case Family::light_field: return "+A in the light field";
    case Family::antialias: return "POV-Ray's +A by pixels";
    case Family::model: return "other lens_model";
    }
    throw std::logic_error("unknown family");
}

std::string Setting::full_name() const
{
    std::string text = words;
    for (const std::string& option : options)
        text += (text.empty() ? "" : " ") + option;
    return text;
}

const std::vector<std::string>& scene_names()
{
    static const std::vector<std::string> names = {"matte", "textured", "radiosity",
                                                   "glass", "detail",   "soft"};
    return names;
}

const std::vector<Sheet>& sheets()
{
    static const std::vector<Sheet> all = {
        {"lenticular", "1.27 mm lenticular", 1.27, 3.08, 1.6},
        {"square", "1.124 mm square", 1.124, 3.23, 1.675},
    };
    return all;
}

std::vector<Setting> ladder(Extent extent)
{
    if (extent == Extent::quick)
        return {mapping("auto"),
                mapping("closest"),
                beam(4),
                beam(16),
                pixel(4),
                both(2, 2),
                both(4, 4),
                light_field("0.1", {"+A0.1", "+R4", "+AM2"}),
                light_field("0.1 alone", {"+A0.1", "+R4", "+AM2"}, "off"),
                light_field("AM1 R3", {"+A0.1", "+R3", "+AM1"}),
                antialias("AM1", {"+A0.3", "+R3", "+AM1"}),
                model("pinhole", "pinhole"),
                model("hybrid", "hybrid"),
                model("full 16", "full beam_samples 16")};
    std::vector<Setting> result = {mapping("auto"), beam(2),    beam(3),    beam(4),    beam(8),
                                   both(2, 2),      both(2, 4), both(4, 4), both(4, 8), both(8, 8)};
    append(result, light_field_settings());
    if (extent != Extent::light_field)
        append(result, pixel_grid_settings());
    if (extent == Extent::all)
        append(result,
               {mapping("closest"), mapping("accurate"), mapping("exhaustive"), beam(16), beam(64),
                pixel(4), pixel(16),
                antialias("AM1 linear", {"+A0.3", "+R3", "+AM1", "Antialias_Gamma=1"}),
                model("pinhole", "pinhole"), model("hybrid", "hybrid"),
                model("full 4", "full beam_samples 4"), model("full 16", "full beam_samples 16"),
                model("full 4x4", "full pixel_samples 4 beam_samples 4")});
    return result;
}

Setting reference_setting(Extent extent)
{
    Setting setting = extent == Extent::quick || extent == Extent::light_field ? both(8, 32)
                                                                               : both(16, 64);
    setting.name = "reference";
    setting.options = {"Integral_Seed=20011"};
    return setting;
}

std::string camera_words(const Sheet& sheet, const Setting& setting, int finer)
{
    return "lens_sheet { " + sheet.words(finer) + " } film { dpi " +
           std::to_string(int(dots_per_inch) * finer) + " } " + setting.words;
}

} // namespace integral::bench
