// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests calibration files, with every field in every form, and compares the mapping with the
// published formula in single precision.
#include "integral/sheet/panel.h"

#include "tests/unit/looking_glass_devices.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace integral;
using namespace looking_glass_devices;

BOOST_AUTO_TEST_SUITE(sheet_looking_glass)

namespace {

LookingGlassCalibration calibration_in(const std::string& text)
{
    return looking_glass_from_json(parse_json(text));
}

/// The message with which a file is refused; "" if it is not.
std::string refusal(const std::string& text)
{
    try {
        calibration_in(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

void check_equal(const LookingGlassCalibration& a, const LookingGlassCalibration& b)
{
    BOOST_TEST(a.version == b.version);
    BOOST_TEST(a.serial == b.serial);
    for (const auto field : {&LookingGlassCalibration::pitch, &LookingGlassCalibration::slope,
                             &LookingGlassCalibration::center, &LookingGlassCalibration::view_cone,
                             &LookingGlassCalibration::vertical_angle,
                             &LookingGlassCalibration::fringe, &LookingGlassCalibration::dpi})
        BOOST_TEST((a.*field) == (b.*field));
    BOOST_TEST(a.width == b.width);
    BOOST_TEST(a.height == b.height);
    for (const auto field :
         {&LookingGlassCalibration::inverted_views, &LookingGlassCalibration::flip_x,
          &LookingGlassCalibration::flip_y, &LookingGlassCalibration::flip_subpixels})
        BOOST_TEST((a.*field) == (b.*field));
    BOOST_TEST(same_layout(a.cells, b.cells));
}

/// The published formula for a colour of a pixel, evaluated as a shader does: in single precision,
/// with rows counted from the bottom. Flips are taken from the maker's shader for Unity, which
/// replaces x by 1 - x and negates tilt and subpixel step. The formula does not use invView.
float shader_view(const Device& device, const Flips& flips, int column, int row, int channel)
{
    const float w = device.width, h = device.height;
    float x = (column + 0.5f) / w, y = (row + 0.5f) / h;
    const int cells = int(device.cells.size());
    if (cells > 0) {
        int cell = 0;
        if (device.mode == 1)
            cell = column % 2 == row % 2 ? 0 : 1;
        else if (device.mode == 2)
            cell = column % 2;
        else if (device.mode == 3)
            cell = (row + 2 * (column % 2)) % 4;
        else if (device.mode == 4)
            cell = row % 2;
        const auto& places = device.cells[cell % cells];
        x += float(places[2 * channel]) / w;
        y += float(places[2 * channel + 1]) / h;
    }
    float step = cells > 0 ? 0 : 1 / (3 * w), tilt = h / (w * float(device.slope));
    if (flips.subpixels)
        step = -step;
    if (flips.x) {
        x = 1 - x;
        tilt = -tilt;
        step = -step;
    }
    const float pitch = float(device.pitch) * w / float(device.dpi) *
                        std::cos(std::atan(1 / float(device.slope)));
    const float phase = (x + channel * step + y * tilt) * pitch - float(device.center);
    const float fraction = phase - std::floor(phase);
    return 1 - fraction;
}

} // namespace

BOOST_AUTO_TEST_CASE(reads_every_field)
{
    const char plain[] =
        R"({"configVersion": "3.0", "serial": "LKG-X1", "pitch": 44.5, "slope": -6.9, "center": 0.25,
        "fringe": 0.5, "viewCone": 51, "invView": 0, "verticalAngle": 3, "DPI": 283, "screenW": 2160, "screenH": 3840,
        "flipImageX": 1, "flipImageY": 1, "flipSubp": 1, "somethingNew": 7})";
    const LookingGlassCalibration calibration = calibration_in(plain);
    BOOST_TEST(calibration.version == "3.0");
    BOOST_TEST(calibration.serial == "LKG-X1");
    BOOST_TEST(calibration.pitch == 44.5);
    BOOST_TEST(calibration.slope == -6.9);
    BOOST_TEST(calibration.center == 0.25);
    BOOST_TEST(calibration.fringe == 0.5);
    BOOST_TEST(calibration.view_cone == 51);
    BOOST_TEST(!calibration.inverted_views);
    BOOST_TEST(calibration.vertical_angle == 3);
    BOOST_TEST(calibration.dpi == 283);
    BOOST_TEST(calibration.width == 2160);
    BOOST_TEST(calibration.height == 3840);
    BOOST_TEST(calibration.flip_x);
    BOOST_TEST(calibration.flip_y);
    BOOST_TEST(calibration.flip_subpixels);
    BOOST_CHECK(calibration.cells == Subpixels::none);

    const char nested[] =
        R"({"configVersion": "3.0", "serial": "LKG-X1", "pitch": {"value": 44.5}, "slope": {"value": -6.9},
        "center": {"value": 0.25}, "fringe": {"value": 0.5}, "viewCone": {"value": 51}, "invView": {"value": 0.0},
        "verticalAngle": {"value": 3}, "DPI": {"value": 283.0},
        "screenW": {"value": 2160.0}, "screenH": {"value": 3840.0},
        "flipImageX": {"value": 1.0}, "flipImageY": {"value": 1.0}, "flipSubp": {"value": 1}, "subpixelCells": []})";
    check_equal(calibration_in(nested), calibration);

    // The calibration inside the document that the maker's programs write.
    const std::string text = nested;
    check_equal(
        calibration_in(
            R"({"version": "2.3", "devices": [{"hwid": "LKG-X1", "index": 0, "calibration": )" +
            text + R"(, "defaultQuilt": {"tileX": 8, "tileY": 6}}]})"),
        calibration);
    std::string quoted;
    for (const char c : text)
        quoted += c == '"' ? std::string("\\\"") : c == '\n' ? std::string(" ") : std::string(1, c);
    check_equal(
        calibration_in(
            R"({"name": "available_output_devices", "payload": {"value": {"0": {"type": "VARIANT_MAP", "value":
        {"calibration": {"name": "calibration", "type": "WSTRING", "value": ")" +
            quoted + R"("}, "hwid": {"value": "LKG-X1"}}},
        "1": {"value": {"calibration": {"value": ""}}}}}})"),
        calibration);
}

