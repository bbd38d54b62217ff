// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests frames side by side behind one lens sheet: distances from each frame's lenses to the
// sheet's are worked out in the coordinates of the lattice, with complex numbers.
#include "integral/print/gang.h"
#include "integral/print/page_marks.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace integral;

BOOST_AUTO_TEST_SUITE(print_gang)

namespace {

using Complex = std::complex<double>;

FrameMetadata geometry(LensSheet sheet, int width, int height, double pixel)
{
    FrameMetadata m;
    m.sheet = sheet;
    m.film = {width, height, {pixel, pixel}};
    m.aperture.distance = 300;
    return m;
}

double from_integer(double value) { return value - std::round(value); }

/// The vector from the nearest lens of a lattice with a lens at 0 to a point, in pitches along the
/// rows (and, of 2-D sheets, along the columns).
Complex phase(const LensSheet& sheet, Complex point)
{
    const double turn = sheet.slant * 3.14159265358979323846 / 180;
    const Complex p = point / std::polar(sheet.pitch, turn);
    if (sheet.arrangement == Arrangement::lenticular)
        return from_integer(p.real());
    if (sheet.arrangement == Arrangement::square)
        return {from_integer(p.real()), from_integer(p.imag())};
    const double row = std::sqrt(0.75); // hexagonal: the union of two rectangular lattices
    const auto of_half = [&](Complex q) {
        return Complex{from_integer(q.real()), 2 * row * from_integer(q.imag() / (2 * row))};
    };
    const Complex a = of_half(p), b = of_half(p - Complex{0.5, row});
    return std::abs(a) < std::abs(b) ? a : b;
}

/// The lens at index (0, 0) of a frame at a place of the picture, mm, y upwards.
Complex lens_at(const FrameMetadata& m, const PixelRectangle& place)
{
    return {(place.x + 0.5 * m.film.width) * m.film.pixel_pitch.x + m.sheet.offset.x,
            -(place.y + 0.5 * m.film.height) * m.film.pixel_pitch.y + m.sheet.offset.y};
}

} // namespace

BOOST_AUTO_TEST_CASE(lenses_of_all_frames_lie_on_the_common_sheets)
{
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 12.5, -40.0, 63.0, 90.0})
            for (const double pitch : {1.124, 1.27, 0.3387}) {
                BOOST_TEST_CONTEXT("arrangement " << int(arrangement) << ", slant " << slant
                                                  << ", pitch " << pitch)
                {
                    const double pixel = 25.4 / 300;
                    std::vector<FrameMetadata> frames;
                    for (int k = 0; k < 7; ++k)
                        frames.push_back(
                            geometry({arrangement, pitch, 3, 1.5, slant, {0.31 * k, -0.17 * k}},
                                     300 + 17 * k, 200 + 11 * (k % 3), pixel));
                    GangRequest request;
                    request.room = {1300, 900};
                    request.gap = 5;
                    const Gang g = gang(frames, request);
                    BOOST_REQUIRE(g.places.size() == 7u);
                    const Film& film = g.metadata.film;
                    const Complex sheet = lens_at(g.metadata, {0, 0, 0, 0});
                    double largest = 0, first = 0, last = 0;
                    int right = 0, bottom = 0;
                    for (std::size_t k = 0; k < 7; ++k) {
                        const PixelRectangle& place = g.places[k];
                        const Complex error = pitch * phase(g.metadata.sheet,
                                                            lens_at(frames[k], place) - sheet);
                        largest = std::max(largest, std::abs(error));
                        first = std::min(first, error.real());
                        last = std::max(last, error.real());
                        BOOST_TEST((place.width == frames[k].film.width &&
                                    place.height == frames[k].film.height));
                        right = std::max(right, place.x + place.width);
                        bottom = std::max(bottom, place.y + place.height);
                        for (std::size_t j = 0; j < k; ++j) { // 5 mm are 59.06 pixels
                            const PixelRectangle& other = g.places[j];
                            BOOST_TEST((place.x >= other.x + other.width + 60 ||
                                        place.x + place.width + 60 <= other.x ||
                                        place.y >= other.y + other.height + 60));
                        }
                    }
                    const bool lenticular = arrangement == Arrangement::lenticular;
                    BOOST_TEST(largest <= (lenticular ? 0.5 : std::sqrt(0.5)) * pixel + 1e-9);
                    BOOST_TEST(std::fabs(largest - g.largest_error) < 1e-9);
                    if (lenticular) // the sheet stands in the middle of the errors
                        BOOST_TEST(std::fabs(first + last) < 1e-9);
                    BOOST_TEST((film.width == right && film.height == bottom));
                    BOOST_TEST((right <= 1300 && bottom <= 900));
                }
            }
}

