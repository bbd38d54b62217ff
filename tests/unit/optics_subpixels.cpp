// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests subpixels: values of stripes and cells worked out by hand, and the nearest subpixel, which
// is compared with a search of the whole film.
#include "integral/optics/subpixels.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_subpixels)

namespace {

Subpixels cells_of(CellPattern pattern, int number)
{
    Subpixels cells;
    cells.order = Subpixels::cells;
    cells.pattern = pattern;
    cells.number = number;
    for (int k = 0; k < number; ++k)
        cells.cell[k] = {Vec2{-0.3 + 0.1 * k, 0.25}, Vec2{0.3, 0.2 - 0.1 * k}, Vec2{0, -0.25}};
    return cells;
}

const std::vector<Subpixels>& layouts()
{
    static const std::vector<Subpixels> all{Subpixels::none,
                                            Subpixels::rgb,
                                            Subpixels::bgr,
                                            Subpixels::vrgb,
                                            Subpixels::vbgr,
                                            cells_of(CellPattern::same, 1),
                                            cells_of(CellPattern::columns, 2),
                                            cells_of(CellPattern::rows, 2),
                                            cells_of(CellPattern::checkerboard, 2),
                                            cells_of(CellPattern::staggered, 4)};
    return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(stripes_stand_from_left_to_right_or_from_top_to_bottom)
{
    const auto at = [](Subpixels::Order order, int channel) {
        return subpixel_shift(order, {7.5, 3.5}, channel);
    };
    BOOST_TEST(at(Subpixels::rgb, 0).x == -1 / 3.0);
    BOOST_TEST(at(Subpixels::rgb, 2).x == 1 / 3.0);
    BOOST_TEST(at(Subpixels::bgr, 0).x == 1 / 3.0);
    BOOST_TEST(at(Subpixels::vrgb, 0).y == -1 / 3.0); // pixel coordinates run down: red is above
    BOOST_TEST(at(Subpixels::vbgr, 0).y == 1 / 3.0);
    for (const Subpixels::Order order :
         {Subpixels::none, Subpixels::rgb, Subpixels::bgr, Subpixels::vrgb, Subpixels::vbgr})
        BOOST_TEST(length(at(order, 1)) == 0);
    BOOST_TEST(length(at(Subpixels::rgb, 0) + at(Subpixels::rgb, 2)) == 0);
}

BOOST_AUTO_TEST_CASE(which_cell_a_pixel_has)
{
    // The cells of the 4 x 4 pixels in the top left corner, row by row.
    const struct {
        CellPattern pattern;
        int number;
        const char* rows[4];
    } cases[] = {
        {CellPattern::same, 2, {"0000", "0000", "0000", "0000"}},
        {CellPattern::columns, 2, {"0101", "0101", "0101", "0101"}},
        {CellPattern::rows, 2, {"0000", "1111", "0000", "1111"}},
        {CellPattern::checkerboard, 2, {"0101", "1010", "0101", "1010"}},
        {CellPattern::staggered, 4, {"0202", "1313", "2020", "3131"}},
        {CellPattern::staggered, 3, {"0202", "1010", "2020", "0101"}},
    };
    for (const auto& c : cases)
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                const Subpixels cells = cells_of(c.pattern, c.number);
                BOOST_TEST(cell_of(cells, column, row) == c.rows[row][column] - '0');
                BOOST_TEST(cell_of(cells, column - 8, row - 4) ==
                           cell_of(cells, column, row)); // beyond the film, too
                const Vec2 place = cells.cell[cell_of(cells, column, row)][0];
                const Vec2 red = subpixel_centre(cells, column, row, 0);
                BOOST_TEST(red.x == column + 0.5 + place.x);
                BOOST_TEST(red.y == row + 0.5 - place.y);
            }
}

BOOST_AUTO_TEST_CASE(the_nearest_subpixel_is_the_nearest_of_all)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> anywhere(4, 16);
    for (const Subpixels& layout : layouts())
        for (int trial = 0; trial < 3000; ++trial) {
            const Vec2 point{anywhere(random), anywhere(random)};
            const int channel = trial % 3;
            double least = 1e9;
            for (int row = 0; row < 20; ++row)
                for (int column = 0; column < 20; ++column)
                    least = std::min(least,
                                     length(subpixel_centre(layout, column, row, channel) - point));
            const PixelPlace found = pixel_of_nearest_subpixel(layout, point, channel);
            BOOST_TEST(std::fabs(length(subpixel_centre(layout, found.column, found.row, channel) -
                                        point) -
                                 least) < 1e-12);
        }
}

BOOST_AUTO_TEST_CASE(a_pixel_s_subpixels_cover_as_much_as_it_does)
{
    for (const Subpixels& layout : layouts()) {
        const Vec2 size = subpixel_size(layout);
        BOOST_TEST(std::fabs(size.x * size.y * (layout == Subpixels::none ? 1 : 3) - 1) < 1e-15);
    }
}

BOOST_AUTO_TEST_CASE(layouts_are_alike_only_to_themselves)
{
    for (const Subpixels& a : layouts())
        for (const Subpixels& b : layouts())
            BOOST_TEST(same_layout(a, b) == (&a == &b));
    Subpixels moved = layouts().back();
    moved.cell[3][2].y += 1e-3;
    BOOST_TEST(!same_layout(moved, layouts().back()));
}

BOOST_AUTO_TEST_SUITE_END()
