// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests a lens's cell: the points through which the models send light, and whether the lens's
// surface reaches the cell's edge.
#include "integral/optics/lens_model.h"

#include <boost/test/unit_test.hpp>

#include <map>
#include <utility>

using namespace integral;

namespace {

const Arrangement arrangements[] = {Arrangement::lenticular, Arrangement::square,
                                    Arrangement::hexagonal};

} // namespace

BOOST_AUTO_TEST_SUITE(optics_cells)

BOOST_AUTO_TEST_CASE(cells_are_filled_evenly)
{
    // Checks mean, second moments and area of the cell, that (1/2, 1/2) is the pole, and that every
    // point belongs to its own lens.
    constexpr int n = 300;
    for (Arrangement arrangement : arrangements)
        for (double slant : {0.0, 20.0, -67.0}) {
            const LensSheet sheet{arrangement, 0.8, 3, 1.6, slant, {0.1, 0.2}};
            const Lattice lattice(sheet);
            const bool lenticular = arrangement == Arrangement::lenticular;
            BOOST_TEST(length(cell_point(lattice, {0.5, 0.5}, 7).offset) == 0);
            BOOST_TEST(cell_point(lattice, {0.5, 0.5}, 7).slit == 0);
            double sums[6] = {}, farthest = 0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const Vec2 unit{(i + 0.5) / n, (j + 0.5) / n};
                    const LensPoint point = cell_point(lattice, unit, 7);
                    const double x = dot(point.offset, lattice.across());
                    const double y = lenticular ? point.slit : dot(point.offset, lattice.along());
                    const double terms[] = {x, y, x * x, y * y, x * y, x * x * x};
                    for (int k = 0; k < 6; ++k)
                        sums[k] += terms[k] / (n * n);
                    farthest = std::fmax(farthest, length(point.offset));
                    const LensIndex lens{-4, lenticular ? 0 : 3};
                    const Vec2 where = lattice.pole(lens) + point.offset;
                    BOOST_TEST(lattice.distance(where, lens) <=
                               lattice.distance(where, lattice.nearest(where)) + 1e-12);
                    // The area is the map's determinant, except where the map is folded.
                    const double step = 1e-6;
                    const LensPoint right = cell_point(lattice, unit + Vec2{step, 0}, 7);
                    const LensPoint up = cell_point(lattice, unit + Vec2{0, step}, 7);
                    const Vec2 u = right.offset - point.offset, v = up.offset - point.offset;
                    const double area = lenticular ? length(u) * (up.slit - point.slit)
                                                   : u.x * v.y - u.y * v.x;
                    const double rows = arrangement == Arrangement::square ? 1 : std::sqrt(0.75);
                    const double cell = lenticular ? 0.8 * 7 : 0.64 * rows;
                    if (length(u) < 0.1 && length(v) < 0.1)
                        BOOST_TEST(area / (step * step) == cell,
                                   boost::test_tools::tolerance(1e-6));
                }
            const double moment = arrangement == Arrangement::hexagonal ? 5.0 / 72 : 1.0 / 12;
            BOOST_TEST(std::fabs(sums[0]) < 1e-3);
            BOOST_TEST(std::fabs(sums[1]) < 1e-3);
            BOOST_TEST(sums[2] == 0.64 * moment, boost::test_tools::tolerance(1e-3));
            BOOST_TEST(sums[3] == (lenticular ? 49.0 : 0.64) * moment,
                       boost::test_tools::tolerance(1e-3));
            BOOST_TEST(std::fabs(sums[4]) < 1e-3);
            BOOST_TEST(std::fabs(sums[5]) < 1e-3);
            BOOST_TEST(farthest <= cell_circumradius(sheet));
            BOOST_TEST(farthest > 0.98 * cell_circumradius(sheet));
        }
}

