// SPDX-License-Identifier: AGPL-3.0-or-later
// Film points that are seen side by side equal those that are seen one by one, bit for bit.
#include "integral/optics/film_seen.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

#include <cstring>

using namespace integral;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

} // namespace

BOOST_AUTO_TEST_SUITE(optics_film_seen)

BOOST_AUTO_TEST_CASE(side_by_side_as_one_by_one)
{
    random_sheets::Generator random(59);
    int at_borders = 0, differ = 0;
    for (int k = random_sheets::count(300, 20000); k > 0; --k) {
        const LensSheet sheet = random.sheet();
        const double distance = random.distance();
        const SheetOptics optics(sheet, Aperture{distance, distance, distance});
        const Lattice& lattice = optics.lattice();
        const int number = 1 + int(random.between(0, FilmSeenRun::length - 0.5));
        FilmSeenRun run;
        for (auto* entries : {&run.x, &run.y, &run.eye_x, &run.eye_y})
            entries->fill(NAN); // of further points
        for (int j = 0; j < number; ++j) {
            Vec2 point{random.between(-50, 50) * sheet.pitch,
                       random.between(-50, 50) * sheet.pitch};
            if (random.one_in(4)) { // the border of two lenses, where rounding decides
                const LensIndex lens = lattice.nearest(point);
                point = lattice.pole(lens) + (0.5 * sheet.pitch) * lattice.across();
                ++at_borders;
            }
            run.x[j] = point.x;
            run.y[j] = point.y;
            run.eye_x[j] = random.between(-1, 1) * distance;
            run.eye_y[j] = random.one_in(8) ? 0 : random.between(-1, 1) * distance;
        }
        film_points_seen(optics, distance, number, run);
        for (int j = 0; j < number; ++j) {
            const Vec2 point{run.x[j], run.y[j]};
            const Vec2 one = optics.film_point_seen(
                point, {run.eye_x[j] - point.x, run.eye_y[j] - point.y, -distance});
            differ += !same_bits(one.x, run.film_x[j]) || !same_bits(one.y, run.film_y[j]);
        }
    }
    BOOST_TEST(at_borders > 1000);
    BOOST_TEST(differ == 0);
}

BOOST_AUTO_TEST_SUITE_END()
