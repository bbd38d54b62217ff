// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests paths of eyes, parts of the sheet, lens blur, and frames made from perspective views,
// against values computed by hand and closed forms.
#include "integral/replay/arrange.h"
#include "integral/views/perspective_views.h"
#include "integral/views/quilt.h"
#include "tests/unit/replay_frames.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(replay_paths)

namespace {

void is_at(const Eye& eye, double x, double y, double distance)
{
    BOOST_TEST(std::fabs(eye.x - x) < 1e-9);
    BOOST_TEST(std::fabs(eye.y - y) < 1e-9);
    BOOST_TEST(std::fabs(eye.distance - distance) < 1e-9);
}

} // namespace

BOOST_AUTO_TEST_CASE(paths_by_hand)
{
    const Eye middle{10, -5, 300};
    const Vec2 zone{200, 120};
    auto eyes = eye_path(EyePath::sweep, middle, zone, {}, 3);
    BOOST_REQUIRE(eyes.size() == 3);
    is_at(eyes[0], -90, -5, 300);
    is_at(eyes[1], 10, -5, 300);
    is_at(eyes[2], 110, -5, 300);
    eyes = eye_path(EyePath::sweep, middle, zone, 40, 5);
    is_at(eyes[0], -10, -5, 300);
    is_at(eyes[4], 30, -5, 300);

    eyes = eye_path(EyePath::turntable, {0, 7, 300}, zone, 60, 3);
    is_at(eyes[0], -150, 7, 300 * std::sqrt(0.75));
    is_at(eyes[1], 0, 7, 300);
    is_at(eyes[2], 150, 7, 300 * std::sqrt(0.75));
    eyes = eye_path(EyePath::turntable, {0, 0, 300}, zone, {}, 2); // towards the zone's edges
    BOOST_TEST(std::fabs(eyes[1].x / eyes[1].distance - 100.0 / 300) < 1e-12);

    eyes = eye_path(EyePath::circle, middle, zone, {}, 4);
    is_at(eyes[0], 10 - 80, -5, 300);
    is_at(eyes[1], 10, -5 + 48, 300);
    is_at(eyes[2], 10 + 80, -5, 300);
    is_at(eyes[3], 10, -5 - 48, 300);
    is_at(eye_path(EyePath::circle, middle, zone, 20, 4)[1], 10, -5 + 6, 300);

    // A zone that is a point: a circle if a span is given, otherwise no movement.
    is_at(eye_path(EyePath::circle, middle, {0, 0}, 20, 4)[1], 10, -5 + 10, 300);
    is_at(eye_path(EyePath::circle, middle, {0, 0}, {}, 4)[1], 10, -5, 300);

    eyes = eye_path(EyePath::dolly, middle, zone, {}, 3);
    is_at(eyes[0], 10, -5, 600);
    is_at(eyes[1], 10, -5, 300);
    is_at(eyes[2], 10, -5, 150);
    is_at(eye_path(EyePath::dolly, middle, zone, 9, 2)[0], 10, -5, 900);
    is_at(eye_path(EyePath::sweep, middle, zone, {}, 1)[0], 10, -5, 300);
}