BOOST_AUTO_TEST_CASE(fields_that_older_files_lack)
{
    const LookingGlassCalibration calibration = calibration_in(
        R"({"pitch": 49.8, "slope": 5.4, "center": 0, "DPI": 338, "screenW": 2560, )"
        R"("screenH": 1600, "viewCone": null})");
    check_equal(calibration, [] {
        LookingGlassCalibration expected;
        expected.pitch = 49.8, expected.slope = 5.4, expected.dpi = 338, expected.width = 2560,
        expected.height = 1600;
        return expected;
    }());
    BOOST_TEST(calibration.view_cone == 40);
    BOOST_TEST(calibration.inverted_views);
}

BOOST_AUTO_TEST_CASE(what_a_file_should_say_and_does_not_is_told)
{
    const auto told = [](const std::string& more) {
        std::string all;
        const std::string file =
            R"({"pitch": 49.8, "slope": 5.4, "center": 0, "DPI": 338, "screenW": 2560, "screenH": 1600)" +
            more + "}";
        for (const std::string& what : calibration_in(file).assumed)
            all += what + "\n";
        return all;
    };
    const std::string
        cone = R"(, "viewCone": 40)",
        cell =
            R"({"ROffsetX": 0, "ROffsetY": 0.25, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0})";
    const std::string one = cone + R"(, "subpixelCells": [)" + cell + "]",
                      two = cone + R"(, "subpixelCells": [)" + cell + ", " + cell + "]";
    for (const Device& device : variants())
        BOOST_TEST(calibration_in(file_of(device, {})).assumed.empty(), device.name);
    BOOST_TEST(told(cone + R"(, "flipImageY": 1, "invView": 1)") == "");
    BOOST_TEST(
        told(cone + R"(, "flipSubp": 1)").find("flipSubp is 1, as in no published calibration") ==
        0);
    BOOST_TEST(told(cone + R"(, "flipImageX": {"value": 1.0})")
                   .find("flipImageX is 1, as in no published calibration") == 0);
    BOOST_TEST(told(cone) == "");
    BOOST_TEST(
        told("") ==
        "viewCone is missing: 40 degrees are taken, and the viewing zone follows from them\n");
    BOOST_TEST(told(cone + R"(, "CellPatternMode": 0, "subpixelCells": [])") == "");
    for (const char* const without : {"", R"(, "subpixelCells": [])", R"(, "subpixelCells": null)"})
        BOOST_TEST(told(cone + R"(, "CellPatternMode": {"value": 4})" + without) ==
                   "CellPatternMode is 4, but there are no subpixelCells: stripes of red, green "
                   "and blue are taken\n");
    BOOST_TEST(told(one) == "");
    BOOST_TEST(
        told(two) ==
        "CellPatternMode is missing: every pixel is taken to be as the first of subpixelCells\n");
    BOOST_TEST(told(two + R"(, "CellPatternMode": 1)") == "");
}

