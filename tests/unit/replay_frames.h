// SPDX-License-Identifier: AGPL-3.0-or-later
// Frames with known views, and the film points that eyes see, by formulas independent of replay.
#ifndef INTEGRAL_TESTS_REPLAY_FRAMES_H
#define INTEGRAL_TESTS_REPLAY_FRAMES_H

#include "integral/replay/replay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {

constexpr double pi = 3.14159265358979323846;
const Encoding linear{Encoding::Kind::linear, 1};

struct Case {
    Arrangement arrangement;
    double slant;
    Vec2 offset;
};
const Case cases[] = {
    {Arrangement::lenticular, 0, {0, 0}},     {Arrangement::lenticular, 9.46, {0.2, -0.1}},
    {Arrangement::lenticular, -60, {0, 0.3}}, {Arrangement::lenticular, 90, {0.1, 0.3}},
    {Arrangement::square, 0, {0, 0}},         {Arrangement::square, 20, {-0.4, 0.3}},
    {Arrangement::hexagonal, 0, {0, 0}},      {Arrangement::hexagonal, -33, {0.1, 0.5}}};

inline FrameMetadata geometry(const Case& c, int width, int height, double pixel)
{
    FrameMetadata m;
    m.sheet = {c.arrangement, 1.27, 3.08, 1.6, c.slant, c.offset};
    m.film = {width, height, {pixel, 0.75 * pixel}};
    m.aperture.distance = 300;
    m.aperture.width = m.aperture.height = 200;
    return m;
}

/// Every film pixel holds the place of its own centre, as fractions of the film, in R and G.
inline Frame frame_of_places(const FrameMetadata& m)
{
    Frame frame;
    frame.image = make_image<float>(m.film.width, m.film.height, 3, linear);
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x)
            store_pixel(frame.image, x, y,
                        {float((x + 0.5) / m.film.width), float((y + 0.5) / m.film.height), 1, 1});
    set_metadata(frame, m);
    return frame;
}

/// The pole nearest to a point (or the nearest point of the nearest axis), found by trying every
/// lens of a patch around it; and by how much the next one is farther.
inline Vec2 nearest_pole(const LensSheet& s, Vec2 q, double& margin)
{
    const double a = s.slant * pi / 180, p = s.pitch;
    const Vec2 d{q.x - s.offset.x, q.y - s.offset.y};
    const Vec2 turned{d.x * std::cos(a) + d.y * std::sin(a),
                      -d.x * std::sin(a) + d.y * std::cos(a)};
    double least = std::numeric_limits<double>::infinity(), second = least;
    Vec2 best;
    const bool lenticular = s.arrangement == Arrangement::lenticular;
    const double row = s.arrangement == Arrangement::hexagonal ? p * std::sqrt(3) / 2 : p;
    const int j0 = lenticular ? 0 : int(std::floor(turned.y / row)),
              i0 = int(std::floor(turned.x / p));
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
inline Vec2 film_point(const LensSheet& s, Vec2 pole, Vec2 q, const Eye& eye)
{
    const double dx = eye.x - q.x, dy = eye.y - q.y;
    const double angle = std::atan(std::hypot(dx, dy) / eye.distance), around = std::atan2(dy, dx);
    const double inside = std::asin(std::sin(angle) / s.ior);
    const double shift = s.thickness * std::tan(inside);
    return {pole.x - shift * std::cos(around), pole.y - shift * std::sin(around)};
}

inline Vec2 view_point(const FrameMetadata& m, const View& view, int x, int y)
{
    return {((x + 0.5) / view.width - 0.5) * m.film.width * m.film.pixel_pitch.x,
            (0.5 - (y + 0.5) / view.height) * m.film.height * m.film.pixel_pitch.y};
}

/// A frame of a white bar, from x = -width/2 to width/2, at depth z on black: each channel has the
/// light of the ray from its own stripe's centre.
inline Frame frame_of_bar(const FrameMetadata& m, double z, double width)
{
    const SheetOptics optics(m.sheet, m.aperture);
    Frame frame{make_image<std::uint16_t>(m.film.width, m.film.height, 3, {}), {}};
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x) {
            const auto light = [&](int channel) {
                const double shift = m.film.subpixels == Subpixels::rgb ? (channel - 1) / 3.0 : 0;
                const auto mapped = optics.map(film_from_pixel(m.film, {x + 0.5 + shift, y + 0.5}),
                                               LensMapping::automatic);
                if (!mapped.ray)
                    return 0.0f;
                const double at = mapped.ray->pole.x +
                                  z / mapped.ray->direction.z * mapped.ray->direction.x;
                return std::fabs(at) < width / 2 ? 1.0f : 0.0f;
            };
            store_linear(frame.image, x, y, {light(0), light(1), light(2), 1});
        }
    set_metadata(frame, m);
    return frame;
}

} // namespace integral

#endif
