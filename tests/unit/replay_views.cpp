// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares replayed views with views known in closed form, by independent formulas.
#include "tests/unit/replay_frames.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(replay_views)

BOOST_AUTO_TEST_CASE(each_view_pixel_shows_the_film_point_behind_its_lens)
{
    for (const Case& c : cases) {
        const FrameMetadata m = geometry(c, 1000, 900, 0.02);
        const Frame frame = frame_of_places(m);
        for (const Eye eye :
             {Eye{0, 0, 300}, Eye{-80, 35, 250}, Eye{500, -200, 150}, Eye{3, 1, 2}}) {
            const View view{eye, 211, 97, 1};
            const auto image = replay(frame, view);
            BOOST_REQUIRE(image);
            int judged = 0, black = 0;
            for (int y = 0; y < view.height; ++y)
                for (int x = 0; x < view.width; ++x) {
                    const Vec2 q = view_point(m, view, x, y);
                    double margin;
                    const Vec2 pole = nearest_pole(m.sheet, q, margin);
                    if (margin < 1e-6)
                        continue; // on a border: either lens will do
                    const Vec2 f = film_point(m.sheet, pole, q, eye);
                    const double u = f.x / (m.film.width * m.film.pixel_pitch.x) + 0.5;
                    const double v = 0.5 - f.y / (m.film.height * m.film.pixel_pitch.y);
                    const Colour seen = stored_pixel(*image, x, y);
                    const double half_u = 0.5 / m.film.width + 1e-6,
                                 half_v = 0.5 / m.film.height + 1e-6;
                    if (u < -1e-9 || u > 1 + 1e-9 || v < -1e-9 || v > 1 + 1e-9) {
                        BOOST_TEST(seen.b == 0);
                        ++black;
                    } else if (u > 1e-9 && u < 1 - 1e-9 && v > 1e-9 && v < 1 - 1e-9) {
                        BOOST_TEST(
                            (std::fabs(seen.r - u) <= half_u && std::fabs(seen.g - v) <= half_v),
                            "arrangement " << int(c.arrangement) << " slant " << c.slant
                                           << " pixel " << x << "," << y << ": " << seen.r << ","
                                           << seen.g << " instead of " << u << "," << v);
                        ++judged;
                    }
                }
            BOOST_TEST(judged > view.width * view.height / 2);
            BOOST_TEST(judged + black > view.width * view.height * 9 / 10);
        }
    }
}

BOOST_AUTO_TEST_CASE(each_channel_of_a_film_of_subpixels_is_seen_at_its_own_stripe)
{
    // The value of each channel of a film pixel is the position of its stripe's centre, in pixels.
    // The eye sees a value within half a pixel of the film point behind the lens, or within one
    // pixel if the stripes are ignored.
    for (const Subpixels order : {Subpixels::rgb, Subpixels::bgr})
        for (const Case& c : cases) {
            FrameMetadata m = geometry(c, 300, 200, 0.05);
            m.film.subpixels = order;
            const double red = order == Subpixels::rgb ? -1 / 3.0 : 1 / 3.0;
            Frame frame;
            frame.image = make_image<float>(m.film.width, m.film.height, 3, linear);
            for (int y = 0; y < m.film.height; ++y)
                for (int x = 0; x < m.film.width; ++x)
                    store_pixel(frame.image, x, y,
                                {float(x + 0.5 + red), float(x + 0.5), float(x + 0.5 - red), 1});
            set_metadata(frame, m);
            Frame as_pixels = frame;
            as_pixels.metadata->film.subpixels = Subpixels::none;
            const View view{{-40, 25, 250}, 101, 67, 1};
            const auto image = replay(frame, view), ignored = replay(as_pixels, view);
            double worst = 0, worst_ignored = 0;
            int judged = 0;
            for (int y = 0; y < view.height; ++y)
                for (int x = 0; x < view.width; ++x) {
                    const Vec2 q = view_point(m, view, x, y);
                    double margin;
                    const Vec2 pole = nearest_pole(m.sheet, q, margin);
                    const Vec2 f = film_point(m.sheet, pole, q, view.eye);
                    const double px = f.x / m.film.pixel_pitch.x + 150,
                                 py = 100 - f.y / m.film.pixel_pitch.y;
                    if (margin < 1e-6 || px < 1 || px > 299 || py < 0.01 || py > 199.99)
                        continue;
                    const auto farthest = [&](const Image& seen) {
                        const Colour color = stored_pixel(seen, x, y);
                        return std::max({std::fabs(color.r - px), std::fabs(color.g - px),
                                         std::fabs(color.b - px)});
                    };
                    worst = std::max(worst, farthest(*image));
                    worst_ignored = std::max(worst_ignored, farthest(*ignored));
                    ++judged;
                }
            BOOST_TEST(judged > 4000);
            BOOST_TEST(worst < 0.5 + 1e-4);
            BOOST_TEST(worst_ignored > 0.8); // 5/6
        }
}

