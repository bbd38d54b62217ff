// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/beam_samples.h"
#include "integral/reconstruction/layer_plane.h"

#include <boost/test/unit_test.hpp>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(reconstruction_layer_plane)

BOOST_AUTO_TEST_CASE(lines_cross_the_plane_of_the_places)
{
    // Enough places that the fit's damping does not show.
    const double at_centre = 5, by_x = 2, by_y = -0.5;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-1, 1), slope(-0.2f, 0.2f);
    LinearSums<float> sums;
    for (int k = 0; k < 40000; ++k) {
        const float x = place(random), y = place(random);
        const float weight = 0.5f + place(random) * 0.4f;
        sums.add(weight, weight * float(at_centre + by_x * x + by_y * y), x, y);
    }
    BOOST_TEST(sums.value / sums.weight == at_centre, boost::test_tools::tolerance(0.01));
    const LayerPlane plane(sums, {1, 1}, furthest_depth_of_frames);

    Eight lines[4];
    for (std::size_t i = 0; i < 8; ++i)
        for (int k = 0; k < 4; ++k)
            lines[k][i] = k < 2 ? 3 * place(random) : slope(random);
    lines[2][7] = 0.8f; // leans more than the plane
    lines[3][7] = 0;
    const auto crossing = plane.crossing<TwiceFourFloats>(lines);
    Eight depths, towards;
    store(depths, crossing.depth);
    store(towards, crossing.towards);
    for (std::size_t i = 0; i < 8; ++i) {
        const double way = 1 - by_x * lines[2][i] - by_y * lines[3][i];
        BOOST_TEST((towards[i] > 0) == (way > 0));
        if (way > 0)
            BOOST_TEST(depths[i] == (at_centre + by_x * lines[0][i] + by_y * lines[1][i]) / way,
                       boost::test_tools::tolerance(0.01));
    }
    BOOST_TEST(!(towards[7] > 0));
}

BOOST_AUTO_TEST_CASE(a_single_place_lies_across_the_beam)
{
    LinearSums<float> sums;
    sums.add(0.3f, 0.3f * 40, 0.2f, -0.1f);
    const LayerPlane plane(sums, {1, 1}, furthest_depth_of_frames);
    Eight lines[4]{};
    lines[0][3] = 0.9f;
    lines[2][5] = 2;
    Eight depths;
    store(depths, plane.crossing<TwiceFourFloats>(lines).depth);
    for (std::size_t i = 0; i < 8; ++i)
        BOOST_TEST(depths[i] == 40, boost::test_tools::tolerance(1e-4f));
}

BOOST_AUTO_TEST_SUITE_END()