BOOST_AUTO_TEST_CASE(the_viewing_zone_is_the_aperture_and_no_more_than_fills_a_lens)
{
    FrameMetadata m = geometry({Arrangement::square, 0, {0, 0}}, 10, 10, 0.1);
    // 2 d tan(arcsin(n sin(atan(p/2t)))), in plain trigonometry
    const double fills = 2 * 300 * std::tan(std::asin(1.6 * std::sin(std::atan(1.27 / 2 / 3.08))));
    m.aperture.width = 50;
    m.aperture.height = std::numeric_limits<double>::infinity();
    const Vec2 zone = viewing_zone(m, 600);
    BOOST_TEST(std::fabs(zone.x - 100) < 1e-9);
    BOOST_TEST(std::fabs(zone.y - 2 * fills) < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_part_is_cut_from_the_whole)
{
    for (const Case& c : cases) {
        FrameMetadata m = geometry(c, 256, 128, 0.125);
        m.film.pixel_pitch.y = 0.125; // powers of two: the same points to the bit
        const Frame frame = frame_of_places(m);
        View view{{-40, 25, 256}, 512, 256, 2};
        const auto whole = replay(frame, view);
        view.part = {{4, -3}, 8, 4}; // pixels 256 + 64 - 64 on, and 128 + 48 - 32 on
        view.width = 128;
        view.height = 64;
        const auto part = replay(frame, view);
        BOOST_REQUIRE((whole && part));
        BOOST_TEST((part->samples == part_of(*whole, 256, 144, 128, 64).samples));
        View shaped;
        shaped.part = view.part;
        set_view_size(shaped, m.film, 500);
        BOOST_TEST(shaped.width == 500);
        BOOST_TEST(shaped.height == 250);
    }
}

BOOST_AUTO_TEST_CASE(blur_shows_the_part_of_its_spot_that_is_lit)
{
    // The film is white right of an edge. A spot whose middle is u radii left of it holds (acos u -
    // u sqrt(1 - u^2))/pi white.
    FrameMetadata m = geometry({Arrangement::square, 0, {0, 0}}, 2000, 400, 0.002);
    m.film.pixel_pitch.y = 0.02;
    constexpr double edge = 0.1, diameter = 0.4;
    Frame frame{make_image<float>(m.film.width, m.film.height, 3, linear), {}};
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x)
            if (film_from_pixel(m.film, {x + 0.5, y + 0.5}).x > edge)
                store_pixel(frame.image, x, y, {1, 1, 1, 1});
    set_metadata(frame, m);
    for (const double eye_x : {-60.0, -30.0, -20.0, -10.0, 0.0, 10.0, 30.0}) {
        View view{{eye_x, 0, 300}, 16, 16, 8};
        view.blur = diameter;
        view.part = {{0, 0}, 1e-3, 1e-3}; // the middle of the lens at 0, 0
        const auto image = replay(frame, view);
        BOOST_REQUIRE(image);
        double light = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                light += stored_pixel(*image, x, y).g / 256;
        const double u = std::clamp(
            (edge - film_point(m.sheet, {0, 0}, {0, 0}, view.eye).x) / (diameter / 2), -1.0, 1.0);
        const double lit = (std::acos(u) - u * std::sqrt(1 - u * u)) / pi;
        BOOST_TEST_MESSAGE("eye at " << eye_x << ": " << light << ", closed form " << lit);
        BOOST_TEST(std::fabs(light - lit) < 0.01);
    }
}

BOOST_AUTO_TEST_CASE(spot_and_pupil_are_spread_independently)
{
    // The film is a product of two ramps, one for the spot and one for the pupil. If the points of
    // the spot depended on the pupil's, the mean of the product would not be the product of the
    // means.
    FrameMetadata m = geometry({Arrangement::square, 0, {0, 0}}, 2000, 2000, 0.002);
    m.film.pixel_pitch.y = 0.002;
    Frame frame{make_image<float>(m.film.width, m.film.height, 3, linear), {}};
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x) {
            const Vec2 p = film_from_pixel(m.film, {x + 0.5, y + 0.5});
            store_pixel(frame.image, x, y,
                        {float(p.x * p.x), float(p.x * p.y), float(p.y * p.y), 1});
        }
    set_metadata(frame, m);
    View view{{0, 0, 300}, 32, 32, 8};
    view.part = {{0, 0}, 1e-3, 1e-3};
    const auto moments = [&](double pupil, double blur) {
        view.pupil = pupil;
        view.blur = blur;
        const auto image = replay(frame, view);
        Colour sum{0, 0, 0, 0};
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const Colour c = stored_pixel(*image, x, y);
                sum = {sum.r + c.r / 1024, sum.g + c.g / 1024, sum.b + c.b / 1024, 1};
            }
        return sum;
    };
    const Colour pupil = moments(40, 0), spot = moments(0, 0.2), both = moments(40, 0.2);
    BOOST_TEST(spot.r > 0.002);
    BOOST_TEST(pupil.r > 0.002);
    BOOST_TEST(std::fabs(both.r - pupil.r - spot.r) < 0.02 * both.r);
    BOOST_TEST(std::fabs(both.b - pupil.b - spot.b) < 0.02 * both.b);
    BOOST_TEST(std::fabs(both.g) < 0.02 * both.r);
}

