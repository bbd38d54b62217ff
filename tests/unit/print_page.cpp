// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the layout of frames on paper: positions of the picture, its tiles and its marks, compared
// with values worked out by hand and with independent formulas.
#include "integral/print/colour_profile.h"
#include "integral/print/page_marks.h"
#include "integral/print/page_raster.h"
#include "integral/views/quilt.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace integral;

BOOST_AUTO_TEST_SUITE(print_page)

namespace {

FrameMetadata geometry(LensSheet sheet, int width, int height, double pitch = 25.4 / 300)
{
    FrameMetadata m;
    m.sheet = sheet;
    m.film = {width, height, {pitch, pitch}};
    m.aperture.distance = 300;
    m.aperture.width = m.aperture.height = 100;
    return m;
}

const LensSheet lenticular{Arrangement::lenticular, 1.27, 3.08, 1.6, 0, {0, 0}};

PageRequest on(double width, double height)
{
    PageRequest request;
    request.paper = Paper{width, height};
    return request;
}

} // namespace

BOOST_AUTO_TEST_CASE(papers)
{
    BOOST_TEST(paper_named("4X6")->width == 101.6);
    BOOST_TEST(std::fabs(paper_named("6x8")->height - 203.2) < 1e-12);
    BOOST_TEST(paper_named("a4")->height == 297);
    BOOST_TEST(paper_named("sra3")->width == 320);
    BOOST_TEST(!paper_named("7x4"));
}

BOOST_AUTO_TEST_CASE(a_picture_comes_to_the_middle_and_its_lens_to_it)
{
    LensSheet sheet = lenticular;
    sheet.offset = {0.3, 0};
    const FrameMetadata m = geometry(sheet, 600, 400);
    const auto page = lay_out(m, m.film.pixel_pitch, on(101.6, 152.4))[0];
    BOOST_TEST(page.width == 1200);
    BOOST_TEST(page.height == 1800);
    // 0.3 mm are 3.54 pixels: the distance of the axis to the right of the picture's middle.
    BOOST_TEST(page.x == 300 - 4);
    BOOST_TEST(page.y == 700);
    PageRequest request = on(101.6, 152.4);
    request.centre_on_lens = false;
    BOOST_TEST(lay_out(m, m.film.pixel_pitch, request)[0].x == 300);
    const auto g = geometry_of(page, m);
    BOOST_REQUIRE(g);
    BOOST_TEST(std::fabs(g->metadata.sheet.offset.x - (0.3 - 4 * 25.4 / 300)) < 1e-12);
    BOOST_TEST(g->metadata.film.width == 1200);
    request.mirrored = true;
    BOOST_TEST(!geometry_of(lay_out(m, m.film.pixel_pitch, request)[0], m));
}

BOOST_AUTO_TEST_CASE(tiles_cover_the_picture_and_overlap)
{
    const FrameMetadata m = geometry(lenticular, 2480, 3508);
    PageRequest request = on(152.4, 203.2); // 1800 x 2400 pixels
    BOOST_CHECK_THROW(lay_out(m, m.film.pixel_pitch, request), std::invalid_argument);
    request.tiles = true;
    request.overlap = 10;
    request.crop_marks = true;
    request.strip = "strip";
    const auto pages = lay_out(m, m.film.pixel_pitch, request);
    std::vector<int> times(std::size_t(m.film.width) * m.film.height);
    for (const Page& page : pages) {
        BOOST_TEST(page.width == 1800);
        BOOST_TEST((page.x >= 0 && page.x + page.part.width <= page.width));
        BOOST_TEST((page.y >= 0 && page.y + page.part.height <= page.height));
        for (int y = 0; y < page.part.height; ++y)
            for (int x = 0; x < page.part.width; ++x)
                ++times[std::size_t(page.part.y + y) * m.film.width + page.part.x + x];
    }
    BOOST_TEST(pages.size() == 4u);
    BOOST_TEST(*std::min_element(times.begin(), times.end()) >= 1);
    BOOST_TEST(pages[0].part.width - pages[1].part.x >= 10 * 300 / 25.4); // pixels on both
    request.overlap = 100;
    BOOST_CHECK_THROW(lay_out(m, m.film.pixel_pitch, request), std::invalid_argument);
    // A narrow picture, in one column: its width need not hold two overlaps.
    const FrameMetadata narrow = geometry(lenticular, 150, 1200);
    const auto column = lay_out(narrow, m.film.pixel_pitch, [] {
        PageRequest r = on(15, 60);
        r.tiles = true;
        return r;
    }());
    BOOST_TEST((column.size() == 2u && column[0].columns == 1));
}

