// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the correction of a scan's light, and its resampling.
#include "integral/analysis/rectify.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(analysis_scan)

namespace {

/// A linear picture of 160 x 120 pixels.
template <class Light> Image picture(Light light)
{
    Image image = make_image<float>(160, 120, 3, Encoding{Encoding::Kind::linear, 1});
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            store_pixel(image, x, y, light(x + 0.5, y + 0.5));
    return image;
}

double fall(double x, double y)
{
    const double u = x / 80 - 1, v = y / 60 - 1;
    return std::exp(-0.2 * u + 0.1 * v - 0.3 * u * u - 0.05 * u * v);
}

} // namespace

BOOST_AUTO_TEST_CASE(an_uneven_light_is_fitted_beside_dark_things)
{
    const Image scan = picture([](double x, double y) {
        const float v = float(0.4 * fall(x, y) *
                              (x > 20 && x < 60 && y > 30 && y < 80 ? 0.1 : 1)); // a tenth of it
        return Colour{v, v, v, 1};
    });
    ScanLight light;
    light.divide_by_surface(light_grid(scan, 1));
    const double there = light.gain({100, 60}).g * fall(100, 60);
    for (double y = 5; y < 120; y += 10)
        for (double x = 5; x < 160; x += 10)
            BOOST_CHECK_CLOSE(light.gain({x, y}).r * fall(x, y), there, 1);
    BOOST_CHECK_GT(light.unevenness(), 1.5);
}

BOOST_AUTO_TEST_CASE(a_flat_field_is_divided_by)
{
    const Image flat = picture([](double x, double y) {
        return Colour{float(0.5 * fall(x, y)), float(0.4 * fall(x, y)), 0.3f, 1};
    });
    ScanLight light;
    light.divide_by_flat(flat, 160, 120, 1);
    const Colour middle = light.gain({80, 60});
    for (double y = 20; y < 110; y += 13)
        for (double x = 20; x < 150; x += 13) {
            BOOST_CHECK_CLOSE(light.gain({x, y}).r * fall(x, y), middle.r * fall(80, 60), 1);
            BOOST_CHECK_CLOSE(light.gain({x, y}).b, 1, 1e-3);
        }
    BOOST_CHECK_THROW(light.divide_by_flat(flat, 161, 120, 1), std::invalid_argument);
    BOOST_CHECK_THROW(
        light.divide_by_flat(picture([](double x, double) {
                                 return x < 40 ? Colour{0, 0, 0, 1} : Colour{1, 1, 1, 1};
                             }),
                             160, 120, 1),
        std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(casts_are_taken_out)
{
    const Image scan = picture([](double x, double) {
        return x < 80 ? Colour{0.6f, 0.3f, 0.1f, 1} : Colour{0.2f, 0.3f, 0.1f, 1};
    });
    ScanLight grey;
    grey.balance_grey(light_grid(scan, 1));
    const Colour g = grey.channel_gains();
    BOOST_CHECK_CLOSE(g.r * 0.4, g.g * 0.3, 0.01);
    BOOST_CHECK_CLOSE(g.g * 0.3, g.b * 0.1, 0.01);
    BOOST_CHECK_CLOSE(luminance({g.r * 0.4f, g.g * 0.3f, g.b * 0.1f, 1}),
                      luminance({0.4f, 0.3f, 0.1f, 1}), 0.01); // same luminance
    ScanLight white;
    white.balance_white(scan, 90, 10, 20, 20);
    BOOST_CHECK_CLOSE(white.channel_gains().r * 0.2, 1, 0.01);
    BOOST_CHECK_CLOSE(white.channel_gains().b * 0.1, 1, 0.01);
    BOOST_CHECK_THROW(white.balance_white(picture([](double, double) {
                                              return Colour{0.5f, 0, 0.5f, 1};
                                          }),
                                          0, 0, 5, 5),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(resampling_keeps_a_ramp_and_the_black_outside)
{
    const Image scan = picture([](double x, double y) {
        return Colour{float(x / 200), float(y / 200), 0.5f, 1};
    });
    const ScanMap map{{70, 55}, {10, 9.5}, 0.05};
    const Film film = film_of_scan(map, 160, 120, {0.15, 0.15}, Film{});
    BOOST_CHECK_EQUAL(film.width % 2, 0);
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{160, 120}, Vec2{160, 0}}) {
        const Vec2 at = pixel_from_film(film, film_from_scan(map, corner));
        BOOST_CHECK(at.x > -1e-6 && at.y > -1e-6 && at.x < film.width + 1e-6 &&
                    at.y < film.height + 1e-6);
    }
    const auto frame = rectified(scan, map, film, ScanLight(), 1);
    BOOST_REQUIRE(frame);
    const LinearReader pixel(*frame);
    int inside = 0, outside = 0;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const Vec2 at = scan_from_film(map, film_from_pixel(film, {x + 0.5, y + 0.5}));
            const Colour c = pixel(x, y);
            if (at.x > 8 && at.y > 8 && at.x < 152 && at.y < 112) {
                BOOST_REQUIRE_SMALL(c.r - float(at.x / 200), 1e-3f);
                BOOST_REQUIRE_SMALL(c.g - float(at.y / 200), 1e-3f);
                ++inside;
            } else if (at.x < 0 || at.y < 0 || at.x > 160 || at.y > 120) {
                BOOST_REQUIRE_EQUAL(c.b, 0);
                ++outside;
            }
        }
    BOOST_CHECK_GT(inside, 1000);
    BOOST_CHECK_GT(outside, 1000);
}

BOOST_AUTO_TEST_CASE(vignetting_of_the_micro_images_is_divided_out)
{
    LensSheet sheet;
    sheet.arrangement = Arrangement::square;
    const SheetOptics optics(sheet, *filling_aperture(sheet, 300));
    const Film film{300, 240, {0.0847, 0.0847}, Subpixels::none};
    Image frame = make_image<float>(300, 240, 3, Encoding{Encoding::Kind::linear, 1});
    const auto share = [&](Vec2 point) { // share of the light at a film point; -1 where it is dark
        const auto mapped = optics.map(point, LensMapping::automatic);
        if (!mapped.ray)
            return -1.0;
        const double u = 2 * mapped.ray->aperture_point.x / optics.aperture().width,
                     v = 2 * mapped.ray->aperture_point.y / optics.aperture().height;
        return 1 - 0.25 * (u * u + v * v);
    };
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const double light = share(film_from_pixel(film, {x + 0.5, y + 0.5}));
            const float v = light > 0 ? float(0.4 * light) : 0;
            store_pixel(frame, x, y, {v, v, v, 1});
        }
    const double least = flatten_micro_images(frame, film, optics, LensMapping::automatic, 1);
    BOOST_CHECK_LT(least, 0.65);
    double worst = 0;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            if (share(film_from_pixel(film, {x + 0.5, y + 0.5})) > 0)
                worst = std::max(worst, std::fabs(stored_pixel(frame, x, y).g - 0.4));
    BOOST_CHECK_LT(worst, 0.04); // out of 0.4; at the borders it was 0.2 before
}

BOOST_AUTO_TEST_SUITE_END()
