// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests replay with a pupil, with a film out of focus and with curved lens surfaces, against
// independent formulas.
#include "tests/unit/replay_frames.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(replay_eyes)

namespace {

/// Checks each pixel of a view of frame_of_places: it must show the film point that
/// expected(q, pole) gives for the pixel's point q of the sheet.
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
            const double u = f.x / m.film.pixel_pitch.x + 0.5 * m.film.width,
                         v = 0.5 * m.film.height - f.y / m.film.pixel_pitch.y;
            if (margin < 1e-6 || u < 1 || v < 1 || u > m.film.width - 1 || v > m.film.height - 1)
                continue;
            const Colour seen = stored_pixel(*image, x, y);
            worst = std::max({worst, std::fabs(seen.r * m.film.width - u),
                              std::fabs(seen.g * m.film.height - v)});
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

BOOST_AUTO_TEST_CASE(full_lenses_refract_where_the_line_of_sight_meets_their_surface)
{
    // Snell's law in vectors at the sphere or cylinder of radius t (n - 1)/n, then straight on to
    // the film, also out of focus. The line meets the surface at depth z = height(q + z slope) of
    // the pole nearest there: found by iteration, as from these eyes the surface rises along the
    // line by less than the line falls.
    const struct {
        Eye eye;
        double gap;
    } eyes[] = {
        {{-40, 25, 250}, 0}, {{-40, 25, 250}, 0.7}, {{110, -60, 220}, 0}, {{110, -60, 220}, -1}};
    for (const Case& c : cases)
        for (const auto& e : eyes) {
            const FrameMetadata m = geometry(c, 1000, 900, 0.02);
            View view{e.eye, 101, 67, 1};
            view.model = LensModel::full;
            view.film_gap = e.gap;
            const double n = m.sheet.ior, radius = m.sheet.thickness * (n - 1) / n;
            judge(m, view, [&](Vec2 point, Vec2) {
                double way[3] = {point.x - view.eye.x, point.y - view.eye.y, view.eye.distance};
                const Vec2 slope{way[0] / way[2], way[1] / way[2]};
                Vec2 q = point;
                double x = 0, y = 0, root = 1, height = 0, margin;
                for (int k = 0; k < 200; ++k) {
                    const Vec2 pole = nearest_pole(m.sheet, q, margin);
                    x = (q.x - pole.x) / radius, y = (q.y - pole.y) / radius,
                    root = std::sqrt(1 - x * x - y * y);
                    const double before = height;
                    height = radius * (1 - root);
                    q = {point.x + height * slope.x, point.y + height * slope.y};
                    if (std::fabs(height - before) < 1e-13)
                        break;
                }
                const double normal[3] = {-x, -y, root}; // into the glass
                const double along = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
                double cosine = 0;
                for (int k = 0; k < 3; ++k)
                    cosine += (way[k] /= along) * normal[k];
                const double inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
                for (int k = 0; k < 3; ++k)
                    way[k] = way[k] / n + (inside - cosine / n) * normal[k];
                const double stretch = (m.sheet.thickness + e.gap - height) / way[2];
                return Vec2{q.x + stretch * way[0], q.y + stretch * way[1]};
            });
        }
}

BOOST_AUTO_TEST_CASE(a_pupil_blurs_what_is_out_of_focus, *boost::unit_test::label("many_pixels"))
{
    // A bar's edge at depth z, seen by a pupil of diameter D that is focused on depth f from
    // distance d: a uniform disc of diameter D |z - f|/(d + f) at f, seen from the pupil's centre
    // as D |z - f| d/((d + f)(d + z)) on the sheet; the variance of the edge's spread is a 16th of
    // its square. Fine lenses add little of their own.
    FrameMetadata m;
    m.sheet = {Arrangement::square, 0.1, 1, 1.5, 0, {}};
    m.film = {6000, 60, {0.005, 0.1}};
    const double d = 200;
    m.aperture = {d, 30, 60, ApertureShape::rectangle};
    struct {
        double z, focus;
    } trials[] = {{20, 0}, {-20, 0}, {20, -15}, {20, 20}};
    for (const auto& trial : trials) {
        // Only the spread across is measured: along y the bar is endless, so that all points of the
        // pupil at one x see the same.
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
        const double blur = view.pupil * std::fabs(trial.z - trial.focus) * d /
                            ((d + trial.focus) * (d + trial.z)) / 4;
        const double edge = 6 * d / (d + trial.z),
                     far = 2 * blur + 0.4; // the disc's half, and what lenses add
        for (int x = int((edge - far) / pixel) + view.width / 2;
             x < int((edge + far) / pixel) + view.width / 2; ++x) {
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
        BOOST_TEST_MESSAGE("z " << trial.z << ", focus " << trial.focus << ": edge at " << mean
                                << ", spread " << spread << ", " << blur << "; light "
                                << weight / 4);
        BOOST_TEST(weight / 4 > 0.9);
        BOOST_TEST(std::fabs(mean - edge) < 0.1);
        BOOST_TEST(std::fabs(spread - blur) < 0.06);
    }
}

BOOST_AUTO_TEST_SUITE_END()