BOOST_AUTO_TEST_CASE(registration_marks_stand_beyond_axis_marks)
{
    LensSheet sheet = lenticular;
    sheet.arrangement = Arrangement::square;
    const FrameMetadata m = geometry(sheet, 600, 400);
    PageRequest axes = on(152.4, 101.6), both = axes;
    axes.axis_marks = true;
    both.axis_marks = both.registration_marks = true;
    const auto page = lay_out(m, m.film.pixel_pitch, axes)[0],
               all = lay_out(m, m.film.pixel_pitch, both)[0];
    const double pixel = 25.4 / 300;
    const auto outside = [&](Vec2 p) { // the distance of a point from the picture
        return std::max({all.x * pixel - p.x, p.x - (all.x + 600) * pixel, all.y * pixel - p.y,
                         p.y - (all.y + 400) * pixel});
    };
    double farthest_axis = 0;
    for (const PageLine& line : page.lines)
        farthest_axis = std::max({farthest_axis, outside(line.from), outside(line.to)});
    const std::size_t marks = all.lines.size() - page.lines.size();
    BOOST_REQUIRE((marks > 0 && marks < all.lines.size()));
    for (std::size_t k = 0; k < marks; ++k) // registration comes first
        BOOST_TEST((outside(all.lines[k].from) > farthest_axis - 1e-9 &&
                    outside(all.lines[k].from) < marks_margin(both)));
}

BOOST_AUTO_TEST_CASE(a_strip_has_letters_on_the_narrowest_paper)
{
    PageRequest request = on(5, 20);
    request.strip = "a scene";
    const FrameMetadata m = geometry(lenticular, 50, 50);
    BOOST_TEST(lay_out(m, m.film.pixel_pitch, request)[0].strip_size > 0);
}

BOOST_AUTO_TEST_CASE(axis_marks_stand_where_axes_run)
{
    for (const double slant : {0.0, 12.0, -35.0, 90.0})
        for (const Arrangement arrangement : {Arrangement::lenticular, Arrangement::square}) {
            const LensSheet sheet{arrangement, 1.27, 3.08, 1.6, slant, {0.2, 0.1}};
            const FrameMetadata m = geometry(sheet, 900, 600);
            PageRequest request = on(152.4, 101.6);
            request.axis_marks = true;
            const auto page = lay_out(m, m.film.pixel_pitch, request)[0];
            const double pixel = 25.4 / 300, a = slant * 3.14159265358979323846 / 180;
            int upright = 0, across = 0, long_ones = 0;
            for (const PageLine& line : page.lines) {
                // Back to the sheet: mm from the picture's middle, y upwards; then along the lens
                // rows and columns, in pitches.
                bool is_of_middle_lens = false;
                for (const Vec2 p : {line.from, line.to}) {
                    const double x = p.x - (page.x + 450) * pixel - 0.2,
                                 y = (page.y + 300) * pixel - p.y - 0.1;
                    const double u = (x * std::cos(a) + y * std::sin(a)) / 1.27,
                                 v = (-x * std::sin(a) + y * std::cos(a)) / 1.27;
                    const double off_u = std::fabs(u / 5 - std::round(u / 5)) * 5,
                                 off_v = std::fabs(v / 5 - std::round(v / 5)) * 5;
                    // Every fifth axis, counted from the one nearest to the sheet's middle: lens 0.
                    BOOST_TEST(std::min(off_u, arrangement == Arrangement::square ? off_v : 1.0) <
                               1e-6);
                    is_of_middle_lens = std::fabs(u) < 1e-6 ||
                                        (arrangement == Arrangement::square && std::fabs(v) < 1e-6);
                }
                const double top = page.y * pixel, bottom = (page.y + 600) * pixel;
                ++(line.from.y < top || line.from.y > bottom ? upright : across);
                const bool outside = line.from.x < page.x * pixel ||
                                     line.from.x > (page.x + 900) * pixel || line.from.y < top ||
                                     line.from.y > bottom;
                BOOST_TEST(outside);
                const double long_way = std::max(std::fabs(line.to.x - line.from.x),
                                                 std::fabs(line.to.y - line.from.y));
                BOOST_TEST((long_way > 3) == is_of_middle_lens); // 3.5 mm; the others 2
                long_ones += is_of_middle_lens;
            }
            // Above and below; a row's axis at 35 degrees leaves the picture there, too.
            BOOST_TEST(long_ones == (arrangement == Arrangement::square && slant >= 0 ? 4 : 2));
            // 76.2 mm hold 12 steps of 6.35 mm cos(slant), above and below; 50.8 mm 8, at the sides
            const bool square = arrangement == Arrangement::square, lying = slant > 45;
            const double step = 6.35 / std::max(std::cos(a), std::sin(a));
            BOOST_TEST(std::abs(upright - (square || !lying ? 2 * 76.2 / step : 0)) <= 3);
            BOOST_TEST(std::abs(across - (square || lying ? 2 * 50.8 / step : 0)) <= 3);
            BOOST_TEST((square || (lying ? upright : across) == 0));
        }
}

