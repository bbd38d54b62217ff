// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares figures of sheets with the thesis's printed figures (optics.md section 6).
#include "integral/optics/visual_pitch.h"
#include "integral/sheet/sheet_figures.h"

#include "integral/base/constants.h"
#include "integral/optics/film.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace integral;

BOOST_AUTO_TEST_SUITE(sheet_figures)

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

/// Checks that a value, rounded to the printed digits, is the printed figure.
void check_printed(double value, double printed, double last_digit)
{
    BOOST_TEST(std::fabs(value - printed) <= 0.5 * last_digit, value << " instead of " << printed);
}

} // namespace

BOOST_AUTO_TEST_CASE(equation_2_1_greatest_angle_of_the_afocal_pair)
{
    check_printed(*greatest_angle(sheet(1.27, 3.08, 1.5)), 17.63, 0.01);
    BOOST_CHECK(!greatest_angle(sheet(10, 1, 1.6)));
}

BOOST_AUTO_TEST_CASE(equation_2_1_greatest_angle_of_micro_field_lenses)
{
    // section 2.4.1 prints the formula's value at n 1.6
    check_printed(*greatest_angle(sheet()), 18.85, 0.01);
}

BOOST_AUTO_TEST_CASE(afocal_pair_and_its_field_lenses_by_tracing)
{
    // Thin lenses of focal length t in the medium, 2t apart, field lenses half way; every ray of a
    // parallel beam that fills a lens.
    const LensSheet pair = sheet();
    const double t = pair.thickness, p = pair.pitch;
    const auto kept = [&](double degrees, double field_focus) {
        const double inside = std::tan(
            std::asin(std::sin(degrees * radians_per_degree) / pair.ior));
        int through = 0;
        constexpr int rays = 10000;
        for (int k = 0; k < rays; ++k) {
            const double x = ((k + 0.5) / rays - 0.5) * p;
            double slope = inside - x / t, at = x + t * slope;
            const double middle = p * std::round(at / p); // of the field lens there
            slope -= (at - middle) / field_focus;
            at += t * slope;
            through += std::fabs(at) <= p / 2;
        }
        return double(through) / rays;
    };
    const double none = 1e12;
    BOOST_TEST(std::fabs(kept(*half_lost_angle(pair), none) - 0.5) < 1e-3);
    BOOST_TEST(kept(*greatest_angle(pair) * 1.0001, none) < 1e-3);
    BOOST_TEST(kept(1, none) < 0.96); // any angle loses some
    BOOST_TEST(kept(*greatest_angle(pair) * 0.999, field_lens_focus(pair)) == 1);
    BOOST_TEST(kept(*greatest_angle(pair) * 1.001, field_lens_focus(pair)) == 0);
    BOOST_TEST(kept(10, 1.1 * field_lens_focus(pair)) < 1); // no other focus would do
}

BOOST_AUTO_TEST_CASE(equation_3_5_filling_distance)
{
    // W t / (n p); the exact filling aperture is within its paraxial error of it.
    const double w = 200;
    check_printed(filling_distance(sheet(), w, 1.27), 200 * 3.08 / (1.6 * 1.27), 1e-9);
    const auto exact = filling_width(sheet(), filling_distance(sheet(), w, 1.27), 1.27);
    BOOST_REQUIRE(exact);
    BOOST_TEST(std::fabs(*exact / w - 1) < 0.04);
    // Nearly flat lenses: the two agree.
    const LensSheet flat = sheet(0.01);
    BOOST_TEST(std::fabs(*filling_width(flat, filling_distance(flat, w, 0.01), 0.01) / w - 1) <
               1e-5);
}

BOOST_AUTO_TEST_CASE(equation_3_8_pinhole_spread)
{
    check_printed(pinhole_spread(sheet(), 300, 195), 2.002, 0.001);
    // "a difference of 0.8 mm" between the two models, nine pixels at 300 dpi
    const double difference = pinhole_spread(sheet(), 300, 195) -
                              micro_image_width(sheet(), 300, 195);
    check_printed(difference, 0.8, 0.1);
    check_printed(difference / dpi_300, 9, 1);
}

BOOST_AUTO_TEST_CASE(equation_3_9_extended_pinhole_spread)
{
    check_printed(micro_image_width(sheet(), 300, 195), 1.213, 0.001);
    // as printed there: 2 f w / sqrt(4 N^2 d^2 + N^2 w^2 - w^2)
    for (const double d : {50.0, 300.0, 4000.0})
        check_printed(micro_image_width(sheet(), d, 195),
                      2 * 3.08 * 195 /
                          std::sqrt(4 * 1.6 * 1.6 * d * d + 1.6 * 1.6 * 195 * 195 - 195 * 195),
                      1e-9);
}

BOOST_AUTO_TEST_CASE(equation_4_1_figure_4_8_pixels_seen)
{
    // (300/25.4) 3.08 * 5/d for an eye of 5 mm: 181.89/d. "Quickly tends towards zero."
    const double figure[][2] = {{100, 1.8189}, {181.89, 1},    {250, 0.7276},
                                {500, 0.3638}, {1000, 0.1819}, {2000, 0.0909}};
    for (const auto& at : figure)
        check_printed(pixels_seen(sheet(), dpi_300, 5, at[0]), at[1], 0.0001);
}

BOOST_AUTO_TEST_CASE(equation_4_3_pixel_size) { check_printed(dpi_300, 0.085, 0.001); }

