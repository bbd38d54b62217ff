// SPDX-License-Identifier: AGPL-3.0-or-later
// Parallax: a disc at a known depth, recorded through the renderer's own mapping, moves between
// the views of two eyes as geometry says. Its brightness falls smoothly to the rim: a hard edge,
// sampled once a lens, would move the centroid by some hundredths of a pitch, which is noise of the
// sampling and not of the optics.
#include "integral/replay/replay.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace integral;

BOOST_AUTO_TEST_SUITE(replay_parallax)

namespace {

/// A frame of a disc parallel to the sheet, of brightness cos^2 from centre to rim, on black.
Frame frame_of_disc(FrameMetadata m, Vec3 centre, double radius)
{
    const SheetOptics optics(m.sheet, m.aperture);
    Frame frame{make_image<std::uint16_t>(m.film.width, m.film.height, 3, {}), {}};
    for_each_row(m.film.height, 0, [&](int y) {
        for (int x = 0; x < m.film.width; ++x) {
            const auto mapped = optics.map(film_from_pixel(m.film, {x + 0.5, y + 0.5}),
                                           LensMapping::automatic);
            if (!mapped.ray)
                continue;
            // The line through the pole, which the viewer sees both ways.
            const double along = centre.z / mapped.ray->direction.z;
            const Vec2 hit{mapped.ray->pole.x + along * mapped.ray->direction.x,
                           mapped.ray->pole.y + along * mapped.ray->direction.y};
            const double r = std::hypot(hit.x - centre.x, hit.y - centre.y) / radius;
            const float light = r < 1 ? float(0.5 + 0.5 * std::cos(3.14159265358979 * r)) : 0;
            store_linear(frame.image, x, y, {light, light, light, 1});
        }
    });
    set_metadata(frame, m);
    return frame;
}

/// Centroid of a view's light, in mm on the sheet.
Vec2 centroid(const Frame& frame, const Eye& eye)
{
    const Film& film = frame.metadata->film;
    View view{eye, 0, 0, 2};
    set_view_size(view, film, 500);
    const auto image = replay(frame, view);
    const LinearReader light(*image);
    double sum = 0, sx = 0, sy = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const double v = light(x, y).g;
            sum += v;
            sx += v * (x + 0.5);
            sy += v * (y + 0.5);
        }
    BOOST_REQUIRE(sum > 0);
    return {(sx / sum / view.width - 0.5) * film.width * film.pixel_pitch.x,
            (0.5 - sy / sum / view.height) * film.height * film.pixel_pitch.y};
}

/// Errors of the parallax between two eyes `baseline` apart along each axis, as fractions of
/// theory: a point at depth z is seen through the sheet at eye z/(d + z), so the eyes'
/// distance B becomes B z/(d + z).
Vec2 parallax_error(const Frame& frame, double z, double baseline)
{
    const double d = frame.metadata->aperture.distance, b = baseline / 2;
    // Above and below the slit of a slanted lenticular sheet, an eye sees heights that were not
    // recorded. So the eyes stay at the slit's height.
    const double v = frame.metadata->sheet.arrangement == Arrangement::lenticular ? 0 : b;
    const Vec2 moved = centroid(frame, {b, v, d}) - centroid(frame, {-b, -v, d});
    const double theory = baseline * z / (d + z);
    return {moved.x / theory - 1, moved.y / theory - 1};
}

} // namespace

// At 300 dpi a pitch of 1.27 mm is 15 pixels. Nearly all lenses then show an eye the same one of
// their pixels (thesis 5.3.1), the views of an unslanted sheet jump by whole pixels, and parallax
// is right only on average over eyes. Where the sheet is slanted, or the visual pitch is no whole
// number of pixels, the jumps are spread over the sheet: such sheets are measured here.
BOOST_AUTO_TEST_CASE(disc_before_and_behind_the_sheet, *boost::unit_test::label("many_pixels"))
{
    const struct {
        Arrangement arrangement;
        double slant;
        Vec2 pixel; // mm
    } sheets[] = {{Arrangement::lenticular, 0, {0.03, 0.03}},
                  {Arrangement::lenticular, 10, {25.4 / 300, 25.4 / 300}},
                  {Arrangement::square, 0, {0.03, 0.03}},
                  {Arrangement::square, 12, {25.4 / 300, 25.4 / 300}},
                  {Arrangement::hexagonal, 0, {0.03, 0.0302}},
                  {Arrangement::hexagonal, 15, {25.4 / 300, 25.4 / 300}}};
    using Depths = std::array<double, 2>;
    double worst = 0;
    for (const auto& s : sheets)
        // Half of the depths for each sheet, and all for each arrangement.
        for (const double z : s.slant == 0 ? Depths{-60.0, 20.0} : Depths{-20.0, 60.0}) {
            FrameMetadata m;
            m.sheet = {s.arrangement, 1.27, 3.08, 1.6, s.slant, {}};
            m.film = {int(56 / s.pixel.x), int(56 / s.pixel.y), s.pixel};
            m.aperture = *filling_aperture(m.sheet, 300);
            const double radius = 10 * 1.27; // 20 pitches across, 10 at half brightness
            const Frame frame = frame_of_disc(m, {0.3, -0.2, z}, radius * (300 + z) / 300);
            const Vec2 error = parallax_error(frame, z, 40);
            const bool vertical = s.arrangement != Arrangement::lenticular; // else there is none
            const auto where = [&](char axis) {
                return std::to_string(int(s.arrangement)) + " slant " + std::to_string(s.slant) +
                       " z " + std::to_string(z) + " along " + axis;
            };
            BOOST_TEST_MESSAGE(where('x')
                               << " " << 100 * error.x << "%, y " << 100 * error.y << "%");
            BOOST_TEST(std::fabs(error.x) < 0.006, where('x') << ": " << 100 * error.x << "%");
            BOOST_TEST((!vertical || std::fabs(error.y) < 0.006),
                       where('y') << ": " << 100 * error.y << "%");
            worst = std::max({worst, std::fabs(error.x), vertical ? std::fabs(error.y) : 0});
        }
    BOOST_TEST_MESSAGE("greatest parallax error " << 100 * worst << "%");
}

BOOST_AUTO_TEST_SUITE_END()
