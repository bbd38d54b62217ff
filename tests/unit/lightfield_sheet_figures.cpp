// SPDX-License-Identifier: AGPL-3.0-or-later
// The thesis's figures, as optics.md section 6 lists them.
#include "integral/lightfield/sheet_figures.h"

#include "integral/optics/film.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace integral;

BOOST_AUTO_TEST_SUITE(lightfield_sheet_figures)

namespace {

LensSheet sheet(double pitch = 1.27, double thickness = 3.08, double ior = 1.6)
{
    LensSheet s;
    s.pitch = pitch;
    s.thickness = thickness;
    s.ior = ior;
    return s;
}

constexpr double dpi_300 = mm_per_inch / 300;

/// Equal to the printed figure, to half of its last digit.
void check_printed(double value, double printed, double last_digit)
{
    BOOST_TEST(std::fabs(value - printed) <= 0.5 * last_digit, value << " instead of " << printed);
}

} // namespace

BOOST_AUTO_TEST_CASE(equation_2_1_greatest_angle)
{
    check_printed(*greatest_angle(sheet(1.27, 3.08, 1.5)), 17.63, 0.01);
    check_printed(*greatest_angle(sheet()), 18.85, 0.01);
    BOOST_CHECK(!greatest_angle(sheet(10, 1, 1.6)));
}

BOOST_AUTO_TEST_CASE(equation_3_5_filling_distance)
{
    // W t / (n p); the exact filling aperture is within its paraxial error of it.
    const double w = 200;
    check_printed(filling_distance(sheet(), w), 200 * 3.08 / (1.6 * 1.27), 1e-9);
    const auto exact = filling_width(sheet(), filling_distance(sheet(), w), 1.27);
    BOOST_REQUIRE(exact);
    BOOST_TEST(std::fabs(*exact / w - 1) < 0.04);
    // Nearly flat lenses: the two agree.
    const LensSheet flat = sheet(0.01);
    BOOST_TEST(std::fabs(*filling_width(flat, filling_distance(flat, w), 0.01) / w - 1) < 1e-5);
}

BOOST_AUTO_TEST_CASE(equation_3_8_pinhole_spread)
{
    check_printed(pinhole_spread(sheet(), 300, 195), 2.002, 0.001);
}

BOOST_AUTO_TEST_CASE(equation_3_9_extended_pinhole_spread)
{
    check_printed(micro_image_width(sheet(), 300, 195), 1.213, 0.001);
}

BOOST_AUTO_TEST_CASE(equation_4_1_pixels_seen)
{
    // (300/25.4) t D/d; figure 4-8 falls as 1/d: one pixel at 181.9 mm for a 5 mm eye.
    check_printed(pixels_seen(sheet(), dpi_300, 5, 181.89), 1, 0.001);
    check_printed(pixels_seen(sheet(), dpi_300, 5, 363.78), 0.5, 0.001);
}

BOOST_AUTO_TEST_CASE(equation_4_4_pixel_angle)
{
    check_printed(*pixel_angle(sheet(), dpi_300), 2.52, 0.01);
    BOOST_CHECK(!pixel_angle(sheet(1.27, 3.08, 1.6), 10));
}

BOOST_AUTO_TEST_CASE(equation_4_5_pixel_spread)
{
    check_printed(pixel_spread(2.52, 300), 13.197, 0.001);
}

BOOST_AUTO_TEST_CASE(equation_4_6_resolution_against_depth)
{
    // (1/2d)(lpi/n) sqrt(4t^2 + p^2 - n^2 p^2) with lpi 150: 5.9525 under the root's result.
    const double root = std::sqrt(4 * 3.08 * 3.08 + 1.27 * 1.27 - 1.6 * 1.6 * 1.27 * 1.27);
    check_printed(*depth_resolution(sheet(), dpi_300, 100), 150 / 1.6 * root / 200, 1e-9);
    check_printed(*depth_resolution(sheet(), dpi_300, 50) / *depth_resolution(sheet(), dpi_300, 100), 2, 1e-12);
    check_printed(*depth_resolution(sheet(), dpi_300, *depth_budget(sheet(), dpi_300)),
                  observer_resolution(1.27, 500, 0), 1e-9);
    BOOST_CHECK(!depth_resolution(sheet(10, 1, 1.6), dpi_300, 50));
    BOOST_CHECK(!depth_budget(sheet(10, 1, 1.6), dpi_300));
}

BOOST_AUTO_TEST_CASE(equation_4_7_observer_resolution)
{
    check_printed(observer_resolution(1.27, 500, 0), 10, 1e-9);
    check_printed(observer_resolution(1.27, 500, 250), 20, 1e-9);
}

BOOST_AUTO_TEST_CASE(equation_5_1_discrete_view_distance)
{
    check_printed(discrete_view_distance(sheet(), 0.085, 125) / 1000, 4.53, 0.01);
}

BOOST_AUTO_TEST_CASE(moire_of_lenses_and_pixels)
{
    // 15 pixels a lens: the images of an eye at d are p t/(n d) farther apart, so the pattern
    // repeats after pixel n d/t on the sheet.
    check_printed(*moire_pitch(1.27, sheet(), dpi_300, 300), dpi_300 * 1.6 * 300 / 3.08, 1e-6);
    // Far away only the odd part of a pixel per lens is left: 7.087 pixels, 0.6/0.087.
    check_printed(*moire_pitch(0.6, sheet(0.6, 2.65, 1.52), dpi_300, 1e9), 0.6 / (0.6 / dpi_300 - 7), 1e-4);
    BOOST_CHECK(!moire_pitch(1.27, sheet(), 1.27 / 15, 1e12));
    // The pitch itself, against the exact place of an eye's image behind a lens near the axis.
    const double x = 1e-3, t = 3.08, n = 1.6, d = 300;
    const double behind = x * t / std::sqrt(n * n * d * d + (n * n - 1) * x * x);
    check_printed(visual_pitch(1.27, sheet(), d) / 1.27, (x + behind) / x, 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
