// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests panels: their descriptions, and that our optics and the maker's mapping send the subpixels
// of a display to the same views.
#include "integral/sheet/panel.h"

#include "integral/frame/geometry_json.h"
#include "integral/optics/lens_mapping.h"
#include "integral/sheet/camera_words.h"
#include "tests/unit/looking_glass_devices.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

using namespace integral;
using namespace looking_glass_devices;

BOOST_AUTO_TEST_SUITE(sheet_panels)

namespace {

std::string refusal(const std::string& text)
{
    try {
        panel_from_json(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

const char own[] =
    R"({"panel": {"name": "mine", "width": 1920, "height": 1080, "pixel_pitch_mm": 0.25, )"
    R"("subpixels": "bgr", "mirrored": "x"},)"
    R"( "sheet": {"arrangement": "lenticular", "pitch_mm": 1.5, "thickness_mm": 4, "ior": 1.6, "slant_degrees": 9.5,)"
    R"( "offset_mm": [0.25, 0]}, "viewing_distance_mm": 800})";

std::string with(const std::string& old_text, const std::string& new_text)
{
    std::string text = own;
    BOOST_REQUIRE_MESSAGE(text.find(old_text) != std::string::npos, old_text);
    return text.replace(text.find(old_text), old_text.size(), new_text);
}

/// The largest difference between the directions of subpixels by our optics and by the published
/// mapping, as a fraction of the span of all views. Compares some hundred pixels around `place`,
/// which is in fractions of the film's width and height as the viewer sees it. Adds the number of
/// compared subpixels to `of_all`.
double difference_at(const Panel& panel, Vec2 place, int& of_all)
{
    const SheetOptics optics(panel.sheet, panel.aperture);
    const int columns = panel.film.width, rows = panel.film.height;
    const int left = int(place.x * (columns - 40)), top = int(place.y * (rows - 12));
    // The mapping's views fill the micro-images, which are a little wider than the lenses.
    const double zone = panel.aperture.width * mm_per_inch / panel.calibration->pitch /
                        panel.sheet.pitch;
    double worst = 0;
    for (int column = left; column < left + 40; ++column)
        for (int row = top; row < top + 12; ++row)
            for (int channel = 0; channel < 3; ++channel) {
                const Vec2 point = film_from_pixel(
                    panel.film, subpixel_centre(panel.film.subpixels, column, row, channel));
                const MappedPoint mapped = optics.map(point, LensMapping::automatic);
                if (!mapped.ray)
                    continue; // in a dark gap between zones
                ++of_all;
                const double ours = 0.5 + mapped.ray->aperture_point.x / zone;
                double difference = ours - view_of_subpixel(
                                               *panel.calibration,
                                               panel.mirrored_x ? columns - 1 - column : column,
                                               panel.mirrored_y ? rows - 1 - row : row, channel);
                difference -= std::round(difference);
                worst = std::fmax(worst, std::fabs(difference));
            }
    return worst;
}

void check_same(const Panel& a, const Panel& b)
{
    BOOST_TEST(to_json(a) == to_json(b));
    BOOST_TEST(a.sheet.pitch == b.sheet.pitch);
    BOOST_TEST(a.sheet.thickness == b.sheet.thickness);
    BOOST_TEST(a.sheet.slant == b.sheet.slant);
    BOOST_TEST(a.sheet.offset.x == b.sheet.offset.x);
    BOOST_TEST(a.aperture.distance == b.aperture.distance);
    BOOST_TEST(a.aperture.width == b.aperture.width);
    BOOST_TEST(a.film.pixel_pitch.y == b.film.pixel_pitch.y);
    BOOST_TEST(same_layout(a.film.subpixels, b.film.subpixels));
    BOOST_TEST(a.mirrored_x == b.mirrored_x);
    BOOST_TEST(a.mirrored_y == b.mirrored_y);
    BOOST_TEST(a.calibration.has_value() == b.calibration.has_value());
}

} // namespace

BOOST_AUTO_TEST_CASE(reads_descriptions_of_our_own)
{
    const Panel panel = panel_from_json(own);
    BOOST_TEST(panel.name == "mine");
    BOOST_TEST(panel.film.width == 1920);
    BOOST_TEST(panel.film.height == 1080);
    BOOST_TEST(panel.film.pixel_pitch.x == 0.25);
    BOOST_TEST(panel.film.pixel_pitch.y == 0.25);
    BOOST_CHECK(panel.film.subpixels == Subpixels::bgr);
    BOOST_TEST(panel.mirrored_x);
    BOOST_TEST(!panel.mirrored_y);
    BOOST_TEST(panel.sheet.slant == 9.5);
    BOOST_TEST(panel.sheet.offset.x == 0.25);
    BOOST_TEST(panel.aperture.distance == 800);
    BOOST_TEST(panel.aperture.width == filling_aperture(panel.sheet, 800)->width);
    check_same(panel_from_json(to_json(panel)), panel);

    BOOST_TEST(panel_from_json(with("0.25, \"sub", "[0.25, 0.5], \"sub")).film.pixel_pitch.y ==
               0.5);
    BOOST_TEST(panel_from_json(with("\"x\"", "\"xy\"")).mirrored_y);
    BOOST_TEST(!panel_from_json(with("\"x\"", "\"y\"")).mirrored_x);
    // 1920 by 1080 pixels of 0.25 mm have a diagonal of 550.7 mm
    BOOST_TEST(panel_from_json(with(", \"viewing_distance_mm\": 800", "")).aperture.distance ==
                   1376.8125,
               boost::test_tools::tolerance(1e-4));
    // Seen from 800 mm, p (1 + 4/(1.6 800)) is 1.5 mm.
    BOOST_TEST(
        panel_from_json(with("pitch_mm\": 1.5", "micro_image_pitch_mm\": 1.5")).sheet.pitch ==
            1.5 / 1.003125,
        boost::test_tools::tolerance(1e-12));
    const Panel narrow = panel_from_json(
        with("\"viewing_distance_mm\": 800",
             R"("aperture": {"distance_mm": 500, "width_mm": 65, "height_mm": null})"));
    BOOST_TEST(narrow.aperture.distance == 500);
    BOOST_TEST(narrow.aperture.width == 65);
    BOOST_TEST(std::isinf(narrow.aperture.height));
    check_same(panel_from_json(to_json(narrow)), narrow);
}

BOOST_AUTO_TEST_CASE(refuses_by_the_name_of_the_field)
{
    BOOST_TEST(refusal(with("\"name\"", "\"nam\"")) ==
               "panel.nam is not a field of it: those are name, width, height, pixel_pitch_mm, "
               "subpixels and mirrored");
    BOOST_TEST(refusal(with("\"sheet\"", "\"sheets\"")) ==
               "sheets is not a field of it: those are panel, sheet, aperture, "
               "viewing_distance_mm, calibration and ior");
    BOOST_TEST(refusal(with("slant_degrees", "slant")) ==
               "sheet.slant is not a field of it: those are arrangement, pitch_mm, "
               "micro_image_pitch_mm, thickness_mm, ior, slant_degrees and offset_mm");
    BOOST_TEST(refusal(with("\"width\": 1920, ", "")) == "panel.width is missing");
    BOOST_TEST(refusal(with("\"height\": 1080, ", "")) == "panel.height is missing");
    BOOST_TEST(refusal(with("0.25, \"sub", "\"small\", \"sub")) ==
               "panel.pixel_pitch_mm must be a list of 2 numbers");
    BOOST_TEST(refusal(with("\"bgr\"", "\"rbg\"")) ==
               "panel.subpixels must be rgb, bgr, vrgb, vbgr, cells or none");
    BOOST_TEST(refusal(with("\"x\"", "\"z\"")) == "panel.mirrored must be x, y or xy");
    BOOST_TEST(refusal(with("\"ior\": 1.6", "\"ior\": 0.5")).find("ior") != std::string::npos);
    BOOST_TEST(
        refusal(with("\"pitch_mm\": 1.5", "\"pitch_mm\": 1.5, \"micro_image_pitch_mm\": 1.5")) ==
        "sheet.micro_image_pitch_mm cannot stand beside pitch_mm: one follows from the other");
    BOOST_TEST(refusal(with("800}", "800, \"aperture\": {\"distance_mm\": 3}}")) ==
               "viewing_distance_mm cannot stand beside aperture, which has it as distance_mm");
    BOOST_TEST(refusal(with("800}", "800, \"ior\": 1.5}")) == "ior belongs into sheet");
    BOOST_TEST(refusal(with("800}", "0}")) ==
               "viewing_distance_mm is 0, and must be within 0.01 and 1e+09");
    const std::string calibration = file_of(devices()[3], {});
    BOOST_TEST(refusal(with("800}", "800, \"calibration\": " + calibration + "}")) ==
               "calibration is of a display of another size than panel");
    BOOST_TEST(refusal("{\"viewing_distance_mm\": 800, \"calibration\": {\"pitch\": 3}}") ==
               "calibration: holds no calibration: an object with pitch, slope, center, DPI, "
               "screenW and screenH");
    for (const char* const nothing : {"{}", "[]", "\"panel\"", R"({"pannel": {"width": 3}})"})
        BOOST_TEST(
            refusal(nothing) ==
            "holds neither a panel's description: an object with panel, sheet and "
            "viewing_distance_mm, nor a Looking Glass "
            "calibration: an object with pitch, slope, center, DPI, screenW and screenH, nor "
            "a CubeVi one, with lineNumber, obliquity and deviation");
}

BOOST_AUTO_TEST_CASE(malformed_descriptions_are_refused_in_words)
{
    int read = 0, refused = 0;
    const auto try_to_read = [&](const std::string& text) {
        try {
            const Panel panel = panel_from_json(text);
            ++read;
            BOOST_TEST(
                (panel.film.width > 0 && panel.sheet.pitch > 0 && panel.aperture.distance > 0),
                text);
            camera_words(frame_geometry(panel));
        } catch (const std::invalid_argument& error) {
            ++refused;
            BOOST_TEST(std::string(error.what()).size() > 10, text);
        }
    };
    for (const std::string& text : {std::string(own), file_of(devices()[9], {})})
        for (std::size_t at = 0; at < text.size(); ++at) {
            try_to_read(text.substr(0, at));
            for (const char c : std::string("0-9e.,\"{}[]:x\\\xff")) {
                std::string changed = text;
                changed[at] = c;
                try_to_read(changed);
            }
        }
    BOOST_TEST(read > 500);
    BOOST_TEST(refused > 5000);
}

BOOST_AUTO_TEST_CASE(calibrations_become_panels)
{
    // A Looking Glass Portrait: 52 micro-images an inch, lenses that lean by a seventh to the right
    // going up, a view cone of 40 degrees.
    const Panel panel = panel_from_json(
        "{\"viewing_distance_mm\": 600, \"ior\": 1.5, \"calibration\": " +
        file_of(devices()[3], {}) + "}");
    const auto near = boost::test_tools::tolerance(1e-9);
    BOOST_TEST(panel.name == "LKG-looking-glass-portrait");
    BOOST_TEST(panel.film.pixel_pitch.x == 25.4 / 324, near);
    BOOST_TEST(panel.sheet.slant == -std::atan(1 / 7.0) * 180 / std::acos(-1), near);
    BOOST_TEST(panel.sheet.pitch * (1 + panel.sheet.thickness / (1.5 * 600)) == 25.4 / 52, near);
    BOOST_TEST(panel.aperture.width == 2 * 600 * std::tan(20 * std::acos(-1) / 180), near);
    check_same(panel_from_json(to_json(panel)), panel);
    const Panel bare = panel_from_json(file_of(devices()[3], {}));
    BOOST_TEST(bare.sheet.ior == nominal_ior);
    BOOST_TEST(bare.aperture.distance ==
                   nominal_viewing_distance({1536 * 25.4 / 324, 2048 * 25.4 / 324}),
               near);
    // Seen in a mirror, the lenses lean the other way and the order of the colours is reversed.
    const Panel mirror = panel_from_json(file_of(devices()[3], {true, false, false, true}));
    BOOST_TEST(mirror.mirrored_x);
    BOOST_TEST(mirror.sheet.slant == -bare.sheet.slant, near);
    BOOST_CHECK(mirror.film.subpixels == Subpixels::bgr);
    BOOST_TEST(panel_from_json(file_of(devices()[3], {true, true, false, true})).sheet.slant ==
                   bare.sheet.slant,
               near);
}

BOOST_AUTO_TEST_CASE(known_panels_are_what_they_are_made_of)
{
    for (const Device& device : devices()) {
        const auto panel = panel_named(device.name);
        BOOST_REQUIRE_MESSAGE(panel, device.name);
        Panel made = panel_from_json(file_of(device, {}));
        made.name = device.name;
        made.calibration->version = made.calibration->serial = "";
        check_same(made, *panel);
    }
    BOOST_TEST(known_panels().size() == devices().size() + 1);
    for (const Panel& panel : known_panels()) {
        check_same(panel_from_json(to_json(panel)), panel);
        BOOST_TEST(frame_geometry(panel).sheet.pitch == panel.sheet.pitch);
        BOOST_TEST(frame_geometry(panel).film.width == panel.film.width);
    }
    BOOST_TEST(!panel_named("looking-glass"));
    // "Roughly 6 pixels" are behind each of the thesis's lenses, on a display of 10 inches, 212 mm
    // wide.
    const Panel thesis = *panel_named("thesis-lcd");
    BOOST_TEST(std::round(thesis.sheet.pitch / thesis.film.pixel_pitch.x) == 6);
    BOOST_TEST(thesis.film.width * thesis.film.pixel_pitch.x == 211.968,
               boost::test_tools::tolerance(1e-9));
}

// The published mapping is linear over the zone and over the panel, but refraction is not. At the
// middle of the panel they differ by up to 1.3% of the views' span; at a corner, where light leaves
// obliquely, by up to 4.5%. With a cone of one degree and a hundred times the distance, light
// leaves nearly straight ahead, and the difference vanishes.
BOOST_AUTO_TEST_CASE(our_optics_and_the_published_mapping_agree)
{
    double middle = 0, corner = 0, straight = 0;
    int compared = 0;
    for (const Device& device : variants())
        for (int bits = 0; bits < 8; ++bits) {
            const Flips flips{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, true};
            const Panel panel = panel_from_json(file_of(device, flips));
            LookingGlassCalibration calibration = *panel.calibration;
            calibration.view_cone = 1;
            const Panel far = panel_from(calibration, 100 * panel.aperture.distance);
            for (const Vec2 place :
                 {Vec2{0.5, 0.5}, Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}}) {
                double& worst = place.x == 0.5 ? middle : corner;
                worst = std::fmax(worst, difference_at(panel, place, compared));
                straight = std::fmax(straight, difference_at(far, place, compared));
            }
        }
    BOOST_TEST_MESSAGE("views differ by " << middle << " at the middle, " << corner
                                          << " in the corners, " << straight
                                          << " where all is straight");
    BOOST_TEST(compared > int(variants().size()) * 8 * 10 * 40 * 12 * 3 * 9 / 10);
    BOOST_TEST(middle < 0.0135);
    BOOST_TEST(corner < 0.045);
    BOOST_TEST(straight < 1e-5);
}

BOOST_AUTO_TEST_CASE(camera_words_say_all)
{
    BOOST_TEST(camera_words(frame_geometry(*panel_named("thesis-lcd"))) ==
               "lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 } film { pixel_pitch "
               "<0.207, 0.207> subpixels rgb } viewing_distance 300.0");
    Panel panel = panel_from_json(with(
        "\"viewing_distance_mm\": 800",
        R"("aperture": {"distance_mm": 500, "width_mm": 65, "height_mm": 4, "shape": "ellipse"})"));
    panel.film.subpixels.order = Subpixels::cells;
    panel.film.subpixels.pattern = CellPattern::checkerboard;
    panel.film.subpixels.number = 2;
    panel.film.subpixels.cell[0] = {{{-0.25, 0.25}, {0.25, 0.25}, {0, -0.25}}};
    panel.film.subpixels.cell[1] = {{{-0.25, -0.25}, {0.25, -0.25}, {0, 0.25}}};
    BOOST_TEST(camera_words(frame_geometry(panel)) ==
               "lens_sheet { lenticular pitch 1.5 thickness 4.0 ior 1.6 slant 9.5 offset <0.25, "
               "0.0> } film { pixel_pitch <0.25, 0.25> subpixels "
               "cells { checkerboard <-0.25, 0.25> <0.25, 0.25> <0.0, -0.25> <-0.25, -0.25> <0.25, "
               "-0.25> <0.0, 0.25> } } "
               "capture_aperture <65.0, 4.0> aperture_shape ellipse viewing_distance 500.0");
}

/// Integral_Panel_Looking_Glass_16_Landscape of looking-glass-16-landscape.
static std::string macro_of(const Panel& panel)
{
    std::string name = "Integral_Panel";
    bool start = true;
    for (const char c : "-" + panel.name) {
        start = start || c == '-';
        name += c == '-' ? '_' : start ? char(std::toupper(c)) : c;
        start = c == '-';
    }
    return name;
}

/// A file of the project, whole.
static std::string file_of_project(const char* name)
{
    const char* const top = std::getenv("TOP");
    BOOST_REQUIRE_MESSAGE(top, "TOP is not set: run this by tests/run");
    std::ifstream file(std::string(top) + "/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// For every panel, include/integral.inc has a macro and the panel's pixels, width and distance. The
// figures must be the same.
BOOST_AUTO_TEST_CASE(the_include_file_knows_them)
{
    const std::string include = file_of_project("include/integral.inc");
    for (const Panel& panel : known_panels()) {
        const std::string name = macro_of(panel);
        std::ostringstream figures;
        figures.precision(6);
        figures << "#declare " << name << "_Pixels = <" << panel.film.width << ", "
                << panel.film.height << ">;\n#declare " << name
                << "_Width = " << panel.film.width * panel.film.pixel_pitch.x << ";\n#declare "
                << name << "_Distance = " << panel.aperture.distance << ";\n";
        const std::string expected = "#macro " + name + "() " +
                                     camera_words(frame_geometry(panel)) + " #end\n" +
                                     figures.str();
        BOOST_TEST(include.find(expected) != std::string::npos, "include/integral.inc lacks\n"
                                                                    << expected);
    }
}

BOOST_AUTO_TEST_CASE(the_guide_describes_one)
{
    const std::string guide = file_of_project("doc/panels.md");
    const auto start = guide.find("{\"panel\"");
    BOOST_REQUIRE(start != std::string::npos);
    const Panel panel = panel_from_json(guide.substr(start, guide.find("```", start) - start));
    BOOST_TEST(panel.name == "mine");
    BOOST_TEST(panel.sheet.slant == 9.46);
    BOOST_TEST(panel.aperture.distance == 800);
}

BOOST_AUTO_TEST_SUITE_END()
