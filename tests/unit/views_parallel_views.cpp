// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests parallel views: their conversion from frames of known light fields, and back.
#include "integral/views/parallel_views.h"

#include "integral/frame/image.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(views_parallel_views)

namespace {

const Encoding linear{Encoding::Kind::linear, 1};

FrameMetadata geometry(Arrangement arrangement, double pitch, double slant, Vec2 offset, int width,
                       int height, Vec2 pixel)
{
    FrameMetadata m;
    m.sheet = {arrangement, pitch, 3.08, 1.6, slant, offset};
    m.film = {width, height, pixel};
    m.aperture = {300, 200, 100, ApertureShape::rectangle};
    return m;
}

template <class Sample> Frame noise(const FrameMetadata& m, int channels, Encoding encoding)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> value(0, 255);
    Frame frame;
    frame.image = make_image<Sample>(m.film.width, m.film.height, channels, encoding);
    for (Sample& sample : std::get<std::vector<Sample>>(frame.image.samples))
        sample = Sample(value(random));
    set_metadata(frame, m);
    return frame;
}

} // namespace

BOOST_AUTO_TEST_CASE(whole_pixels_a_lens_lose_nothing)
{
    // odd and even numbers of pixels, of lenses, poles on pixels' centres, on their borders and in
    // between
    struct Sheet {
        Arrangement arrangement;
        int across, down;
    };
    const Sheet sheets[] = {{Arrangement::lenticular, 15, 1},
                            {Arrangement::lenticular, 6, 1},
                            {Arrangement::square, 15, 15},
                            {Arrangement::square, 8, 4},
                            {Arrangement::square, 1, 1}};
    for (const Sheet& s : sheets)
        for (const int width : {7, 31, 90, 120, 127})
            for (const double shift : {0.0, 0.5, 0.27}) {
                const double pitch = 1.2, px = pitch / s.across,
                             py = s.arrangement == Arrangement::square ? pitch / s.down : 0.1;
                const FrameMetadata m = geometry(s.arrangement, pitch, 0, {shift * px, -shift * py},
                                                 width, 61, {px, py});
                const ViewGrid grid = natural_views(m);
                BOOST_TEST(grid.columns == s.across);
                BOOST_TEST(grid.rows == s.down);
                BOOST_TEST(views_are_exact(m, grid));
                const Frame frame = noise<std::uint8_t>(m, 3, {});
                const auto views = parallel_views(frame, grid, 2);
                BOOST_REQUIRE(views);
                BOOST_TEST((*views)[0].width <= width / s.across + 2);
                const auto again = frame_from_parallel_views(*views, m, grid, 2);
                BOOST_REQUIRE(again);
                BOOST_TEST((again->samples == frame.image.samples));
            }
}

BOOST_AUTO_TEST_CASE(the_thesis_s_15_views_are_every_fifteenth_pixel)
{
    // 1.27 mm at 300 dpi: view 0 of the thesis is the first pixel of every lens, which is seen from
    // the far right
    const double pixel = 25.4 / 300;
    const FrameMetadata m = geometry(Arrangement::lenticular, 1.27, 0, {0, 0}, 15 * 9, 4,
                                     {pixel, pixel});
    Frame frame = noise<std::uint16_t>(m, 4, {});
    const ViewGrid grid = natural_views(m);
    BOOST_REQUIRE(grid.columns == 15);
    const auto views = parallel_views(frame, grid);
    BOOST_REQUIRE(views);
    BOOST_REQUIRE(views->size() == 15u);
    for (int k = 0; k < 15; ++k)
        for (int lens = 0; lens < 9; ++lens)
            for (int y = 0; y < 4; ++y) {
                const Colour view = stored_pixel((*views)[14 - k], lens, y),
                             film = stored_pixel(frame.image, 15 * lens + k, y);
                BOOST_TEST(
                    (view.r == film.r && view.g == film.g && view.b == film.b && view.a == film.a));
            }
}