namespace {

/// The mean positions of the bar's two edges, mm on the sheet, found from the light that each
/// channel has to the left and to the right of the bar's middle.
struct Edges {
    double left[3], right[3];
};

Edges edges_of(const Frame& frame, Eye eye)
{
    const Film& film = frame.metadata->film;
    View view{eye, 0, 0, 3};
    set_view_size(view, film, 600);
    const auto image = replay(frame, view);
    const LinearReader light(*image);
    const double pixel = film.width * film.pixel_pitch.x / view.width /
                         view.height; // mm, a row's share
    const int middle = int(
        view.width * (0.5 + eye.x * 20 / (eye.distance + 20) / (film.width * film.pixel_pitch.x)));
    Edges edges{};
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Colour seen = light(x, y);
            double* side = x < middle ? edges.left : edges.right;
            const double width = (x < middle ? -1 : 1) * pixel;
            side[0] += width * seen.r;
            side[1] += width * seen.g;
            side[2] += width * seen.b;
        }
    return edges;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_white_bar_on_a_film_of_subpixels_has_no_coloured_edges)
{
    // A panel of 0.207 mm pixels under slanted lenses, and a white bar 20 mm behind the sheet. If
    // the stripes were ignored, channels would be seen z/(t n) times a third of a pixel apart.
    FrameMetadata m;
    m.sheet = {Arrangement::lenticular, 1.27, 3.08, 1.6, 9.46, {}};
    m.film = {480, 300, {0.207, 0.207}, Subpixels::rgb};
    m.aperture = *filling_aperture(m.sheet, 400);
    Frame frame = frame_of_bar(m, 20, 40);
    for (const Eye eye : {Eye{0, 0, 400}, Eye{30, 0, 400}, Eye{-45, 0, 400}}) {
        const Edges seen = edges_of(frame, eye);
        frame.metadata->film.subpixels = Subpixels::none;
        const Edges ignored = edges_of(frame, eye);
        frame.metadata->film.subpixels = Subpixels::rgb;
        const double apart = 2 / 3.0 * m.film.pixel_pitch.x * 20 * m.sheet.ior /
                             m.sheet.thickness; // red and blue, paraxially
        for (const auto side : {&Edges::left, &Edges::right}) {
            const double fringe = (seen.*side)[0] - (seen.*side)[2];
            const double fringe_ignored = (ignored.*side)[0] - (ignored.*side)[2];
            BOOST_TEST_MESSAGE("eye " << eye.x << ": red beside blue by "
                                      << fringe / m.film.pixel_pitch.x << " pixels, "
                                      << fringe_ignored / m.film.pixel_pitch.x
                                      << " if taken for pixels");
            BOOST_TEST(std::fabs(fringe) < 0.2 * m.film.pixel_pitch.x);
            BOOST_TEST(std::fabs(std::fabs(fringe_ignored) / apart - 1) < 0.1);
        }
    }
}

