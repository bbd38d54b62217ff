// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the quilts for panels: recommended ones, their sizes, and sizes given by hand.
#include "integral/sheet/panel_render.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(sheet_panel_quilt)

namespace {

void check_quilt(const PanelQuilt& quilt, ViewGrid tiles, int width, int height)
{
    BOOST_TEST(quilt.tiles.columns == tiles.columns);
    BOOST_TEST(quilt.tiles.rows == tiles.rows);
    BOOST_TEST(quilt.width == width);
    BOOST_TEST(quilt.height == height);
}

std::string refusal(const PanelRequest& request)
{
    try {
        panel_render(request);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(the_views_in_a_text)
{
    BOOST_TEST(views_in("8x6")->columns == 8);
    BOOST_TEST(views_in("256x1")->columns == 256);
    for (const char* text : {"", "8", "8x", "x6", "0x6", "8x257", "8x6a", "8x6 ", "good"})
        BOOST_TEST(!views_in(text), text);
}

BOOST_AUTO_TEST_CASE(sizes_of_quilts)
{
    const Panel go = *panel_named("looking-glass-go");
    // Tiles of 4092/11 = 372 and 4092/6 = 682 pixels; a quarter of 682 is 170.5.
    check_quilt(quilt_for(go), {11, 6}, 4092, 4092);
    check_quilt(quilt_for(go, {}, QuiltSize::good), {11, 6}, 11 * 186, 6 * 341);
    check_quilt(quilt_for(go, {}, QuiltSize::draft), {11, 6}, 11 * 93, 6 * 171);
    // Of two recommended quilts the newest comes first; a grid chooses the other.
    const Panel landscape = *panel_named("looking-glass-16-landscape");
    check_quilt(quilt_for(landscape), {8, 6}, 7680, 4320);
    check_quilt(quilt_for(landscape, ViewGrid{7, 7}), {7, 7}, 5999, 5999);
    // A display whose name is its serial number is known by its pixels.
    Panel own = landscape;
    own.name = "LKG-P12345";
    check_quilt(quilt_for(own), {8, 6}, 7680, 4320);
    check_quilt(quilt_for(own, ViewGrid{7, 7}), {7, 7}, 5999, 5999);
    // Another panel: 4.5 x 1024 x 768 pixels in tiles of the panel's shape, 768 x 576.
    check_quilt(quilt_for(*panel_named("thesis-lcd"), ViewGrid{4, 2}), {4, 2}, 3072, 1152);
}

BOOST_AUTO_TEST_CASE(a_display_reports_its_quilt)
{
    // As Looking Glass Bridge reports a display: the quilt is text next to the calibration.
    const std::string calibration =
        R"({"pitch": 44.72, "slope": -6.9, "center": 0.5, "viewCone": 50, "DPI": 283, )"
        R"("screenW": 3840, "screenH": 2160})";
    const auto document = [&](const std::string& quilt) {
        return R"({"devices": [{"calibration": )" + calibration + R"(, "defaultQuilt": )" + quilt +
               "}]}";
    };
    const Panel panel = panel_from_json(document(
        R"("{\"quiltAspect\":1.77778,\"quiltX\":6000,\"quiltY\":4000,\"tileX\":9,\"tileY\":5}")"));
    check_quilt(quilt_for(panel), {9, 5}, 6000, 4000);
    check_quilt(quilt_for(panel, ViewGrid{7, 7}), {7, 7}, 5999, 5999); // by its pixels
    check_quilt(quilt_for(panel_from_json(to_json(panel))), {9, 5}, 6000, 4000);
    BOOST_CHECK_THROW(
        panel_from_json(document(R"({"quiltX": 6000, "quiltY": 4000, "tileX": 0, "tileY": 5})")),
        std::invalid_argument);
    check_quilt(quilt_for(panel_from_json(document("null"))), {8, 6}, 7680, 4320);
}

BOOST_AUTO_TEST_CASE(a_quilt_s_window_is_the_panel)
{
    const PanelRender render = panel_render(*panel_named("thesis-lcd"),
                                            PanelQuilt{{4, 2}, 400, 200});
    // 1024 x 768 pixels of 0.207 mm
    BOOST_TEST(render.camera.find("film { pixel_pitch <211.968/image_width, "
                                  "158.976/image_height> }") != std::string::npos,
               render.camera);
    BOOST_TEST(ini_text(render).find("Width=400\nHeight=200\nIntegral_Camera=\"lens_sheet {") == 0);
    BOOST_TEST(ini_text(render).find("\nIntegral_Quilt=4x2\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(given_sizes)
{
    const auto size = [](const std::string& quilt, std::optional<int> width,
                         std::optional<int> height) {
        return panel_render({"looking-glass-go", quilt, width, height}).size;
    };
    BOOST_TEST(size("", {}, {}).width == 1440);
    BOOST_TEST(size("", 1440, {}).height == 2560);
    BOOST_TEST(size("best", {}, {}).width == 4092);
    // A tile of 1100/11 = 100 pixels is 100 x 682/372 = 183.3 high.
    BOOST_TEST(size("11x6", 1100, {}).height == 6 * 183);
    BOOST_TEST(size("11x6", {}, 6 * 183).width == 11 * 100);
    BOOST_TEST(size("11x6", 1100, 6 * 183).height == 6 * 183);
    BOOST_TEST(size("11x6", 1100, 6 * 178).height == 6 * 178); // square pixels: 0.5625
    BOOST_TEST(refusal({"looking-glass-go", "11x6", 1100, 6 * 140})
                   .find("leave +W and +H out for 4092x4092, or give +W1100 +H1098") !=
               std::string::npos);
    BOOST_TEST(refusal({"looking-glass-go", "11x6", 5, {}}).find("views of 0x") !=
               std::string::npos);
    BOOST_TEST(refusal({"looking-glass-go", "", 1440, 1440}).find("1440x2560") !=
               std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
