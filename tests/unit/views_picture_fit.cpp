// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that a picture of a disc stays round on panels and films of other shapes.
#include "integral/frame/picture_fit.h"
#include "integral/frame/quilt_name.h"
#include "integral/panel/interlace.h"
#include "integral/replay/fit_part.h"
#include "integral/views/perspective_views.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace integral;

BOOST_AUTO_TEST_SUITE(views_picture_fit)

namespace {

/// A white disc in the middle of a grey picture, its diameter two thirds of the picture's height as
/// it is seen in that shape.
Image disc(int width, int height, double shape)
{
    Image image = make_image<std::uint8_t>(width, height, 3, {});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double across = ((x + 0.5) / width - 0.5) * shape,
                         down = (y + 0.5) / height - 0.5;
            const float light = std::hypot(across, down) < 1 / 3.0 ? 1 : 0.25f;
            store_pixel(image, x, y, {light, light, light, 1});
        }
    return image;
}

/// Width and height of the area brighter than a limit, in pixels.
Vec2 extent(const Image& image, float limit)
{
    int left = image.width, right = -1, top = image.height, bottom = -1;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (stored_pixel(image, x, y).g > limit) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    return {double(right - left + 1), double(bottom - top + 1)};
}

/// A picture of the shape 1.5 on a target of 120 x 180 pixels, whose shape is 2/3.
struct Case {
    Fit fit;
    Vec2 disc, picture; ///< pixels of the target that they take
};
const Case cases[] = {{Fit::contain, {160 / 3.0, 160 / 3.0}, {120, 80}},
                      {Fit::cover, {120, 120}, {120, 180}},
                      {Fit::stretch, {160 / 3.0, 120}, {120, 180}}};

void check(const Image& image, const Case& c, double within)
{
    const Vec2 lit = extent(image, 0.6f), all = extent(image, 0.1f);
    BOOST_TEST_MESSAGE("disc " << lit.x << " x " << lit.y << ", picture " << all.x << " x "
                               << all.y);
    BOOST_TEST(std::fabs(lit.x - c.disc.x) <= within);
    BOOST_TEST(std::fabs(lit.y - c.disc.y) <= within);
    BOOST_TEST(std::fabs(all.x - c.picture.x) <= within);
    BOOST_TEST(std::fabs(all.y - c.picture.y) <= within);
}

constexpr int width = 120, height = 180;

} // namespace

BOOST_AUTO_TEST_CASE(a_disc_stays_round_on_a_calibrated_panel)
{
    for (const bool flip : {false, true})
        for (const Case& c : cases) {
            LookingGlassCalibration display;
            display.pitch = 52.58;
            display.slope = -7.162;
            display.dpi = 283;
            display.width = width;
            display.height = height;
            display.flip_x = flip;
            const std::vector<Image> views(5, disc(90, 90, 1.5)); // pixels that are not square
            const ViewRaster raster(views, {5, 1});
            Image panel = panel_image(raster, width, height);
            // An earlier image's remains in the bars are cleared.
            std::get<0>(panel.samples).assign(std::size_t(width) * height * 3, 255);
            interlace(panel, raster,
                      mapping_of(display, fitted(1.5, double(width) / height, c.fit)));
            check(panel, c, 3);
        }
}

BOOST_AUTO_TEST_CASE(a_disc_stays_round_behind_lenses)
{
    for (const Arrangement lenses : {Arrangement::lenticular, Arrangement::square})
        for (const Case& c : cases) {
            FrameMetadata m;
            m.sheet = {lenses, 0.6, 2, 1.5, lenses == Arrangement::square ? 0.0 : 8.0, {}};
            m.film = {width, height, {0.2, 0.2}};
            m.aperture = *filling_aperture(m.sheet, 300);
            const EyeGrid eyes{{m.aperture.width, m.aperture.height}, 300};
            const ViewGrid grid{3, lenses == Arrangement::square ? 3 : 1};
            const std::vector<Image> views(std::size_t(grid.count()), disc(90, 60, 1.5));
            const FittedPicture picture = fitted(1.5, shape_of(m.film), c.fit);
            const ViewRaster raster(views, grid);
            Image panel = panel_image(raster, width, height);
            interlace(panel, raster, *mapping_of(m, eyes, 1, {}, picture));
            check(panel, c, 7); // two lenses are 6 pixels wide
            const auto frame = frame_from_eye_views(views, m, grid, eyes, 1, {}, picture);
            BOOST_REQUIRE(frame);
            check(*frame, c, 7);
        }
}