BOOST_AUTO_TEST_CASE(subpixels_at_the_film_s_edge_and_alpha)
{
    // The film is white up to its edge, with every other column transparent. One wide lens covers
    // it, so that the eye sees all of it.
    FrameMetadata m = geometry({Arrangement::square, 0, {0, 0}}, 30, 20, 0.01);
    m.sheet.pitch = 10;
    m.sheet.thickness = 30;
    m.film.subpixels = Subpixels::bgr;
    Frame frame;
    frame.image = make_image<std::uint8_t>(30, 20, 4, {});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x)
            store_pixel(frame.image, x, y, {1, 1, 1, x % 2 ? 0.0f : 1.0f});
    set_metadata(frame, m);
    const View view{{0, 0, 17}, 400, 9, 1}; // from there the film nearly fills the view
    const auto image = replay(frame, view);
    int beyond = 0, first = 0, last = 0, mixed = 0;
    for (int x = 0; x < view.width; ++x) {
        const double px = film_point(m.sheet, {0, 0}, view_point(m, view, x, 4), view.eye).x /
                              0.01 +
                          15;
        const auto opaque = [&](double stripe) {
            return px >= 0 && px < 30 &&
                   int(std::fmin(29, std::fmax(0, std::floor(px - stripe)))) % 2 == 0;
        };
        const bool red = opaque(1 / 3.0), green = opaque(0), blue = opaque(-1 / 3.0);
        const Colour seen = stored_pixel(*image, x, 4);
        BOOST_TEST(std::lround(3 * seen.a) == red + green + blue);
        BOOST_TEST((seen.r > 0) == red);
        BOOST_TEST((seen.g > 0) == green);
        BOOST_TEST((seen.b > 0) == blue);
        beyond += px < 0 || px >= 30;
        first += px >= 0 && px < 1 / 3.0;
        last += px < 30 && px >= 30 - 1 / 3.0;
        mixed += red != green || green != blue;
    }
    for (const int met : {beyond, first, last, mixed})
        BOOST_TEST(met > 3);
}

BOOST_AUTO_TEST_CASE(a_far_scene_is_seen_by_direction_and_repeats_in_the_side_lobes)
{
    // Colour encodes the direction in which a square lens sends a film point, s = n sin(inside): a
    // scene at infinity. The eye must see the direction to itself; in a side lobe, the direction of
    // the film point one pitch over.
    FrameMetadata m = geometry({Arrangement::square, 0, {0, 0}}, 1600, 1600, 0.0127);
    m.film.pixel_pitch.y = m.film.pixel_pitch.x;
    Frame frame;
    frame.image = make_image<float>(1600, 1600, 3, linear);
    const auto sine = [&](double from_pole) { return 1.6 * std::sin(std::atan(from_pole / 3.08)); };
    for (int y = 0; y < 1600; ++y)
        for (int x = 0; x < 1600; ++x) {
            // Poles every 100 pixels, at the film's centre among others.
            const double fx = (std::remainder(x + 0.5 - 800, 100)) * 0.0127;
            const double fy = (std::remainder(800 - y - 0.5, 100)) * 0.0127;
            store_pixel(frame.image, x, y, {float(sine(-fx)), float(sine(-fy)), 0, 1});
        }
    set_metadata(frame, m);
    // The colour is per axis, so the eyes are on the axes, where the other sine is 0.
    for (const double angle : {-0.25, -0.1, 0.0, 0.15, 0.3}) {
        const Eye eye{3000 * std::tan(angle), 0, 3000}; // far: one direction everywhere, to 3e-3
        const auto image = replay(frame, {eye, 64, 64, 1});
        for (int y = 4; y < 60; y += 7)
            for (int x = 4; x < 60; x += 3) {
                const Colour seen = stored_pixel(*image, x, y);
                BOOST_TEST(std::fabs(seen.r - std::sin(angle)) < 0.008, angle << ": " << seen.r);
                BOOST_TEST(std::fabs(seen.g) < 0.008);
            }
    }
    const double beyond = 0.5; // rad; the zone ends at asin(n sin(atan(p/2t))) = 0.329
    const double place = 3.08 * std::tan(std::asin(std::sin(beyond) / 1.6)) - 1.27;
    const auto image = replay(frame, {{3000 * std::tan(beyond), 0, 3000}, 64, 64, 1});
    for (int x = 10; x < 60; x += 3)
        BOOST_TEST(std::fabs(stored_pixel(*image, x, 30).r - sine(place)) < 0.012);
}

