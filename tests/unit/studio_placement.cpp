// SPDX-License-Identifier: AGPL-3.0-or-later
// The studio's settings: the frames that they make, and the probes that these need.
#include "integral/base/json.h"
#include "integral/studio/placement_settings.h"
#include "integral/studio/probe.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace integral;

namespace {

constexpr double probe_distance = 6, window = 4; // scene units: the window's width at that distance

/// A scene whose surfaces are 3 to 30 units from its eye, at the origin, which looks along z.
DepthFrame scene_probe()
{
    DepthFrame probe;
    FrameMetadata& frame = probe.metadata;
    frame.film = {200, 150, {0.5, 0.5}};
    const double unit = window / size_of(frame.film).x; // scene units per mm
    Placement placement;
    placement.origin = {0, 0, probe_distance};
    placement.x = {unit, 0, 0};
    placement.y = {0, unit, 0};
    placement.z = {0, 0, unit};
    placement.units_per_mm = unit;
    placement.sheet_distance = probe_distance;
    frame.placement = placement;
    frame.aperture.distance = probe_distance / unit;
    for (int k = 0; k <= 100; ++k)
        probe.eye_distances.push_back(float(3 * std::pow(10.0, k / 100.0)));
    return probe;
}

} // namespace

BOOST_AUTO_TEST_SUITE(studio_placement)

BOOST_AUTO_TEST_CASE(the_window_keeps_its_angle_at_every_distance)
{
    const DepthFrame probe = scene_probe();
    PlacementSettings settings = first_settings();
    settings.print = print_of_aspect(4.0 / 3);
    settings.parallax = 0.2;
    for (const double distance : {2.0, 6.0, 25.0}) {
        settings.sheet_distance = distance;
        const FrameMetadata frame = frame_of_settings(settings, &probe);
        const Placement& placement = *frame.placement;
        const double width = size_of(frame.film).x;
        BOOST_TEST(placement.origin.z == distance, boost::test_tools::tolerance(1e-12));
        BOOST_TEST(placement.units_per_mm * width == window * distance / probe_distance,
                   boost::test_tools::tolerance(1e-12));
        BOOST_TEST(placement.x.x == placement.units_per_mm, boost::test_tools::tolerance(1e-12));
        BOOST_TEST(frame.parallax->scene_distance * placement.units_per_mm == distance,
                   boost::test_tools::tolerance(1e-12));
        BOOST_TEST(frame.parallax->factor == 0.2);
    }
}

BOOST_AUTO_TEST_CASE(a_fit_keeps_what_is_given)
{
    const DepthFrame probe = scene_probe();
    PlacementSettings settings = first_settings();
    settings.print = print_of_aspect(4.0 / 3);
    const FrameMetadata fitted = frame_of_settings(settings, &probe);
    BOOST_TEST(fitted.parallax->factor < 1);
    BOOST_TEST(fitted.placement->sheet_distance > 3);
    BOOST_TEST(fitted.placement->sheet_distance < 30);
    settings.sheet_distance = 12;
    BOOST_TEST(frame_of_settings(settings, &probe).placement->sheet_distance == 12);
    settings.sheet_distance.reset();
    settings.parallax = 0.05;
    BOOST_TEST(frame_of_settings(settings, &probe).parallax->factor == 0.05);
}

BOOST_AUTO_TEST_CASE(side_views_reach_the_edges_of_the_region_of_the_eyes)
{
    const DepthFrame probe = scene_probe();
    PlacementSettings settings = first_settings();
    settings.print = print_of_aspect(4.0 / 3);
    settings.sheet_distance = 9;
    settings.parallax = 0.1;
    const FrameMetadata frame = frame_of_settings(settings, &probe);
    const ProbeRequest request = probe_for(frame, probe_distance);
    BOOST_TEST(request.grid.columns == 3);
    BOOST_TEST(request.grid.rows == 1); // lenticular: views differ sideways only
    // The outer of three eyes is at a third of the zone. Scene units, both.
    const double outer = request.zone.x * window / 3,
                 edge = 0.1 * viewing_zone(frame.sheet, frame.aperture).x / 2 *
                        frame.placement->units_per_mm;
    BOOST_TEST(outer == edge, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(serves(request, request));
    settings.parallax = 0.2;
    BOOST_TEST(!serves(request, probe_for(frame_of_settings(settings, &probe), probe_distance)));
    settings.parallax = 0;
    BOOST_TEST(probe_for(frame_of_settings(settings, &probe), probe_distance).grid.count() == 1);
}

BOOST_AUTO_TEST_CASE(settings_read_back_from_their_json)
{
    PlacementSettings settings = first_settings();
    settings.print = print_of_aspect(0.75);
    settings.sheet_distance = 1.5;
    const PlacementSettings read = settings_from_json(json_of(settings).dump());
    BOOST_TEST(read.sheet.pitch == settings.sheet.pitch);
    BOOST_TEST(read.print.y == 150);
    BOOST_TEST(read.sheet_distance.value() == 1.5);
    BOOST_TEST(!read.parallax.has_value());
    BOOST_CHECK_THROW(settings_from_json("[]"), std::invalid_argument);
    settings.print = {1e9, 75};
    BOOST_CHECK_THROW(frame_of_settings(settings, nullptr), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