BOOST_AUTO_TEST_CASE(refuses_by_the_name_of_the_field)
{
    const std::string whole = file_of(devices()[8], {});
    BOOST_TEST(refusal(whole) == "");
    const auto with = [&](const std::string& old_text, const std::string& new_text) {
        std::string text = whole;
        BOOST_REQUIRE_MESSAGE(text.find(old_text) != std::string::npos, old_text);
        return text.replace(text.find(old_text), old_text.size(), new_text);
    };
    BOOST_TEST(refusal("{") ==
               "line 1: this is no JSON: unexpected end of input; expected string literal");
    BOOST_TEST(
        refusal(R"({"panel": 1})") ==
        "holds no calibration: an object with pitch, slope, center, DPI, screenW and screenH");
    BOOST_TEST(refusal("[" + whole + "," + with("\"LKG", "\"XKG") + "]") ==
               "holds the calibrations of 2 displays; leave one");
    BOOST_TEST(refusal("[" + whole + "," + whole + "]") == "");
    std::string many;
    for (int k = 0; k < 1000; ++k)
        many += (k == 0 ? "" : ",") + std::string("{\"pitch\":") + std::to_string(k) +
                ",\"slope\":2}";
    BOOST_TEST(refusal("[" + many + "]") ==
               "holds the calibrations of more than 16 displays; leave one");
    const std::string deep = std::string(60000, '[') + "{}" + std::string(60000, ']');
    BOOST_TEST(refusal("[" + deep + "]") ==
               "line 1: objects and lists are nested more than 64 deep; nest them less");
    // A string that is no JSON document is taken as an ordinary string.
    BOOST_TEST(refusal("[\"" + deep + "\"]") == refusal("[]"));
    BOOST_TEST(refusal(with("\"center\"", "\"centre\"")) == "center is missing");
    BOOST_TEST(refusal(with("\"DPI\": {\"value\"", "\"DPI\": {\"worth\"")) ==
               "DPI.value is missing");
    BOOST_TEST(refusal(with("\"screenW\": {\"value\": 2160", "\"screenW\": {\"value\": 2160.5")) ==
               "screenW must be a whole number");
    BOOST_TEST(
        refusal(with("\"screenW\": {\"value\": 2160", "\"screenW\": {\"value\": \"wide\"")) ==
        "screenW.value must be a number");
    BOOST_TEST(refusal(with("\"slope\": {\"value\": -7.45", "\"slope\": {\"value\": 0")) ==
               "slope is too near to 0, which would be lenses that lie level");
    BOOST_TEST(refusal(with("\"pitch\": {\"value\": 44.72", "\"pitch\": {\"value\": -1")) ==
               "pitch.value is -1, and must be within 0.001 and 10000");
    BOOST_TEST(
        refusal(with("\"CellPatternMode\": {\"value\": 4", "\"CellPatternMode\": {\"value\": 5")) ==
        "CellPatternMode.value is 5, and must be within 0 and 4");
    BOOST_TEST(refusal(with("\"GOffsetY\": 0.28", "\"GOffset\": 0.28")) ==
               "subpixelCells[0].GOffsetY is missing");
    BOOST_TEST(refusal(with("\"flipImageX\": {\"value\": 0", "\"flipImageX\": {\"value\": 2")) ==
               "flipImageX.value is 2, and must be within 0 and 1");
}