BOOST_AUTO_TEST_CASE(samples_are_averaged_in_linear_light)
{
    // Film columns black and white by turns, an eye so far off that a view pixel's samples see
    // both evenly: the average is linear 1/2, which sRGB stores as 188.
    FrameMetadata m = geometry({Arrangement::lenticular, 0, {0, 0}}, 16, 8, 1.27 / 2);
    Frame frame;
    frame.image = make_image<std::uint8_t>(16, 8, 3, {});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            if (x / 2 % 2) // lenses by turns
                store_pixel(frame.image, x, y, {1, 1, 1, 1});
    m.sheet.offset.x = 1.27 / 2; // a lens over each pair of columns
    set_metadata(frame, m);
    const auto image = replay(frame, {{0, 0, 1e6}, 4, 4, 4}); // a view pixel is two lenses wide
    for (int x = 0; x < 4; ++x)
        BOOST_TEST(stored_pixel(*image, x, 2).r == 188 / 255.0f);
}

BOOST_AUTO_TEST_CASE(single_samples_copy_the_frames_own_values)
{
    // 1 sample, 16 bits, sRGB with alpha: every view pixel is some frame pixel to the last bit.
    FrameMetadata m = geometry({Arrangement::hexagonal, 5, {0, 0}}, 200, 200, 0.1);
    Frame frame;
    frame.image = make_image<std::uint16_t>(200, 200, 4, {});
    auto& samples = std::get<std::vector<std::uint16_t>>(frame.image.samples);
    for (std::size_t i = 0; i < samples.size(); i += 4) {
        samples[i] = std::uint16_t(i / 4);
        samples[i + 1] = std::uint16_t(65535 - i / 4 * 7 % 65536);
        samples[i + 2] = std::uint16_t(i * i / 16 * 31);
        samples[i + 3] = 65535;
    }
    set_metadata(frame, m);
    const auto image = replay(frame, {{10, 20, 300}, 50, 50, 1});
    BOOST_TEST(sample_bits(*image) == 16);
    const auto& seen = std::get<std::vector<std::uint16_t>>(image->samples);
    for (std::size_t i = 0; i < seen.size(); i += 4) {
        if (seen[i + 3] == 0)
            continue; // past the film's edge: transparent
        const std::size_t from = seen[i] * 4u;
        BOOST_TEST(seen[i + 1] == samples[from + 1]);
        BOOST_TEST(seen[i + 2] == samples[from + 2]);
        BOOST_TEST(seen[i + 3] == 65535);
    }
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit_and_work_can_be_stopped)
{
    const Frame frame = frame_of_places(geometry(cases[4], 300, 300, 0.05));
    const View view{{20, -10, 280}, 120, 130, 3};
    const auto one = replay(frame, view, 1), many = replay(frame, view, 7);
    BOOST_CHECK(one->samples == many->samples);
    BOOST_CHECK(!replay(frame, view, 2, [](int, int) { return false; }));
}

BOOST_AUTO_TEST_CASE(default_view)
{
    FrameMetadata m = geometry(cases[0], 2480, 3508, 25.4 / 300);
    const Eye eye = centre_eye(m);
    BOOST_TEST(eye.x == 0);
    BOOST_TEST(eye.y == 0);
    BOOST_TEST(eye.distance == 300);
    View view;
    set_view_size(view, m.film, 1000); // pixels 4:3, so the film is 2480 x 2631 in shape
    BOOST_TEST(view.height == 1000);
    BOOST_TEST(view.width == 943);
}

BOOST_AUTO_TEST_SUITE_END()