BOOST_AUTO_TEST_CASE(a_frame_of_what_eyes_see)
{
    // Light is a linear function of the point where a line meets the plane at depth z. It is then
    // linear in the positions of eye and sheet point, so that interpolation of views is exact.
    constexpr double z = 40;
    const EyeGrid eyes{{180, 140}, 280};
    for (const Case& c : cases)
        for (const Subpixels subpixels : {Subpixels::none, Subpixels::bgr}) {
            FrameMetadata m = geometry(c, 200, 150, 0.2);
            m.film.subpixels = subpixels;
            const auto light = [&](Vec2 sheet, Vec2 eye) {
                const double x = sheet.x + (sheet.x - eye.x) * z / eyes.distance,
                             y = sheet.y + (sheet.y - eye.y) * z / eyes.distance;
                return Colour{float(0.5 + 0.004 * x), float(0.5 + 0.003 * y),
                              float(0.5 + 0.002 * (x + y)), 1};
            };
            const ViewGrid grid{5, 4};
            std::vector<Image> views(grid.count(), make_image<float>(80, 60, 3, linear));
            const View window{{}, 80, 60};
            for (int k = 0; k < grid.count(); ++k) {
                const Vec2 eye{((k % 5 + 0.5) / 5 - 0.5) * eyes.zone.x,
                               ((k / 5 + 0.5) / 4 - 0.5) * eyes.zone.y};
                for (int y = 0; y < 60; ++y)
                    for (int x = 0; x < 80; ++x)
                        store_pixel(views[k], x, y, light(view_point(m, window, x, y), eye));
            }
            const auto frame = frame_from_eye_views(views, m, grid, eyes);
            BOOST_REQUIRE(frame);
            int judged = 0;
            double worst = 0;
            for (int y = 4; y < m.film.height - 4; ++y)
                for (int x = 4; x < m.film.width - 4; ++x)
                    for (int channel = 0; channel < 3; ++channel) {
                        // The ray by Snell's law with angles. For lenticular lenses the slit
                        // decides the height at which light leaves.
                        const double shift = subpixels == Subpixels::none ? 0 : (1 - channel) / 3.0;
                        const Vec2 f = film_from_pixel(m.film, {x + 0.5 + shift, y + 0.5});
                        double margin;
                        const Vec2 pole = nearest_pole(m.sheet, f, margin);
                        if (margin < 0.3 || m.sheet.arrangement == Arrangement::lenticular)
                            continue;
                        const double off = std::hypot(pole.x - f.x, pole.y - f.y);
                        const double out = std::asin(m.sheet.ior *
                                                     std::sin(std::atan(off / m.sheet.thickness)));
                        const double reach = off > 0 ? eyes.distance * std::tan(out) / off : 0;
                        const Vec2 eye{pole.x + reach * (pole.x - f.x),
                                       pole.y + reach * (pole.y - f.y)};
                        if (std::fabs(eye.x) > 0.4 * eyes.zone.x ||
                            std::fabs(eye.y) > 0.37 * eyes.zone.y)
                            continue;
                        const Colour expected = light(pole, eye), got = stored_pixel(*frame, x, y);
                        const float e[] = {expected.r, expected.g, expected.b},
                                    g[] = {got.r, got.g, got.b};
                        worst = std::max(worst, double(std::fabs(e[channel] - g[channel])));
                        ++judged;
                    }
            if (m.sheet.arrangement != Arrangement::lenticular)
                BOOST_TEST(judged > 1000);
            BOOST_TEST(worst < 1e-5);
        }
    // Lenticular: the axis's point at which the light leaves lies at the height from which an eye
    // of the slit's plane sees the film point.
    const FrameMetadata m = geometry(cases[0], 200, 150, 0.2);
    std::vector<Image> views(2, make_image<float>(200, 150, 3, linear));
    for (Image& view : views)
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 200; ++x)
                store_pixel(view, x, y, {float(&view - views.data()), float(y / 150.0), 0, 1});
    const auto frame = frame_from_eye_views(views, m, {2, 1}, {{150, 0}, 300});
    const SheetOptics optics(m.sheet, m.aperture);
    for (int y = 10; y < 140; ++y) {
        const auto
            ray = optics.map(film_from_pixel(m.film, {60.5, y + 0.5}), LensMapping::automatic).ray;
        BOOST_REQUIRE(ray);
        const double row = pixel_from_film(m.film, ray->pole).y - 0.5;
        BOOST_TEST(std::fabs(stored_pixel(*frame, 60, y).g - row / 150) < 1e-5);
        BOOST_TEST(std::fabs(stored_pixel(*frame, 60, y).r -
                             std::clamp((ray->aperture_point.x / 150 + 0.5) * 2 - 0.5, 0.0, 1.0)) <
                   1e-5);
    }
    BOOST_CHECK_THROW(frame_from_eye_views(views, m, {3, 1}, {{150, 0}, 300}),
                      std::invalid_argument);
    views[1] = make_image<float>(20, 15, 3, linear);
    BOOST_CHECK_THROW(frame_from_eye_views(views, m, {2, 1}, {{150, 0}, 300}),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_quilt_whose_views_leave_a_rest)
{
    Image quilt = make_image<std::uint8_t>(7, 5, 3, Encoding());
    auto& samples = std::get<std::vector<std::uint8_t>>(quilt.samples);
    for (std::size_t k = 0; k < samples.size(); ++k)
        samples[k] = std::uint8_t(k / 3);             // the pixel's number
    const auto views = views_of_quilt(quilt, {3, 2}); // 2 x 2 pixels each; spare column and row
    BOOST_REQUIRE(views.size() == 6);
    const auto first = [&](int k) {
        return int(std::get<std::vector<std::uint8_t>>(views[k].samples).at(0));
    };
    BOOST_TEST(first(0) == 3 * 7);
    BOOST_TEST(first(2) == 3 * 7 + 4);
    BOOST_TEST(first(3) == 7);
    BOOST_TEST(first(5) == 7 + 4);
}

BOOST_AUTO_TEST_SUITE_END()