BOOST_AUTO_TEST_CASE(a_view_is_what_a_far_eye_sees)
{
    // The colour of each film pixel is its own position. A view has, for each lens, the position
    // behind it that an eye at an infinite distance in the view's direction sees. Far from the
    // film's edge, that is the middle of the direction's part of the lens.
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 9.46, -30.0}) {
            FrameMetadata m = geometry(arrangement, 1.27, slant, {0.2, -0.1}, 300, 200,
                                       {0.0847, 0.07});
            Frame frame;
            frame.image = make_image<float>(m.film.width, m.film.height, 3, linear);
            for (int y = 0; y < m.film.height; ++y)
                for (int x = 0; x < m.film.width; ++x) {
                    const Vec2 at = film_from_pixel(m.film, {x + 0.5, y + 0.5});
                    store_pixel(frame.image, x, y, {float(at.x), float(at.y), 1, 1});
                }
            set_metadata(frame, m);
            const ViewGrid grid{7, arrangement == Arrangement::lenticular ? 1 : 5};
            const auto views = parallel_views(frame, grid);
            BOOST_REQUIRE(views);
            const double a = slant * 3.14159265358979323846 / 180;
            const LensWindow window = lens_window(m);
            int judged = 0;
            double worst = 0;
            for (int k = 0; k < grid.count(); ++k)
                for (int row = 0; row < window.rows; ++row)
                    for (int column = 0; column < window.columns; ++column) {
                        // the pole, by the lattice's definition
                        double u, v = 0;
                        if (arrangement == Arrangement::hexagonal) {
                            const int j = int(window.first.j) - row;
                            if ((column & 1) != (j & 1))
                                continue; // the second pixel of the lens before
                            u = 1.27 * (double(window.first.i) + column / 2 + ((j & 1) ? 0.5 : 0));
                            v = 1.27 * std::sqrt(0.75) * j;
                        } else {
                            u = 1.27 * double(window.first.i + column);
                            v = arrangement == Arrangement::square
                                    ? 1.27 * double(window.first.j - row)
                                    : 0;
                        }
                        double x = 0.2 + u * std::cos(a) - v * std::sin(a),
                               y = -0.1 + u * std::sin(a) + v * std::cos(a);
                        const double part_x = 0.5 - (k % grid.columns + 0.5) / grid.columns,
                                     part_y = 0.5 - (k / grid.columns + 0.5) / grid.rows;
                        if (arrangement == Arrangement::lenticular) {
                            const double film_y = film_from_pixel(m.film, {0, row + 0.5}).y;
                            x -= (film_y - y) * std::tan(a);
                            y = film_y;
                            x += part_x * 1.27 / std::cos(a);
                        } else {
                            const double height = 1.27 * (arrangement == Arrangement::hexagonal
                                                              ? std::sqrt(0.75)
                                                              : 1);
                            x += part_x * 1.27 * std::cos(a) - part_y * height * std::sin(a);
                            y += part_x * 1.27 * std::sin(a) + part_y * height * std::cos(a);
                        }
                        const Colour seen = stored_pixel((*views)[k], column, row);
                        const Vec2 pixel = pixel_from_film(m.film, {x, y});
                        if (pixel.x < 1 || pixel.y < 1 || pixel.x > 299 || pixel.y > 199)
                            continue;
                        worst = std::max({worst, std::fabs(seen.r - x), std::fabs(seen.g - y),
                                          std::fabs(seen.b - 1.0)});
                        ++judged;
                    }
            BOOST_TEST(judged > 1000);
            BOOST_TEST(worst < 1e-5); // exact for a linear field, up to single precision
        }
}

