// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the lattice of lenses: compares the nearest pole with a search of all, and checks the rule
// for ties.
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_lattice)

BOOST_AUTO_TEST_CASE(nearest_is_the_nearest_of_all)
{
    random_sheets::Generator random(1);
    for (int k = 0; k < 20000; ++k) {
        const LensSheet sheet = random.sheet();
        const Lattice lattice(sheet);
        const Vec2 point{random.between(-4, 4) * sheet.pitch, random.between(-4, 4) * sheet.pitch};
        const LensIndex found = lattice.nearest(point);
        for (int j = sheet.arrangement == Arrangement::lenticular ? 0 : -14;
             j <= (sheet.arrangement == Arrangement::lenticular ? 0 : 14); ++j)
            for (int i = -14; i <= 14; ++i)
                BOOST_REQUIRE_MESSAGE(lattice.distance(point, found) <=
                                          lattice.distance(point, {i, j}) + 1e-8 * sheet.pitch,
                                      sheet);
    }
}

BOOST_AUTO_TEST_CASE(rule_3_11_for_the_lenticular_sheet)
{
    // lens_number = ceil(x / pitch - 1/2), rounding towards the centre
    const Lattice lattice(LensSheet{});
    for (double x = -20.05; x < 20; x += 0.0917)
        BOOST_TEST(lattice.nearest({x, 3.3}).i == std::int64_t(std::ceil(x / 1.27 - 0.5)));
}

BOOST_AUTO_TEST_CASE(ties_go_to_the_centre_then_left_then_down)
{
    const Lattice lines(LensSheet{Arrangement::lenticular, 2, 3, 1.5, 0, {0, 0}});
    BOOST_TEST(lines.nearest({3, 0}).i == 1);
    BOOST_TEST(lines.nearest({-3, 0}).i == -1);
    BOOST_TEST(lines.nearest({3 + 1e-10, 0}).i == 1); // tied: within 1e-9 pitches
    BOOST_TEST(lines.nearest({3 + 1e-8, 0}).i == 2);

    const Lattice shifted(LensSheet{Arrangement::lenticular, 2, 3, 1.5, 0, {1, 0}});
    BOOST_TEST(shifted.nearest({0, 7}).i == -1); // x = -1 and x = +1 are equally central

    const Lattice squares(LensSheet{Arrangement::square, 2, 3, 1.5, 0, {0, 0}});
    BOOST_TEST((squares.nearest({3, 3}) == LensIndex{1, 1}));
    BOOST_TEST((squares.nearest({-3, 5}) == LensIndex{-1, 2}));
    const Lattice four(LensSheet{Arrangement::square, 2, 3, 1.5, 0, {1, 1}});
    BOOST_TEST((four.nearest({0, 0}) == LensIndex{-1, -1}));

    // the three lenses around a hexagonal corner: the two at x = -p/2, p/2 of row 1, and the centre
    const Lattice hexagons(LensSheet{Arrangement::hexagonal, 2, 3, 1.5, 0, {0, 0}});
    BOOST_TEST((hexagons.nearest({0, 2 / std::sqrt(3.0)}) == LensIndex{0, 0}));
    BOOST_TEST((hexagons.nearest({0, 2 / std::sqrt(3.0) + 1e-6}) == LensIndex{-1, 1}));
}

BOOST_AUTO_TEST_CASE(a_frame_of_15_pixels_a_lens_has_a_tie_in_every_fifteenth_pixel)
{
    // 1.27 mm at 300 dpi and an even width; ties go inwards on both sides
    const Lattice lattice(LensSheet{});
    const Film film{1200, 1, {mm_per_inch / 300, mm_per_inch / 300}};
    int last = 0, changes = 0;
    for (int i = 0; i < film.width; ++i) {
        const Vec2 point = film_from_pixel(film, {i + 0.5, 0.5});
        const auto lens = lattice.nearest(point).i;
        const auto mirrored = lattice.nearest({-point.x, point.y}).i;
        BOOST_TEST(lens == -mirrored);
        if (i && lens != last)
            ++changes;
        last = int(lens);
    }
    BOOST_TEST(changes == 80);
}

BOOST_AUTO_TEST_CASE(every_lens_within_a_radius_is_visited)
{
    random_sheets::Generator random(3);
    for (int k = 0; k < 2000; ++k) {
        const LensSheet sheet = random.sheet();
        const Lattice lattice(sheet);
        const Vec2 centre{random.between(-3, 3) * sheet.pitch, random.between(-3, 3) * sheet.pitch};
        const double radius = random.between(0, 4) * sheet.pitch;
        std::vector<LensIndex> seen;
        lattice.for_each_within(centre, radius, [&](LensIndex lens) { seen.push_back(lens); });
        const int rows = sheet.arrangement == Arrangement::lenticular ? 0 : 16;
        for (int j = -rows; j <= rows; ++j)
            for (int i = -16; i <= 16; ++i)
                if (lattice.distance(centre, {i, j}) <= radius)
                    BOOST_REQUIRE(std::count(seen.begin(), seen.end(), LensIndex{i, j}) == 1);
    }
}

BOOST_AUTO_TEST_CASE(slant_turns_anticlockwise_as_the_viewer_sees_it)
{
    const Lattice lattice(LensSheet{Arrangement::square, 1, 3, 1.5, 90 - 1e-9, {5, 0}});
    const Vec2 right = lattice.pole({1, 0}); // the lens to the right of the centre has turned
                                             // upwards
    BOOST_TEST(std::fabs(right.x - 5) < 1e-8);
    BOOST_TEST(std::fabs(right.y - 1) < 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