BOOST_AUTO_TEST_CASE(tents_of_all_lenses_add_up_to_one)
{
    // Counts how often points of neighbouring lenses' tents fall into the squares of a grid over a
    // lens's cell.
    constexpr int n = 600, grid = 5;
    for (Arrangement arrangement : {Arrangement::square, Arrangement::hexagonal})
        for (double slant : {0.0, 33.0}) {
            const Lattice lattice({arrangement, 0.8, 3, 1.6, slant, {0.1, 0.2}});
            BOOST_TEST(length(tent_point(lattice, {0.5, 0.5}, 7).offset) == 0);
            std::map<std::pair<int, int>, double> found;
            double outermost[2] = {}, moments[2] = {};
            const double row = arrangement == Arrangement::hexagonal ? std::sqrt(0.75) : 1;
            const double size[2] = {0.8, 0.8 * row};
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const Vec2 at = tent_point(lattice, {(i + 0.5) / n, (j + 0.5) / n}, 7).offset;
                    const double part[2] = {dot(at, lattice.across()) / size[0],
                                            dot(at, lattice.along()) / size[1]};
                    // Subtracting the lens's place in the lattice, where odd rows are shifted,
                    // leaves the place in the cell.
                    const double j_row = std::floor(part[1]);
                    const double shift = arrangement == Arrangement::hexagonal &&
                                                 std::fmod(std::fabs(j_row), 2) == 1
                                             ? 0.5
                                             : 0;
                    const double x = part[0] - shift, y = part[1];
                    ++found[{int(std::floor((x - std::floor(x)) * grid)),
                             int(std::floor((y - j_row) * grid))}];
                    for (int k = 0; k < 2; ++k) {
                        outermost[k] = std::fmax(outermost[k], std::fabs(part[k]));
                        moments[k] += part[k] * part[k] / (n * n);
                    }
                }
            BOOST_TEST(found.size() == std::size_t(grid * grid));
            for (const auto& [square, number] : found)
                BOOST_TEST(number / (n * n) == 1.0 / (grid * grid),
                           boost::test_tools::tolerance(0.02));
            for (int k = 0; k < 2; ++k) {
                BOOST_TEST(moments[k] == 1.0 / 6, boost::test_tools::tolerance(1e-3)); // a tent's
                BOOST_TEST(outermost[k] <= 1);
                BOOST_TEST(outermost[k] > 0.95);
            }
        }
    const Lattice cylinders({Arrangement::lenticular, 0.8, 3, 1.6, 12, {0, 0}});
    BOOST_TEST(dot(tent_point(cylinders, {0.125, 0.75}, 7).offset, cylinders.across()) == -0.4,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(tent_point(cylinders, {0.125, 0.75}, 7).slit == 1.75);
}

BOOST_AUTO_TEST_CASE(hybrid_weights)
{
    // Normalised values of I (thesis 3.4.7) at the pole and at the margin.
    for (Arrangement arrangement : arrangements) {
        const Lattice lattice({arrangement, 1.27, 3.08, 1.6, 12, {0, 0}});
        const auto points = hybrid_points(lattice);
        const bool lenticular = arrangement == Arrangement::lenticular;
        BOOST_TEST_REQUIRE(points.size() == (lenticular ? 3u : 5u));
        double sum = 0;
        Vec2 middle;
        for (const auto& one : points) {
            sum += one.weight;
            middle = middle + one.point.offset;
        }
        BOOST_TEST(sum == 1, boost::test_tools::tolerance(1e-15));
        BOOST_TEST(length(middle) < 1e-15);
        BOOST_TEST(length(points[0].point.offset) == 0);
        BOOST_TEST(std::fabs(points[0].weight - (lenticular ? 0.6734 : 0.5076)) < 5e-5);
        for (std::size_t k = 1; k < points.size(); ++k) {
            BOOST_TEST(std::fabs(points[k].weight - (lenticular ? 0.1633 : 0.1231)) < 5e-5);
            BOOST_TEST(length(points[k].point.offset) == 0.635,
                       boost::test_tools::tolerance(1e-14));
            BOOST_TEST(std::fabs(dot(points[k].point.offset,
                                     k < 3 ? lattice.along() : lattice.across())) < 1e-15);
        }
    }
}

BOOST_AUTO_TEST_CASE(which_sheets_have_a_surface)
{
    // R = t (n - 1)/n = 1.155 for the thesis's sheet; circumradii p/2, p/sqrt 2, p/sqrt 3
    LensSheet sheet;
    BOOST_TEST(surface_radius(sheet) == 1.155, boost::test_tools::tolerance(1e-12));
    const double radii[] = {0.635, 0.898026, 0.733235};
    for (Arrangement arrangement : arrangements) {
        const double radius = radii[int(arrangement)];
        sheet = LensSheet();
        sheet.arrangement = arrangement;
        BOOST_TEST(cell_circumradius(sheet) == radius, boost::test_tools::tolerance(1e-6));
        BOOST_TEST(has_surface(sheet));
        sheet.thickness = radius * 1.6 / 0.6 * 1.0001;
        BOOST_TEST(has_surface(sheet));
        sheet.thickness = radius * 1.6 / 0.6 * 0.9999;
        BOOST_TEST(!has_surface(sheet));
        sheet.thickness = 1e6;
        sheet.ior = 1;
        BOOST_TEST(!has_surface(sheet));
    }
    for (LensModel model :
         {LensModel::pinhole, LensModel::extended_pinhole, LensModel::hybrid, LensModel::full})
        BOOST_TEST(modelled_sheet(LensSheet(), model).ior ==
                   (model == LensModel::pinhole ? 1 : 1.6));
}

BOOST_AUTO_TEST_SUITE_END()