BOOST_AUTO_TEST_CASE(a_view_shows_the_part_of_the_sheet_that_has_its_shape)
{
    FrameMetadata m;
    m.film = {300, 200, {0.1, 0.2}}; // 30 x 40 mm
    View view;
    BOOST_CHECK(fit_part(view, m, 1.5, Fit::contain).differs());
    BOOST_TEST(view.part.width == 60);
    BOOST_TEST(view.part.height == 40);
    view.part = {{3, 4}, 10, 20};
    fit_part(view, m, 1, Fit::cover);
    BOOST_TEST(view.part.width == 10);
    BOOST_TEST(view.part.height == 10);
    BOOST_TEST(view.part.middle.x == 3);
    View whole;
    BOOST_CHECK(!fit_part(whole, m, 0.7526, Fit::contain).differs()); // 0.75 to 0.35%
    BOOST_TEST(whole.part.width == 0);
}

BOOST_AUTO_TEST_CASE(up_to_a_hundredth_nothing_is_done)
{
    for (const Fit fit : {Fit::contain, Fit::cover}) {
        for (const double shape : {1.5, 1.514, 1.486})
            BOOST_TEST(
                (fitted(shape, 1.5, fit).size.x == 1 && fitted(shape, 1.5, fit).size.y == 1));
        BOOST_TEST((fitted(1.53, 1.5, fit).size.y != 1 || fitted(1.53, 1.5, fit).size.x != 1));
    }
    const FittedPicture narrow = fitted(0.5, 2, Fit::contain);
    BOOST_TEST(narrow.size.x == 0.25);
    BOOST_TEST(narrow.is_in_bar({0.3, 0.5}));
    BOOST_TEST(!narrow.is_in_bar({0.4, 0.5}));
    BOOST_TEST(!narrow.is_in_bar({0.5, -0.1})); // outside the target, next to no bar
    BOOST_TEST(narrow.picture_place({0.375, 0.2}).x == 0);
    BOOST_TEST(narrow.picture_place({0.375, 0.2}).y == 0.2);
}

BOOST_AUTO_TEST_CASE(a_sentence_says_what_was_done)
{
    BOOST_TEST(fit_text(fitted(1.5, 0.75, Fit::contain), "the panel") ==
               "its shape (width/height) is 1.5, and the panel's 0.75: it has black bars above and "
               "below; --fit cover fills the panel");
    BOOST_TEST(
        fit_text(fitted(0.75, 1.5, Fit::cover), "--size") ==
        "its shape (width/height) is 0.75, and --size's 1.5: its top and bottom are cut off; "
        "--fit contain shows all of it");
    BOOST_TEST(fit_text(fitted(0.75, 1.5, Fit::stretch), "the film") ==
               "its shape (width/height) is 0.75, and the film's 1.5: it is stretched to 2 times "
               "its width");
}

BOOST_AUTO_TEST_CASE(quilts_are_known_by_the_names_that_users_have)
{
    for (const char* const name :
         {"a_qs4x3a1.5.png", "a_qs4x3a1.5 (1).png", "d/a_qs4x3a1.5(2).png", "A_QS4X3A1.5.PNG",
          "a_qs4x3a1.5 - Copy.png", "a_qs4x3a1.5 copy 2.jpeg", "a_qs2x2a1_qs4x3a1.50.webm"}) {
        const auto quilt = quilt_in_name(name);
        BOOST_TEST_CONTEXT(name)
        {
            BOOST_REQUIRE(quilt);
            BOOST_TEST(quilt->grid.columns == 4);
            BOOST_TEST(quilt->grid.rows == 3);
            BOOST_TEST(quilt->aspect == 1.5);
        }
    }
    for (const char* const name :
         {"a_qs4x3.png", "a_qs4x3a.png", "a_qs4x3a0.png", "a_qs4x3a1.5b.png",
          "_qs5x9a1.77/y.png", "a_qs4x3a1.5.2.png"})
        BOOST_TEST(!quilt_in_name(name), name);
    BOOST_TEST(quilt_in_name("b_qs8x6a.75.png")->aspect == 0.75);
    BOOST_TEST(without_grid("d/a_qs4x3a1.5 (1).png") == "d/a (1).png");
    BOOST_TEST(without_grid("A_QS4X3A1.5.PNG") == "A.PNG");
}

BOOST_AUTO_TEST_SUITE_END()