BOOST_AUTO_TEST_CASE(inv_view_is_told_and_changes_nothing)
{
    // LKG-J00133, a display of the third generation, has invView 0, which the maker's shaders
    // ignore.
    for (const Device& device : devices()) {
        const LookingGlassCalibration plain = calibration_in(file_of(device, {})),
                                      with_0 = calibration_in(
                                          file_of(device, {false, false, false, false}));
        BOOST_TEST(!with_0.inverted_views);
        BOOST_REQUIRE(with_0.assumed.size() == 1u);
        BOOST_TEST(with_0.assumed.front() == "invView is 0: the makers' shaders do not read it, "
                                             "and views are taken as if it were 1");
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 64; ++column)
                for (int channel = 0; channel < 3; ++channel)
                    BOOST_TEST(view_of_subpixel(with_0, column, row, channel) ==
                               view_of_subpixel(plain, column, row, channel));
        const Panel panel = panel_from(with_0, 600.0);
        BOOST_TEST(panel.sheet.offset.x == panel_from(plain, 600.0).sheet.offset.x);
    }
}

BOOST_AUTO_TEST_CASE(hand_values)
{
    // Two vertical micro-images across the picture: at 1/20 of its width, the phase is 1/10.
    LookingGlassCalibration calibration;
    calibration.pitch = 2, calibration.slope = 1e9, calibration.dpi = 10,
    calibration.width = calibration.height = 10;
    const auto near = boost::test_tools::tolerance(1e-7);
    BOOST_TEST(view_of_subpixel(calibration, 0, 0, 0) == 0.9, near);
    BOOST_TEST(view_of_subpixel(calibration, 0, 9, 0) == 0.9, near);
    BOOST_TEST(view_of_subpixel(calibration, 2, 0, 1) == 1 - 17 / 30.0, near);
    BOOST_TEST(view_of_subpixel(calibration, 2, 0, 2) == 1 - 19 / 30.0, near);
    BOOST_TEST(view_of_subpixel(calibration, 5, 0, 0) == 0.9, near);
    calibration.center = 0.3;
    BOOST_TEST(view_of_subpixel(calibration, 0, 0, 0) == 0.2, near);
    calibration.center = 0;
    calibration.flip_x = true;
    BOOST_TEST(view_of_subpixel(calibration, 0, 0, 0) == 0.1, near);
    BOOST_TEST(view_of_subpixel(calibration, 2, 0, 1) == 17 / 30.0, near);
    calibration = {};
    calibration.pitch = 2, calibration.slope = 1, calibration.dpi = 10,
    calibration.width = calibration.height = 10;
    BOOST_TEST(view_of_subpixel(calibration, 0, 9, 0) == 1 - 0.1 * std::sqrt(2), near);
    BOOST_TEST(view_of_subpixel(calibration, 0, 0, 0) == 2 - std::sqrt(2), near);
    calibration.flip_y = true;
    BOOST_TEST(view_of_subpixel(calibration, 0, 0, 0) == 2 - std::sqrt(2), near);
    // A pixel whose green is a quarter to the left and half a pixel up
    calibration.cells.order = Subpixels::cells;
    calibration.cells.number = 1;
    calibration.cells.cell[0][1] = {-0.25, 0.5};
    BOOST_TEST(view_of_subpixel(calibration, 3, 8, 1) == 1 - (0.325 + 0.2) * std::sqrt(2), near);
    // View 0 and view 1 have the same position, the rightmost.
    calibration = {};
    calibration.pitch = 1, calibration.slope = 1e9, calibration.dpi = 1,
    calibration.width = calibration.height = 2, calibration.center = 0.5;
    const double last = view_of_subpixel(calibration, 0, 1, 0);
    BOOST_TEST(last < 1);
    BOOST_TEST(last > 0.999999);
}