BOOST_AUTO_TEST_CASE(equation_4_4_pixel_angle)
{
    check_printed(*pixel_angle(sheet(), dpi_300), 2.52, 0.01);
    BOOST_CHECK(!pixel_angle(sheet(1.27, 3.08, 1.6), 10));
}

BOOST_AUTO_TEST_CASE(equation_4_5_pixel_spread)
{
    // The thesis prints 13.197 mm at 300 mm, the value of its rounded angle with the pixel centred
    // on the axis.
    check_printed(pixel_spread(2.52, 300), 13.197, 0.001);
    check_printed(pixel_spread(*pixel_angle(sheet(), dpi_300), 300), 13.197, 0.002);
    check_printed(pixel_spread(2.52, 300), 13, 1); // "at a point distance of 300mm it is 13mm"
}

BOOST_AUTO_TEST_CASE(equation_4_6_figure_4_12_resolution_against_depth)
{
    // 150/(2 * 1.6 d) times the root of 4 * 3.08^2 + 1.27^2 - 1.6^2 * 1.27^2 = 35.429476: 279.01/d.
    const double figure[][2] = {{10, 27.901}, {20, 13.951}, {50, 5.580},
                                {100, 2.790}, {200, 1.395}, {300, 0.930}};
    for (const auto& at : figure) // printed in line pairs per inch
        check_printed(mm_per_inch * *depth_resolution(sheet(), dpi_300, at[0]), at[1], 0.001);
    // "proportional to 1/d"
    check_printed(*depth_resolution(sheet(), dpi_300, 50) /
                      *depth_resolution(sheet(), dpi_300, 100),
                  2, 1e-12);
    check_printed(*depth_resolution(sheet(), dpi_300, *depth_budget(sheet(), dpi_300)),
                  observer_resolution(1.27, 500, 0), 1e-9);
    BOOST_CHECK(!depth_resolution(sheet(10, 1, 1.6), dpi_300, 50));
    BOOST_CHECK(!depth_budget(sheet(10, 1, 1.6), dpi_300));
}

BOOST_AUTO_TEST_CASE(equation_4_7_figure_4_15_observer_resolution)
{
    // An observer at 500 mm: 5000/(500 - object).
    const double figure[][2] = {{-500, 5}, {-250, 6.6667}, {0, 10},  {100, 12.5},
                                {250, 20}, {300, 25},      {400, 50}};
    for (const auto& at : figure) // printed in line pairs per inch
        check_printed(mm_per_inch * observer_resolution(1.27, 500, at[0]), at[1], 0.0001);
}

BOOST_AUTO_TEST_CASE(equation_5_1_discrete_view_distance)
{
    check_printed(discrete_view_distance(sheet(), 0.085, 125) / 1000, 4.53, 0.01);
}

BOOST_AUTO_TEST_CASE(two_tiers_compress_depth)
{
    // 1/100 = 1/300 + 1/150: a lens of 100 mm images an object 300 mm before it 150 mm behind it,
    // and infinity 100 mm behind it.
    BOOST_TEST(macro_lens_depth(100, 300) == 50);
    BOOST_TEST(std::abs(macro_lens_nearest(80, macro_lens_depth(80, 517)) - 517) < 1e-10);
}

BOOST_AUTO_TEST_CASE(moire_of_lenses_and_pixels)
{
    // 15 pixels a lens: the images of an eye at d are p t/(n d) farther apart, so the pattern
    // repeats after pixel n d/t on the sheet.
    check_printed(*moire_pitch(1.27, sheet(), dpi_300, 300), dpi_300 * 1.6 * 300 / 3.08, 1e-6);
    // At a great distance only the fraction of a pixel per lens counts: 7.087 pixels, 0.6/0.087.
    check_printed(*moire_pitch(0.6, sheet(0.6, 2.65, 1.52), dpi_300, 1e9),
                  0.6 / (0.6 / dpi_300 - 7), 1e-4);
    BOOST_CHECK(!moire_pitch(1.27, sheet(), 1.27 / 15, 1e12));
    // The pitch itself, against the exact place of an eye's image behind a lens near the axis.
    const double x = 1e-3, t = 3.08, n = 1.6, d = 300;
    const double behind = x * t / std::sqrt(n * n * d * d + (n * n - 1) * x * x);
    check_printed(visual_pitch(1.27, sheet(), d) / 1.27, (x + behind) / x, 1e-9);
}

BOOST_AUTO_TEST_CASE(an_eye_sees_the_whole_picture_between_two_distances)
{
    // The zone is 100 mm wide at 400 mm. From 200 mm, lines of sight through the edges of a picture
    // 100 mm wide have passed +-50 mm of the zone's plane, which lies 200 mm behind the eye; from
    // far they come straight through +-50 mm.
    const WholePicture as_wide = whole_picture(400, 100, 100);
    BOOST_TEST(as_wide.nearest == 200);
    BOOST_TEST(!as_wide.farthest.has_value());
    const WholePicture wider = whole_picture(400, 100, 200);
    for (const double eye : {wider.nearest, *wider.farthest}) { // at the zone's edge: +-50 mm
        const double met = 100 * (1 - 400 / eye);
        BOOST_TEST(std::fabs(std::fabs(met) - 50) < 1e-9);
    }
    BOOST_TEST(wider.nearest < 400);
    BOOST_TEST(*wider.farthest > 400);
}

BOOST_AUTO_TEST_SUITE_END()