BOOST_AUTO_TEST_CASE(far_eyes_see_the_parallel_views_upright)
{
    // Where lenses stand upright and each has a pixel of the picture, the view is the lenses'
    // pixels to the bit; slanted lenses see the film point behind the axis that is nearest to each
    // point of the sheet, by the lattice's definition.
    for (const Arrangement arrangement : {Arrangement::lenticular, Arrangement::square}) {
        const double pixel = 0.125;
        const int height = arrangement == Arrangement::square ? 8 * 21 : 100;
        FrameMetadata m = geometry(arrangement, 1, 0, {0, 0}, 8 * 31, height,
                                   {pixel, pixel}); // 31 lenses, the middle one at 0
        Frame frame{make_image<std::uint8_t>(m.film.width, m.film.height, 3, {}), {}};
        std::mt19937 random(3);
        for (auto& sample : std::get<std::vector<std::uint8_t>>(frame.image.samples))
            sample = std::uint8_t(random());
        set_metadata(frame, m);
        const ViewGrid grid = natural_views(m);
        const auto views = parallel_views(frame, grid);
        const auto eyes = far_eyes(m, grid);
        BOOST_REQUIRE(views);
        for (int k = 0; k < grid.count(); ++k) {
            BOOST_REQUIRE(eyes[k]);
            const auto seen = replay(frame,
                                     View{*eyes[k], (*views)[k].width, (*views)[k].height, 1});
            BOOST_TEST((seen->samples == (*views)[k].samples));
        }
    }
    for (const double slant : {12.0, -30.0}) {
        FrameMetadata m = geometry(Arrangement::lenticular, 1.27, slant, {0.2, -0.1}, 400, 300,
                                   {0.0847, 0.07});
        Frame frame{make_image<float>(m.film.width, m.film.height, 3, linear), {}};
        for (int y = 0; y < m.film.height; ++y)
            for (int x = 0; x < m.film.width; ++x) {
                const Vec2 at = film_from_pixel(m.film, {x + 0.5, y + 0.5});
                store_pixel(frame.image, x, y, {float(at.x), float(at.y), 1, 1});
            }
        set_metadata(frame, m);
        const ViewGrid grid{5, 1};
        const auto eyes = far_eyes(m, grid);
        const double a = slant * 3.14159265358979323846 / 180;
        int judged = 0;
        for (int k = 0; k < 5; ++k) {
            const auto seen = replay(frame, View{*eyes[k], 40, 30, 1});
            for (int y = 3; y < 27; ++y)
                for (int x = 3; x < 37; ++x) {
                    const double px = ((x + 0.5) / 40 - 0.5) * 400 * 0.0847,
                                 py = (0.5 - (y + 0.5) / 30) * 300 * 0.07;
                    const double across = (px - 0.2) * std::cos(a) + (py + 0.1) * std::sin(a),
                                 off = across - 1.27 * std::round(across / 1.27);
                    if (std::fabs(off) > 0.62)
                        continue; // at a lens's border
                    // the axis's nearest point, moved along its row to the middle of the view's
                    // part of the lens
                    const double fx = px - off * std::cos(a) +
                                      (0.5 - (k + 0.5) / 5) * 1.27 / std::cos(a),
                                 fy = py - off * std::sin(a);
                    const Colour c = stored_pixel(*seen, x, y);
                    BOOST_TEST(std::fabs(c.r - fx) < 0.0847 / 2 + 1e-4);
                    BOOST_TEST(std::fabs(c.g - fy) < 0.07 / 2 + 1e-4);
                    ++judged;
                }
        }
        BOOST_TEST(judged > 2000);
    }
}

BOOST_AUTO_TEST_CASE(fractional_pixels_a_lens_come_back_nearly)
{
    // The error of converting a smooth light field to views and back, where lenses and pixels do
    // not coincide. Finer views have smaller errors.
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 9.46}) {
            const FrameMetadata m = geometry(arrangement, 1.124, slant, {0.3, 0.1}, 400, 260,
                                             {0.0847, 0.0847});
            const Lattice lattice(m.sheet);
            Frame frame;
            frame.image = make_image<float>(m.film.width, m.film.height, 3, linear);
            for (int y = 0; y < m.film.height; ++y)
                for (int x = 0; x < m.film.width; ++x) {
                    const Vec2 at = film_from_pixel(m.film, {x + 0.5, y + 0.5});
                    const double off = dot(lattice.across(),
                                           at - lattice.pole(lattice.nearest(at)));
                    const float value = float(0.5 + 0.3 * std::sin(0.4 * at.x + 2 * off) +
                                              0.2 * std::cos(0.5 * at.y));
                    store_pixel(frame.image, x, y, {value, value, value, 1});
                }
            set_metadata(frame, m);
            double previous = 1;
            for (const int times : {1, 2}) {
                ViewGrid grid = natural_views(m);
                grid.columns *= times;
                grid.rows *= arrangement == Arrangement::lenticular ? 1 : times;
                BOOST_TEST(!views_are_exact(m, grid));
                const auto views = parallel_views(frame, grid);
                const auto again = frame_from_parallel_views(*views, m, grid);
                BOOST_REQUIRE(again);
                double squares = 0;
                int pixels = 0;
                for (int y = 20; y < m.film.height - 20; ++y)
                    for (int x = 20; x < m.film.width - 20; ++x, ++pixels) {
                        const double off = stored_pixel(*again, x, y).g -
                                           stored_pixel(frame.image, x, y).g;
                        squares += off * off;
                    }
                const double rms = std::sqrt(squares / pixels);
                BOOST_TEST_MESSAGE("arrangement " << int(arrangement) << ", slant " << slant << ", "
                                                  << times << " times: RMS " << rms);
                BOOST_TEST(rms < 0.05);
                BOOST_TEST(rms < previous);
                previous = rms;
            }
        }
}