BOOST_AUTO_TEST_CASE(equal_frames_of_whole_pixels_have_no_error)
{
    // 1.27 mm are 15 pixels. 8 mm are 94.5 pixels: after 300 pixels, the next lens is at 405.
    const FrameMetadata m = geometry({Arrangement::lenticular, 1.27, 3, 1.5, 0, {0.2, 0}}, 300, 200,
                                     25.4 / 300);
    GangRequest request;
    request.room = {1200, 1000};
    request.fill = true;
    const Gang g = gang({m}, request);
    BOOST_REQUIRE(g.places.size() == 9u);
    BOOST_TEST(g.rows == 3);
    for (std::size_t k = 0; k < 9; ++k)
        BOOST_TEST((g.places[k].x == 405 * int(k % 3) && g.places[k].y == (200 + 95) * int(k / 3)));
    BOOST_TEST(g.largest_error < 1e-9);
    request.fill = false;
    request.room = {1109, 1000}; // a pixel too narrow for three
    BOOST_TEST(gang({m, m, m}, request).rows == 2);
    request.room = {1109, 494};
    BOOST_CHECK_THROW(gang({m, m, m}, request), std::invalid_argument);
    // Of 2-D lenses the next is at 300 pixels down, too, after 200 and a gap of 95. At 90 degrees
    // the lattice's rows run down.
    for (const double slant : {0.0, 90.0, -90.0}) {
        const FrameMetadata square = geometry({Arrangement::square, 1.27, 3, 1.5, slant, {0.2, 0}},
                                              300, 200, 25.4 / 300);
        const Gang rows = gang({square, square, square}, [] {
            GangRequest two;
            two.room = {800, 600};
            return two;
        }());
        BOOST_TEST((rows.places[1].x == 405 && rows.places[1].y == 0));
        BOOST_TEST((rows.places[2].x == 0 && rows.places[2].y == 300));
    }
    request.room = {299, 1000};
    request.fill = true;
    BOOST_CHECK_THROW(gang({m}, request), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(one_sheet_serves_equal_sheets_only)
{
    const FrameMetadata m = geometry({Arrangement::square, 1, 3, 1.5, 4, {0, 0}}, 30, 20, 0.1);
    FrameMetadata same = m;
    same.sheet.offset = {0.2, 0.3};
    same.film.width = 70;
    same.aperture.distance = 500;
    BOOST_TEST(sheet_difference(m, same) == "");
    const auto difference = [&](auto change) {
        FrameMetadata other = m;
        change(other);
        return sheet_difference(m, other);
    };
    BOOST_TEST(difference([](auto& o) { o.sheet.pitch = 1.001; }) == "pitch: 1 and 1.001 mm");
    BOOST_TEST(difference([](auto& o) { o.sheet.slant = -4; }) == "slant: 4 and -4 degrees");
    BOOST_TEST(difference([](auto& o) { o.sheet.ior = 1.6; }) == "ior: 1.5 and 1.6");
    BOOST_TEST(difference([](auto& o) { o.sheet.thickness = 2; }) == "thickness: 3 and 2 mm");
    BOOST_TEST(difference([](auto& o) { o.sheet.arrangement = Arrangement::hexagonal; }) ==
               "arrangement: square and hexagonal");
    BOOST_TEST(difference([](auto& o) { o.film.pixel_pitch.x = 0.2; }) ==
               "pixel pitch across: 0.1 and 0.2 mm");
    BOOST_TEST(difference([](auto& o) { o.film.pixel_pitch.y = 0.2; }) ==
               "pixel pitch down: 0.1 and 0.2 mm");
    BOOST_TEST(difference([](auto& o) { o.projection.emplace(); }) != "");
}

BOOST_AUTO_TEST_CASE(each_frame_has_crop_marks_outside_all_frames)
{
    const double pixel = 25.4 / 300;
    const FrameMetadata m = geometry({Arrangement::lenticular, 1.27, 3, 1.5, 0, {0, 0}}, 300, 200,
                                     pixel);
    for (const double gap : {8.0, 3.0}) {
        GangRequest request;
        request.gap = gap;
        request.room = {900, 1000};
        const Gang g = gang({m, m, m, m}, request);
        PageRequest page;
        page.paper = Paper{105, 90};
        page.crop_marks = true;
        for (const PixelRectangle& place : g.places)
            page.frames.push_back({place, 2});
        const Page laid = lay_out(g.metadata, {pixel, pixel}, page)[0];
        BOOST_REQUIRE(laid.frames.size() == 4u);
        // Two of eight marks of each frame are in the gaps, across and down.
        BOOST_TEST(laid.lines.size() == (gap > 4 ? 32u : 16u));
        std::size_t cuts = 0;
        for (const PageLine& line : laid.lines)
            for (const FrameOnPage& frame : laid.frames) {
                const PixelRectangle& r = frame.picture;
                const double left = r.x * pixel - 1.4, right = (r.x + r.width) * pixel + 1.4,
                             top = r.y * pixel - 1.4, bottom = (r.y + r.height) * pixel + 1.4;
                BOOST_TEST((std::max(line.from.x, line.to.x) < left ||
                            std::min(line.from.x, line.to.x) > right ||
                            std::max(line.from.y, line.to.y) < top ||
                            std::min(line.from.y, line.to.y) > bottom));
                // 2 mm are 23.6 pixels, cut to 24.
                const auto is_cut = [&](double at, int edge) {
                    return std::fabs(at - edge * pixel) < 1e-9;
                };
                if (line.from.x == line.to.x)
                    cuts += is_cut(line.from.x, r.x + 24) || is_cut(line.from.x, r.x + 276);
                else
                    cuts += is_cut(line.from.y, r.y + 24) || is_cut(line.from.y, r.y + 176);
            }
        BOOST_TEST(cuts == 2 * laid.lines.size()); // of two frames in line with each mark
        BOOST_TEST((laid.trimmed.x == laid.frames[0].picture.x + 24 &&
                    laid.trimmed.width == (gap > 4 ? 405 : 345) + 300 - 48));
    }
}

BOOST_AUTO_TEST_CASE(a_mark_is_whole_where_no_frame_is_beside)
{
    const double pixel = 25.4 / 300;
    const FrameMetadata m = geometry({Arrangement::lenticular, 1.27, 3, 1.5, 0, {0, 0}}, 300, 200,
                                     pixel);
    GangRequest request;
    request.room = {900, 1000};
    const Gang g = gang({m, m, m}, request); // two above one
    PageRequest page;
    page.paper = Paper{105, 90};
    page.crop_marks = true;
    for (const PixelRectangle& place : g.places)
        page.frames.push_back({place, 0});
    const Page laid = lay_out(g.metadata, {pixel, pixel}, page)[0];
    const auto length_right_of = [&](std::size_t frame) {
        const PixelRectangle& r = laid.frames[frame].picture;
        for (const PageLine& line : laid.lines)
            if (std::fabs(line.from.x - (r.x + r.width) * pixel - 1.5) < 1e-9 &&
                std::fabs(line.from.y - r.y * pixel) < 1e-9 && line.from.y == line.to.y)
                return line.to.x - line.from.x;
        return 0.0;
    };
    // 405 - 300 pixels of gap are 8.89 mm, of which half less 1.5 mm are a mark's.
    BOOST_TEST(std::fabs(length_right_of(0) - 2.945) < 1e-9);
    BOOST_TEST(std::fabs(length_right_of(1) - 5.5) < 1e-9);
    BOOST_TEST(std::fabs(length_right_of(2) - 5.5) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
