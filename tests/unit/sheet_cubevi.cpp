// SPDX-License-Identifier: AGPL-3.0-or-later
// CubeVi's calibrations: files, and the mapping of every subpixel against the published formula.
#include "integral/sheet/cubevi.h"
#include "integral/panel/interlace.h"
#include "integral/sheet/panel.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(sheet_cubevi)

namespace {

/// The published formula, from the maker's Blender shader, in long double: the position of a
/// subpixel's tile as a fraction of the range of views; 0 is the rightmost view.
long double published(const CubeViCalibration& c, int column, int row, int colour)
{
    const long double x = column + 1, y = row + 1;
    const long double at = (x + y * c.obliquity) * 3 + colour + c.deviation;
    return (at - std::floor(at / c.line_number) * c.line_number) / c.line_number;
}

/// The C1, an upright panel of the 27 inch kind, lenses without slant, and odd sizes.
const std::vector<CubeViCalibration> displays{{},
                                              {7.538, -0.133632, 18, 3840, 2160, 163, 30},
                                              {19.5, 0, -3.25, 301, 77, 400, 40},
                                              {5.01, 0.9, 1e5, 64, 64, 100, 20}};

std::optional<LookingGlassCalibration> read(const std::string& text)
{
    return cubevi_from_json(parse_json(text));
}

std::string refusal(const std::string& text)
{
    try {
        read(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(every_subpixel_is_where_the_published_formula_has_it)
{
    for (const CubeViCalibration& display : displays) {
        const PanelMapping mapping = mapping_of(looking_glass_from(display));
        BOOST_REQUIRE(mapping.width == display.width && mapping.height == display.height);
        double worst = 0;
        for (int row = 0; row < display.height; ++row) {
            const PhaseRow phases = mapping.across.row(row);
            for (int i = 0; i < 3 * display.width; ++i) {
                const double from_left = phases[i] / 4294967296.0;
                const double off = from_left + double(published(display, i / 3, row, i % 3));
                worst = std::max(worst, std::fabs(off - std::round(off)));
            }
        }
        // For upright lenses the slope is 1e9, where it should be infinite.
        BOOST_TEST(worst < (display.obliquity == 0 ? 1e-7 : 4e-9), "off by " << worst);
    }
}

BOOST_AUTO_TEST_CASE(every_subpixel_shows_the_published_tile)
{
    constexpr int views = 40;
    std::vector<Image> pictures;
    for (int view = 0; view < views; ++view) {
        pictures.push_back(make_image<std::uint8_t>(2, 3, 3, Encoding()));
        for (std::uint8_t& sample : std::get<std::vector<std::uint8_t>>(pictures.back().samples))
            sample = std::uint8_t(6 * view);
    }
    const ViewRaster quilt(pictures, {8, 5});
    for (const CubeViCalibration& display : displays) {
        Image image = panel_image(quilt, display.width, display.height);
        interlace(image, quilt, mapping_of(looking_glass_from(display)),
                  {Neighbours::nearest, Neighbours::nearest}, 1);
        const auto& samples = std::get<std::vector<std::uint8_t>>(image.samples);
        long long wrong = 0, at_an_edge = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const int column = int(i / 3 % display.width), row = int(i / 3 / display.width);
            const long double place = views * published(display, column, row, int(i % 3));
            if (std::fabs(place - std::round(place)) < 1e-5)
                ++at_an_edge;
            else if (samples[i] != 6 * (views - 1 - int(place)))
                ++wrong;
        }
        BOOST_TEST(wrong == 0);
        BOOST_TEST(at_an_edge < (display.obliquity == 0 ? 0.2 : 5e-3) * samples.size());
    }
}

BOOST_AUTO_TEST_CASE(reads_its_files)
{
    const auto plain = read(R"({"lineNumber": 7.5, "obliquity": -0.1, "deviation": 18,
        "screenW": 3840, "screenH": 2160, "DPI": 163, "viewCone": 30, "deviceNumber": "C27-1"})");
    BOOST_REQUIRE(plain);
    BOOST_TEST(plain->serial == "C27-1");
    BOOST_TEST(plain->assumed.empty());
    BOOST_TEST(plain->width == 3840);
    BOOST_TEST(plain->view_cone == 30);
    BOOST_TEST(plain->slope == 10);

    const auto wrapped = read(R"({"type": "device", "config": {"deviation": 16.25578, "lineNumber":
        19.6401, "obliquity": 0.10516, "deviceId": "x"}, "hardwareSN": "7"})");
    BOOST_REQUIRE(wrapped);
    const LookingGlassCalibration c1 = looking_glass_from(CubeViCalibration());
    BOOST_TEST(wrapped->pitch == c1.pitch);
    BOOST_TEST(wrapped->center == c1.center);
    BOOST_REQUIRE(wrapped->assumed.size() == 1);
    BOOST_TEST(wrapped->assumed[0].find("it has no screenW, screenH, DPI, viewCone") == 0);

    BOOST_TEST(!read(R"({"pitch": 50, "slope": -7})"));
    BOOST_TEST(refusal(R"({"config": "U2FsdGVkX19abc"})").find("config is encrypted") == 0);
    BOOST_TEST(refusal(R"({"lineNumber": 0, "obliquity": 0, "deviation": 0})").find("lineNumber") ==
               0);
    BOOST_TEST(refusal(R"({"lineNumber": 9, "obliquity": 0})").find("deviation") == 0);
    BOOST_TEST(refusal(R"([{"lineNumber": 9, "obliquity": 0, "deviation": 0}, {"lineNumber": 9,
        "obliquity": 0, "deviation": 1}])")
                   .find("holds 2 calibrations") == 0);
}

BOOST_AUTO_TEST_CASE(a_panel_is_made_of_it)
{
    const Panel panel = panel_from_json(
        R"({"lineNumber": 19.6401, "obliquity": 0.10516, "deviation": 16.25578})");
    BOOST_TEST(panel.film.width == 1440);
    BOOST_TEST(panel.sheet.slant == -std::atan(0.10516) * 180 / std::acos(-1.0),
               boost::test_tools::tolerance(1e-12));
    // Across the rows a lens's micro-image is lineNumber subpixels wide.
    const double across = 19.6401 / 3 * 25.4 / 515 / std::hypot(1, 0.10516);
    const double shrunk = 1 + panel.sheet.thickness / (panel.sheet.ior * panel.aperture.distance);
    BOOST_TEST(panel.sheet.pitch * shrunk == across, boost::test_tools::tolerance(1e-9));
    const Panel again = panel_from_json(to_json(panel));
    BOOST_TEST(to_json(again) == to_json(panel));
}

BOOST_AUTO_TEST_SUITE_END()