BOOST_AUTO_TEST_CASE(stripes_have_directions_of_their_own)
{
    // The value of each channel of each pixel is the position of its stripe across the lens. A view
    // of a film with subpixels then has one grey, given by its direction. Converted back, each
    // stripe has its position again. If subpixels are ignored, red and blue are wrong by a third of
    // a pixel.
    for (const Subpixels order : {Subpixels::rgb, Subpixels::bgr}) {
        FrameMetadata m = geometry(Arrangement::lenticular, 1.27, 9.46, {0.1, 0}, 240, 120,
                                   {0.207, 0.207});
        m.film.subpixels = order;
        const Lattice lattice(m.sheet);
        const double breadth = 1.27 / lattice.across().x;
        const auto part = [&](int x, int y, int channel) { // of the lens's width, from its axis
            const double shift = (order == Subpixels::rgb ? channel - 1 : 1 - channel) / 3.0;
            const Vec2 at = film_from_pixel(m.film, {x + 0.5 + shift, y + 0.5});
            return dot(lattice.across(), at - lattice.pole(lattice.nearest(at))) / 1.27;
        };
        Frame frame;
        frame.image = make_image<float>(m.film.width, m.film.height, 3, linear);
        for (int y = 0; y < m.film.height; ++y)
            for (int x = 0; x < m.film.width; ++x)
                store_pixel(frame.image, x, y,
                            {float(part(x, y, 0)), float(part(x, y, 1)), float(part(x, y, 2)), 1});
        set_metadata(frame, m);
        const ViewGrid grid{12, 1};
        BOOST_TEST(!views_are_exact(m, natural_views(m)));
        const auto views = parallel_views(frame, grid);
        int judged = 0;
        double worst = 0;
        for (int k = 0; k < grid.columns; ++k) {
            const double expected = 0.5 -
                                    (k + 0.5) / grid.columns; // of the lens's width along a row
            if ((0.5 - std::fabs(expected)) * breadth < 1.5 * 0.207)
                continue; // interpolated with the next lens's
            const Image& view = (*views)[k];
            const LensIndex first = lens_window(m).first;
            for (int y = 2; y < view.height - 2; ++y)
                for (int x = 0; x < view.width; ++x) {
                    const Vec2 pole = lattice.pole({first.i + x, 0}), along = lattice.along();
                    const double axis = pole.x +
                                        (film_from_pixel(m.film, {0, y + 0.5}).y - pole.y) *
                                            along.x / along.y;
                    if (std::fabs(axis + expected * breadth) >
                        (0.5 * m.film.width - 2) * m.film.pixel_pitch.x)
                        continue; // outside the film
                    ++judged;
                    const Colour seen = stored_pixel(view, x, y);
                    worst = std::max({worst, std::fabs(seen.r - expected),
                                      std::fabs(seen.g - expected), std::fabs(seen.b - expected)});
                }
        }
        BOOST_TEST(judged > 5000);
        BOOST_TEST(worst < 1e-5);
        const auto again = frame_from_parallel_views(*views, m, grid);
        worst = 0;
        for (int y = 2; y < m.film.height - 2; ++y)
            for (int x = 8; x < m.film.width - 8; ++x) {
                const Colour seen = stored_pixel(*again, x, y);
                const float channels[3] = {seen.r, seen.g, seen.b};
                for (int channel = 0; channel < 3; ++channel)
                    if (std::fabs(part(x, y, channel)) < 0.15) // between views of its own pixels
                        worst = std::max(worst, std::fabs(channels[channel] - part(x, y, channel)));
            }
        BOOST_TEST(worst < 1e-5);
    }
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused)
{
    const FrameMetadata m = geometry(Arrangement::square, 1.27, 0, {0, 0}, 60, 45,
                                     {0.0847, 0.0847});
    const Frame frame = noise<std::uint8_t>(m, 3, {});
    auto views = *parallel_views(frame, {3, 2});
    BOOST_CHECK_THROW(frame_from_parallel_views(views, m, {3, 3}), std::invalid_argument);
    views[4] = make_image<std::uint8_t>(views[0].width + 1, views[0].height, 3, {});
    BOOST_CHECK_THROW(frame_from_parallel_views(views, m, {3, 2}), std::invalid_argument);
    views[4] = make_image<float>(views[0].width, views[0].height, 3, {});
    BOOST_CHECK_THROW(frame_from_parallel_views(views, m, {3, 2}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
