// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which pixels' samples a pixel may use.
#include "integral/reconstruction/beam_footprint.h"
#include "tests/unit/pixel_origins.h"

#include <boost/test/unit_test.hpp>
#include <cstdlib>

using namespace pixel_origins;

BOOST_AUTO_TEST_SUITE(reconstruction_beam_footprint)

BOOST_AUTO_TEST_CASE(far_places_are_seen_by_more_lenses)
{
    // The greatest number of lenses between a pixel and another whose beam meets its own at a
    // depth.
    const auto furthest = [](Arrangement arrangement, float depth) {
        constexpr int side = 200;
        CameraParameters parameters = parameters_of(arrangement);
        parameters.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
        const IntegralCamera camera = camera_of(parameters, side, side);
        const ReuseNeighbourhood lending(camera.optics.lattice(), camera.film);
        const LightFieldImage::StoredLens own{100, 100};
        ReuseNeighbourhood::Scratch scratch;
        int most = 0;
        lending.find(side / 2, side / 2, own, BeamFootprint(camera, LightFieldRay{}, {1, 1}, 0),
                     depth, depth, scratch);
        for (const ReuseNeighbourhood::Found& found : scratch)
            most = std::max(most, std::abs(found.lens[0] - own[0]));
        return most;
    };
    BOOST_TEST(furthest(Arrangement::lenticular, 0) == 0);
    BOOST_TEST(furthest(Arrangement::lenticular, 5) == 1);
    BOOST_TEST(furthest(Arrangement::lenticular, 7) == 2);
    BOOST_TEST(furthest(Arrangement::lenticular, 200) == 3);
    BOOST_TEST(furthest(Arrangement::square, 0) == 0);
    BOOST_TEST(furthest(Arrangement::square, 200) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
