// SPDX-License-Identifier: AGPL-3.0-or-later
// Replay of frames whose view is known in closed form, by formulas of their own.
#include "integral/replay/replay.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace integral;

BOOST_AUTO_TEST_SUITE(replay_views)

namespace {

constexpr double pi = 3.14159265358979323846;
const Encoding linear{Encoding::Kind::linear, 1};

struct Case {
    Arrangement arrangement;
    double slant;
    Vec2 offset;
};
const Case cases[] = {{Arrangement::lenticular, 0, {0, 0}},     {Arrangement::lenticular, 9.46, {0.2, -0.1}},
                      {Arrangement::lenticular, -60, {0, 0.3}}, {Arrangement::square, 0, {0, 0}},
                      {Arrangement::square, 20, {-0.4, 0.3}},   {Arrangement::hexagonal, 0, {0, 0}},
                      {Arrangement::hexagonal, -33, {0.1, 0.5}}};

FrameMetadata geometry(const Case& c, int width, int height, double pixel)
{
    FrameMetadata m;
    m.sheet = {c.arrangement, 1.27, 3.08, 1.6, c.slant, c.offset};
    m.film = {width, height, {pixel, 0.75 * pixel}};
    m.aperture.distance = 300;
    m.aperture.width = m.aperture.height = 200;
    return m;
}

/// Every film pixel holds the place of its own centre, as fractions of the film, in R and G.
Frame frame_of_places(const FrameMetadata& m)
{
    Frame frame;
    frame.image = make_image<float>(m.film.width, m.film.height, 3, linear);
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x)
            store_pixel(frame.image, x, y, {float((x + 0.5) / m.film.width), float((y + 0.5) / m.film.height), 1, 1});
    set_metadata(frame, m);
    return frame;
}

/// The pole nearest to a point (or the nearest point of the nearest axis), found by trying every
/// lens of a patch around it; and by how much the next one is farther.
Vec2 nearest_pole(const LensSheet& s, Vec2 q, double& margin)
{
    const double a = s.slant * pi / 180, p = s.pitch;
    const Vec2 d{q.x - s.offset.x, q.y - s.offset.y};
    const Vec2 turned{d.x * std::cos(a) + d.y * std::sin(a), -d.x * std::sin(a) + d.y * std::cos(a)};
    double least = std::numeric_limits<double>::infinity(), second = least;
    Vec2 best;
    const bool lenticular = s.arrangement == Arrangement::lenticular;
    const double row = s.arrangement == Arrangement::hexagonal ? p * std::sqrt(3) / 2 : p;
    const int j0 = lenticular ? 0 : int(std::floor(turned.y / row)), i0 = int(std::floor(turned.x / p));
    for (int j = j0 - 2; j <= j0 + 2; ++j)
        for (int i = i0 - 2; i <= i0 + 2; ++i) {
            if (lenticular && j != j0)
                continue;
            const bool shifted = s.arrangement == Arrangement::hexagonal && j % 2 != 0;
            const Vec2 pole{(i + (shifted ? 0.5 : 0)) * p, lenticular ? turned.y : j * row};
            const double distance = std::hypot(pole.x - turned.x, pole.y - turned.y);
            if (distance < least) {
                second = least;
                least = distance;
                best = pole;
            } else if (distance < second) {
                second = distance;
            }
        }
    margin = second - least;
    return {best.x * std::cos(a) - best.y * std::sin(a) + s.offset.x,
            best.x * std::sin(a) + best.y * std::cos(a) + s.offset.y};
}

/// Where on the film an eye looks through a point of the sheet: Snell's law at the pole.
Vec2 film_point(const LensSheet& s, Vec2 pole, Vec2 q, const Eye& eye)
{
    const double dx = eye.x - q.x, dy = eye.y - q.y;
    const double angle = std::atan(std::hypot(dx, dy) / eye.distance), around = std::atan2(dy, dx);
    const double inside = std::asin(std::sin(angle) / s.ior);
    const double shift = s.thickness * std::tan(inside);
    return {pole.x - shift * std::cos(around), pole.y - shift * std::sin(around)};
}

Vec2 view_point(const FrameMetadata& m, const View& view, int x, int y)
{
    return {((x + 0.5) / view.width - 0.5) * m.film.width * m.film.pixel_pitch.x,
            (0.5 - (y + 0.5) / view.height) * m.film.height * m.film.pixel_pitch.y};
}

} // namespace