BOOST_AUTO_TEST_CASE(agrees_with_the_shader)
{
    std::mt19937 random(5);
    double worst = 0;
    for (const Device& device : variants())
        for (int bits = 0; bits < 16; ++bits) {
            const Flips flips{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
            const LookingGlassCalibration calibration = calibration_in(file_of(device, flips));
            check_equal(looking_glass_from_json(json_of(calibration)), calibration);
            // The rounding error of the phase in single precision: its largest part is pitch
            // (u + v tilt), with about eight roundings.
            const double phases = device.pitch * device.width / device.dpi *
                                  (1 +
                                   2 * std::fabs(device.height / (device.width * device.slope)));
            const double bound = 8 * std::ldexp(phases + std::fabs(device.center), -24) + 1e-6;
            for (int k = 0; k < 400; ++k) {
                const int column = int(random() % device.width),
                          row = int(random() % device.height), channel = int(random() % 3);
                const double view = view_of_subpixel(calibration, column, row, channel);
                double difference = view - shader_view(device, flips, column,
                                                       device.height - 1 - row, channel);
                difference -= std::round(difference);
                worst = std::fmax(worst, std::fabs(difference) / bound);
                BOOST_TEST(std::fabs(difference) <= bound, device.name << " " << column << " "
                                                                       << row << " " << channel
                                                                       << ": " << difference);
                BOOST_TEST((view >= 0 && view < 1));
            }
        }
    BOOST_TEST_MESSAGE("largest difference: " << worst << " of what single precision allows");
}

BOOST_AUTO_TEST_CASE(layouts_in_a_mirror)
{
    std::mt19937 random(6);
    const auto place = [&] { return double(random() % 2001) / 1000 - 1; };
    for (const auto order : {Subpixels::none, Subpixels::rgb, Subpixels::bgr, Subpixels::vrgb,
                             Subpixels::vbgr, Subpixels::cells})
        for (int pattern = 0; pattern < (order == Subpixels::cells ? 5 : 1); ++pattern)
            for (int number = 1; number <= 4; ++number)
                for (int size = 0; size < 16; ++size)
                    for (int axes = 0; axes < 4; ++axes) {
                        const int width = 8 + (size & 3), height = 8 + (size >> 2);
                        const bool x = axes & 1, y = axes & 2;
                        Subpixels layout;
                        layout.order = order;
                        if (order == Subpixels::cells) {
                            layout.pattern = CellPattern(pattern);
                            layout.number = number;
                            for (PixelCell& cell : layout.cell)
                                cell = {
                                    {{place(), place()}, {place(), place()}, {place(), place()}}};
                        }
                        const Subpixels mirror = mirrored(layout, width, height, x, y);
                        for (int column = 0; column < width; ++column)
                            for (int row = 0; row < height; ++row)
                                for (int channel = 0; channel < 3; ++channel) {
                                    const Vec2 there = subpixel_centre(layout, column, row,
                                                                       channel);
                                    const Vec2 here = subpixel_centre(
                                        mirror, x ? width - 1 - column : column,
                                        y ? height - 1 - row : row, channel);
                                    BOOST_TEST(std::fabs((x ? width - here.x : here.x) - there.x) <
                                               1e-12);
                                    BOOST_TEST(std::fabs((y ? height - here.y : here.y) - there.y) <
                                               1e-12);
                                }
                    }
}

BOOST_AUTO_TEST_SUITE_END()