BOOST_AUTO_TEST_CASE(a_page_is_its_picture_on_white)
{
    Image picture = make_image<std::uint16_t>(40, 30, 3, {});
    int k = 0;
    for (auto& sample : std::get<std::vector<std::uint16_t>>(picture.samples))
        sample = std::uint16_t(17 * ++k);
    const FrameMetadata m = geometry(lenticular, 40, 30);
    PageRequest request = on(80 * 25.4 / 300, 70 * 25.4 / 300);
    for (const bool mirrored : {false, true}) {
        request.mirrored = mirrored;
        const Page page = lay_out(m, m.film.pixel_pitch, request)[0];
        const Image sheet = rasterized(page, picture, rows_in(picture));
        BOOST_TEST(sheet.width == 80);
        for (int y = 0; y < sheet.height; ++y)
            for (int x = 0; x < sheet.width; ++x) {
                const int u = (mirrored ? 79 - x : x) - page.x, v = y - page.y;
                const Colour c = stored_pixel(sheet, x, y);
                const bool inside = u >= 0 && v >= 0 && u < 40 && v < 30;
                const Colour requested = inside ? stored_pixel(picture, u, v) : Colour{1, 1, 1, 1};
                BOOST_REQUIRE((c.r == requested.r && c.g == requested.g && c.b == requested.b));
            }
    }
    request.paper = Paper{5, 5};
    picture = make_image<std::uint16_t>(4, 4, 3, {});
    request.axis_marks = true;
    BOOST_CHECK_THROW(lay_out(geometry(lenticular, 40, 30), m.film.pixel_pitch, request),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(marks_are_the_same_in_whatever_pieces_they_are_drawn)
{
    // The wide page has the narrow one in its middle; pieces of a page end at pixel 8192, which is
    // pixel 4192 of the narrow one. Few rows are drawn at a time, so that slanted lines cross
    // pieces, too.
    constexpr double pixel = 25.4 / 300;
    constexpr int narrow = 6000, beside = 4000, height = 900;
    LensSheet sheet = lenticular;
    sheet.slant = 12;
    const FrameMetadata m = geometry(sheet, 4800, 300);
    const Image picture = make_image<std::uint8_t>(4800, 300, 3, {});
    PageRequest request = on(narrow * pixel, height * pixel);
    request.crop_marks = request.registration_marks = request.axis_marks = true;
    const Page page = lay_out(m, m.film.pixel_pitch, request)[0];
    request.paper = Paper{(narrow + 2 * beside) * pixel, height * pixel};
    const Page wide_page = lay_out(m, m.film.pixel_pitch, request)[0];
    BOOST_REQUIRE(wide_page.x == page.x + beside);
    const Image one = rasterized(page, picture, rows_in(picture));
    const Image other = rasterized(wide_page, picture, rows_in(picture));
    int black = 0, different = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < narrow; ++x) {
            const bool ink = stored_pixel(one, x, y).g == 0;
            black += ink;
            different += ink != (stored_pixel(other, x + beside, y).g == 0);
        }
    BOOST_TEST(black > 4800 * 300 + 4000); // the picture is black, too
    BOOST_TEST(different == 0);
}

BOOST_AUTO_TEST_CASE(colours_to_their_own_profile_stay)
{
    const std::string srgb = srgb_profile();
    BOOST_TEST((srgb == srgb_profile()));
    Image picture = make_image<std::uint8_t>(16, 16, 3, {});
    int k = 0;
    for (auto& sample : std::get<std::vector<std::uint8_t>>(picture.samples))
        sample = std::uint8_t(k += 37);
    const Image same = in_profile(picture, srgb, Intent::relative);
    for (std::size_t i = 0; i < 768; ++i)
        BOOST_TEST(std::abs(std::get<0>(same.samples)[i] - std::get<0>(picture.samples)[i]) <= 1);
    BOOST_CHECK_THROW(in_profile(picture, "no profile", Intent::relative), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(quilts_name_their_views)
{
    BOOST_TEST(quilt_name("a/b.png", {5, 9}, 0.75) == "a/b_qs5x9a0.75.png");
    BOOST_TEST(quilt_name("b_qs5x9a0.75.png", {8, 6}, 1) == "b_qs5x9a0.75.png");
    BOOST_TEST(quilt_in_name("b_qs11x6a1.77778.png")->grid.columns == 11);
}

BOOST_AUTO_TEST_CASE(lengths_that_no_page_has_are_refused)
{
    // Found by tests/sanitized/fuzz.test: a frame's file may contain such films and lenses.
    const auto refusal = [](const FrameMetadata& m, const PageRequest& request) -> std::string {
        try {
            lay_out(m, m.film.pixel_pitch, request);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    const FrameMetadata fine = geometry(lenticular, 8, 6, 1e-6);
    PageRequest marked;
    marked.crop_marks = true;
    PageRequest tiled = on(0.5, 0.5);
    tiled.tiles = true;
    for (const PageRequest& request : {on(5000, 5000), marked, tiled})
        BOOST_TEST(refusal(fine, request).find("more than 1000000 pixels") != std::string::npos);
    PageRequest plain;
    plain.centre_on_lens = false;
    BOOST_TEST(refusal(fine, plain) == "");

    LensSheet narrow = lenticular;
    narrow.pitch = 1e-4;
    PageRequest axes;
    axes.axis_marks = true;
    BOOST_TEST(refusal(geometry(narrow, 8000, 6, 0.1), axes).find("too many for marks") !=
               std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