BOOST_AUTO_TEST_CASE(each_view_pixel_shows_the_film_point_behind_its_lens)
{
    for (const Case& c : cases) {
        const FrameMetadata m = geometry(c, 1000, 900, 0.02);
        const Frame frame = frame_of_places(m);
        for (const Eye eye : {Eye{0, 0, 300}, Eye{-80, 35, 250}, Eye{500, -200, 150}, Eye{3, 1, 2}}) {
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
                    const Color seen = stored_pixel(*image, x, y);
                    const double half_u = 0.5 / m.film.width + 1e-6, half_v = 0.5 / m.film.height + 1e-6;
                    if (u < -1e-9 || u > 1 + 1e-9 || v < -1e-9 || v > 1 + 1e-9) {
                        BOOST_TEST(seen.b == 0);
                        ++black;
                    } else if (u > 1e-9 && u < 1 - 1e-9 && v > 1e-9 && v < 1 - 1e-9) {
                        BOOST_TEST((std::fabs(seen.r - u) <= half_u && std::fabs(seen.g - v) <= half_v),
                                   "arrangement " << int(c.arrangement) << " slant " << c.slant << " pixel " << x << "," << y
                                                  << ": " << seen.r << "," << seen.g << " instead of " << u << "," << v);
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
    // Each channel of a film pixel holds the place of its own stripe's centre, in pixels. What the eye sees of each is
    // within half a pixel of the film point behind the lens, and within a whole one if the stripes are taken for pixels.
    for (const Subpixels order : {Subpixels::rgb, Subpixels::bgr})
        for (const Case& c : cases) {
            FrameMetadata m = geometry(c, 300, 200, 0.05);
            m.film.subpixels = order;
            const double red = order == Subpixels::rgb ? -1 / 3.0 : 1 / 3.0;
            Frame frame;
            frame.image = make_image<float>(m.film.width, m.film.height, 3, linear);
            for (int y = 0; y < m.film.height; ++y)
                for (int x = 0; x < m.film.width; ++x)
                    store_pixel(frame.image, x, y, {float(x + 0.5 + red), float(x + 0.5), float(x + 0.5 - red), 1});
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
                    const double px = f.x / m.film.pixel_pitch.x + 150, py = 100 - f.y / m.film.pixel_pitch.y;
                    if (margin < 1e-6 || px < 1 || px > 299 || py < 0.01 || py > 199.99)
                        continue;
                    const auto farthest = [&](const Image& seen) {
                        const Color color = stored_pixel(seen, x, y);
                        return std::max({std::fabs(color.r - px), std::fabs(color.g - px), std::fabs(color.b - px)});
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

/// A frame of a white bar, from x = -width/2 to width/2, at depth z on black: each channel's light is that of the ray from
/// its own stripe's centre.
Frame frame_of_bar(const FrameMetadata& m, double z, double width)
{
    const SheetOptics optics(m.sheet, m.aperture);
    Frame frame{make_image<std::uint16_t>(m.film.width, m.film.height, 3, {}), {}};
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x) {
            const auto light = [&](int channel) {
                const double shift = m.film.subpixels == Subpixels::rgb ? (channel - 1) / 3.0 : 0;
                const auto mapped = optics.map(film_from_pixel(m.film, {x + 0.5 + shift, y + 0.5}), LensMapping::automatic);
                if (!mapped.ray)
                    return 0.0f;
                const double at = mapped.ray->pole.x + z / mapped.ray->direction.z * mapped.ray->direction.x;
                return std::fabs(at) < width / 2 ? 1.0f : 0.0f;
            };
            store_linear(frame.image, x, y, {light(0), light(1), light(2), 1});
        }
    set_metadata(frame, m);
    return frame;
}

/// Where the bar's two edges are seen on average, mm on the sheet: what light each channel has to the left and to the right
/// of the bar's middle.
struct Edges { double left[3], right[3]; };

Edges edges_of(const Frame& frame, Eye eye)
{
    const Film& film = frame.metadata->film;
    View view{eye, 0, 0, 3};
    set_view_size(view, film, 600);
    const auto image = replay(frame, view);
    const LinearReader light(*image);
    const double pixel = film.width * film.pixel_pitch.x / view.width / view.height; // mm, a row's part
    const int middle = int(view.width * (0.5 + eye.x * 20 / (eye.distance + 20) / (film.width * film.pixel_pitch.x)));
    Edges edges{};
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Color seen = light(x, y);
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
    // A panel of 0.207 mm pixels under slanted lenses, a white bar 20 mm behind the sheet. Taken for pixels, the stripes'
    // channels would be seen z/t n times a third of a pixel apart.
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
        const double apart = 2 / 3.0 * m.film.pixel_pitch.x * 20 * m.sheet.ior / m.sheet.thickness; // red and blue, paraxially
        for (const auto side : {&Edges::left, &Edges::right}) {
            const double fringe = (seen.*side)[0] - (seen.*side)[2];
            const double fringe_ignored = (ignored.*side)[0] - (ignored.*side)[2];
            BOOST_TEST_MESSAGE("eye " << eye.x << ": red beside blue by " << fringe / m.film.pixel_pitch.x << " pixels, "
                                      << fringe_ignored / m.film.pixel_pitch.x << " if taken for pixels");
            BOOST_TEST(std::fabs(fringe) < 0.2 * m.film.pixel_pitch.x);
            BOOST_TEST(std::fabs(std::fabs(fringe_ignored) / apart - 1) < 0.1);
        }
    }
}

BOOST_AUTO_TEST_CASE(subpixels_at_the_film_s_edge_and_alpha)
{
    // White to the film's very edge, every other column transparent; under one wide lens the eye sees the film plainly.
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
    const View view{{0, 0, 17}, 400, 9, 1}; // from there the film fills the view but for a little
    const auto image = replay(frame, view);
    int beyond = 0, first = 0, last = 0, mixed = 0;
    for (int x = 0; x < view.width; ++x) {
        const double px = film_point(m.sheet, {0, 0}, view_point(m, view, x, 4), view.eye).x / 0.01 + 15;
        const auto opaque = [&](double stripe) {
            return px >= 0 && px < 30 && int(std::fmin(29, std::fmax(0, std::floor(px - stripe)))) % 2 == 0;
        };
        const bool red = opaque(1 / 3.0), green = opaque(0), blue = opaque(-1 / 3.0);
        const Color seen = stored_pixel(*image, x, 4);
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
    // Colour encodes the direction in which a square lens sends a film point, s = n sin(inside):
    // a scene at infinity. The eye must see the direction to itself; in a side lobe, that of
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
    // As the colour is per axis, look from eyes on the axes, whose other sine is 0.
    for (const double angle : {-0.25, -0.1, 0.0, 0.15, 0.3}) {
        const Eye eye{3000 * std::tan(angle), 0, 3000}; // far: the same direction everywhere to 3e-3
        const auto image = replay(frame, {eye, 64, 64, 1});
        for (int y = 4; y < 60; y += 7)
            for (int x = 4; x < 60; x += 3) {
                const Color seen = stored_pixel(*image, x, y);
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

namespace {

/// Judges each pixel of a view of frame_of_places by the film point that `expected(q, pole)` gives for its point of the sheet.
template <class Expected> void judge(const FrameMetadata& m, const View& view, Expected expected)
{
    const auto image = replay(frame_of_places(m), view);
    BOOST_REQUIRE(image);
    int judged = 0;
    double worst = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Vec2 q = view_point(m, view, x, y);
            double margin;
            const Vec2 pole = nearest_pole(m.sheet, q, margin);
            const Vec2 f = expected(q, pole);
            const double u = f.x / m.film.pixel_pitch.x + 0.5 * m.film.width, v = 0.5 * m.film.height - f.y / m.film.pixel_pitch.y;
            if (margin < 1e-6 || u < 1 || v < 1 || u > m.film.width - 1 || v > m.film.height - 1)
                continue;
            const Color seen = stored_pixel(*image, x, y);
            worst = std::max({worst, std::fabs(seen.r * m.film.width - u), std::fabs(seen.g * m.film.height - v)});
            ++judged;
        }
    BOOST_TEST(judged > view.width * view.height / 2);
    BOOST_TEST(worst < 0.501); // pixels: a film pixel is one colour
}

} // namespace

BOOST_AUTO_TEST_CASE(a_film_beside_the_focus_is_met_on_the_way_to_it)
{
    for (const Case& c : cases)
        for (const double gap : {-1.5, -0.2, 0.7, 4.0}) {
            const FrameMetadata m = geometry(c, 1000, 900, 0.02);
            View view{{-40, 25, 250}, 101, 67, 1};
            view.film_gap = gap;
            judge(m, view, [&](Vec2 q, Vec2 pole) {
                const Vec2 focus = film_point(m.sheet, pole, q, view.eye);
                const double depth = (m.sheet.thickness + gap) / m.sheet.thickness;
                return Vec2{q.x + depth * (focus.x - q.x), q.y + depth * (focus.y - q.y)};
            });
        }
}

BOOST_AUTO_TEST_CASE(full_lenses_refract_at_their_surface)
{
    // Snell's law in vectors at the sphere or cylinder of radius t (n - 1)/n, then straight on to the film.
    for (const Case& c : cases) {
        const FrameMetadata m = geometry(c, 1000, 900, 0.02);
        View view{{-40, 25, 250}, 101, 67, 1};
        view.model = LensModel::full;
        const double n = m.sheet.ior, radius = m.sheet.thickness * (n - 1) / n;
        judge(m, view, [&](Vec2 q, Vec2 pole) {
            const double x = (q.x - pole.x) / radius, y = (q.y - pole.y) / radius, root = std::sqrt(1 - x * x - y * y);
            const double height = radius * (1 - root);
            const double normal[3] = {-x, -y, root}; // into the glass
            double way[3] = {q.x - view.eye.x, q.y - view.eye.y, view.eye.distance + height};
            const double along = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
            double cosine = 0;
            for (int k = 0; k < 3; ++k)
                cosine += (way[k] /= along) * normal[k];
            const double inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
            for (int k = 0; k < 3; ++k)
                way[k] = way[k] / n + (inside - cosine / n) * normal[k];
            const double stretch = (m.sheet.thickness - height) / way[2];
            return Vec2{q.x + stretch * way[0], q.y + stretch * way[1]};
        });
    }
}

BOOST_AUTO_TEST_CASE(a_pupil_blurs_what_is_out_of_focus)
{
    // A bar's edge at depth z, seen by a pupil of diameter D that is focused on depth f from distance d: a uniform disc of diameter
    // D |z - f|/(d + f) at f, seen from the pupil's centre as D |z - f| d/((d + f)(d + z)) on the sheet; the variance
    // of the edge's spread is a 16th of its square. Fine lenses add little of their own.
    FrameMetadata m;
    m.sheet = {Arrangement::square, 0.1, 1, 1.5, 0, {}};
    m.film = {6000, 60, {0.005, 0.1}};
    const double d = 200;
    m.aperture = {d, 30, 60, ApertureShape::rectangle};
    struct { double z, focus; } trials[] = {{20, 0}, {-20, 0}, {20, -15}, {20, 20}};
    for (const auto& trial : trials) {
        // Only across: the eye's disc along y sees the same, as the bar is endless there.
        const Frame frame = frame_of_bar(m, trial.z, 12);
        View view{{0, 0, d}, 1500, 60, 8};
        view.pupil = 20;
        view.focus = trial.focus;
        const auto image = replay(frame, view);
        BOOST_REQUIRE(image);
        const LinearReader light(*image);
        // the right edge's spread: moments of the light's fall, over the middle rows
        double weight = 0, mean = 0, square = 0;
        const double pixel = m.film.width * m.film.pixel_pitch.x / view.width;
        const double blur = view.pupil * std::fabs(trial.z - trial.focus) * d / ((d + trial.focus) * (d + trial.z)) / 4;
        const double edge = 6 * d / (d + trial.z), far = 2 * blur + 0.4; // the disc's half, and what lenses add
        for (int x = int((edge - far) / pixel) + view.width / 2; x < int((edge + far) / pixel) + view.width / 2; ++x) {
            double fall = 0;
            for (int y = 28; y < 32; ++y)
                fall += light(x, y).g - light(x + 1, y).g;
            const double at = (x + 1 - 0.5 * view.width) * pixel;
            weight += fall;
            mean += fall * at;
            square += fall * at * at;
        }
        mean /= weight;
        const double spread = std::sqrt(std::max(0.0, square / weight - mean * mean));
        BOOST_TEST_MESSAGE("z " << trial.z << ", focus " << trial.focus << ": edge at " << mean << ", spread " << spread << ", " << blur << "; light " << weight / 4);
        BOOST_TEST(weight / 4 > 0.9);
        BOOST_TEST(std::fabs(mean - edge) < 0.1);
        BOOST_TEST(std::fabs(spread - blur) < 0.06);
    }
}

BOOST_AUTO_TEST_SUITE_END()
