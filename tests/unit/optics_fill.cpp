// SPDX-License-Identifier: AGPL-3.0-or-later
// Fill of a lens by the aperture: the thesis's figures and the closed forms of optics.md section 5.
#include "integral/optics/coverage.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_fill)

BOOST_AUTO_TEST_CASE(equation_3_8_pinhole_spread)
{
    BOOST_TEST(micro_image_width({Arrangement::lenticular, 1.27, 3.08, 1.0, 0, {0, 0}}, 300, 195) ==
                   2.002,
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(equation_3_9_extended_pinhole_spread)
{
    const double width = micro_image_width({Arrangement::lenticular, 1.27, 3.08, 1.6, 0, {0, 0}},
                                           300, 195);
    BOOST_TEST(std::fabs(width - 1.213) < 0.0005);
    BOOST_TEST(width ==
                   2 * 3.08 * 195 /
                       std::sqrt(4 * 1.6 * 1.6 * 300 * 300 + 1.6 * 1.6 * 195 * 195 - 195 * 195),
               boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(equation_3_9_is_where_rays_from_the_aperture_meet_the_film)
{
    const LensSheet sheet{Arrangement::square, 2, 3.08, 1.6, 0, {0, 0}};
    const SheetOptics optics(sheet, Aperture{300, 195, 195});
    const double half = micro_image_width(sheet, 300, 195) / 2;
    const auto edge = optics.ray_through({half, 0}, {0, 0});
    BOOST_REQUIRE(edge);
    BOOST_TEST(edge->aperture_point.x == -97.5, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(filling_width_is_the_inverse_of_micro_image_width)
{
    random_sheets::Generator random(8);
    for (int k = 0; k < 5000; ++k) {
        const LensSheet sheet = random.sheet();
        const double distance = random.log_between(1, 1e5),
                     cell = sheet.pitch * random.log_between(1e-3, 10);
        const auto width = filling_width(sheet, distance, cell);
        if (width)
            BOOST_TEST(micro_image_width(sheet, distance, *width) == cell,
                       boost::test_tools::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(no_aperture_fills_a_lens_that_reflects_totally)
{
    const LensSheet sheet{
        Arrangement::lenticular, 3, 1, 1.6, 0, {0, 0}}; // n (p/2)/sqrt((p/2)^2 + t^2) = 1.33
    BOOST_TEST(!filling_aperture(sheet, 300));
    CameraParameters parameters;
    parameters.sheet = sheet;
    BOOST_TEST(find_errors(parameters).size() == 1u);
    parameters.capture_aperture = Vec2{100, 0};
    BOOST_TEST(find_errors(parameters).empty());
}

BOOST_AUTO_TEST_CASE(paraxially_equation_3_5)
{
    const LensSheet sheet{Arrangement::square, 0.01, 3.08, 1.6, 0, {0, 0}};
    BOOST_TEST(*filling_width(sheet, 300, sheet.pitch) == 300 * 1.6 * 0.01 / 3.08,
               boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(default_apertures_hold_the_cell)
{
    const auto slit = filling_aperture({Arrangement::lenticular, 1, 3, 1.5, 60, {0, 0}}, 400);
    BOOST_TEST(slit->width == 0);
    BOOST_TEST(slit->height == *filling_width({Arrangement::lenticular, 1, 3, 1.5, 0, {0, 0}}, 400,
                                              1 / std::sin(60 * 3.14159265358979323846 / 180)),
               boost::test_tools::tolerance(1e-12));
    const auto hexagon = filling_aperture({Arrangement::hexagonal, 1, 3, 1.5, 0, {0, 0}}, 400);
    BOOST_TEST(hexagon->height == *filling_width({Arrangement::hexagonal, 1, 3, 1.5, 0, {0, 0}},
                                                 400, 2 / std::sqrt(3.0)),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(default_apertures_turn_with_the_cell)
{
    // A square's corner lies at 45 degrees, a hexagon's at 30; both slants are chosen for extents
    // known by hand.
    const Vec2 square = cell_extent({Arrangement::square, 2, 3, 1.5, -45, {0, 0}});
    BOOST_TEST(square.x == 2 * std::sqrt(2.0), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(square.y == square.x, boost::test_tools::tolerance(1e-14));
    const Vec2 upright = cell_extent({Arrangement::hexagonal, 2, 3, 1.5, 0, {0, 0}});
    BOOST_TEST(upright.x == 2);
    BOOST_TEST(upright.y == 4 / std::sqrt(3.0), boost::test_tools::tolerance(1e-14));
    const Vec2 lying = cell_extent({Arrangement::hexagonal, 2, 3, 1.5, 30, {0, 0}});
    BOOST_TEST(lying.x == upright.y, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(lying.y == upright.x, boost::test_tools::tolerance(1e-14));
    // The extents contain the cell's corners and touch two of them. A quarter turn exchanges width
    // and height.
    for (const auto arrangement : {Arrangement::square, Arrangement::hexagonal})
        for (double slant = -90; slant <= 90; slant += 1) {
            const Vec2 extent = cell_extent({arrangement, 1, 3, 1.5, slant, {0, 0}});
            const int corners = arrangement == Arrangement::hexagonal ? 6 : 4;
            const double radius = arrangement == Arrangement::hexagonal ? 1 / std::sqrt(3.0)
                                                                        : std::sqrt(0.5);
            double x = 0, y = 0;
            for (int k = 0; k < corners; ++k) {
                const double angle = (slant + (k + 0.5) * 360 / corners) * 3.14159265358979323846 /
                                     180;
                x = std::max(x, 2 * radius * std::cos(angle));
                y = std::max(y, 2 * radius * std::sin(angle));
            }
            BOOST_TEST(extent.x == x, boost::test_tools::tolerance(1e-12));
            BOOST_TEST(extent.y == y, boost::test_tools::tolerance(1e-12));
        }
}

BOOST_AUTO_TEST_CASE(default_apertures_fill_slanted_sheets)
{
    // When the cell's extent neglected the slant, only 97, 94, 86 and 82% of a square sheet's film
    // were imaged.
    for (const auto arrangement : {Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 15.0, 30.0, 45.0, -20.0}) {
            CameraParameters parameters;
            parameters.sheet = {arrangement, 1.124, 3.23, 1.675, slant, {0, 0}};
            parameters.film.pixel_pitch = {0.01, 0.01};
            const int side = 3001;
            const ViewFrame view{
                {0, 0, 0}, {0, 0, 300}, {side * 0.01, 0, 0}, {0, side * 0.01, 0}, 1};
            const Coverage part = coverage(make_camera(parameters, view, side, side), 20000);
            BOOST_TEST(part.imaged > 0.965, "slant " << slant << ": " << part.imaged);
        }
}

BOOST_AUTO_TEST_CASE(gap_off_the_axis)
{
    // optics.md section 5: about t/(nd) of the pitch stays dark, 0.6% at 300 mm
    CameraParameters parameters;
    parameters.film.pixel_pitch = {0.01, 0.01};
    const double width = 4001, distance = 300;
    ViewFrame view{{0, 0, 0}, {0, 0, distance}, {width * 0.01, 0, 0}, {0, 1, 0}, 1};
    const Coverage part = coverage(make_camera(parameters, view, int(width), 1), 100000);
    BOOST_TEST(1 - part.imaged > 0.005);
    BOOST_TEST(1 - part.imaged < 0.010);
}

BOOST_AUTO_TEST_CASE(the_edge_of_the_aperture_belongs_to_it)
{
    const Aperture rectangle{1, 2, 4};
    BOOST_TEST(contains(rectangle, {1, -2}));
    BOOST_TEST(contains(rectangle, {1 + 0.5e-9, 0}));
    BOOST_TEST(!contains(rectangle, {1 + 1e-8, 0}));
    const Aperture ellipse{1, 2, 4, ApertureShape::ellipse};
    BOOST_TEST(contains(ellipse, {0, 2}));
    BOOST_TEST(!contains(ellipse, {0.8, 1.6}));
    BOOST_TEST(contains(ellipse, {0.6, 1.6}));
    BOOST_TEST(!contains(rectangle, {NAN, 0}));
}

BOOST_AUTO_TEST_SUITE_END()
