// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests light fields: which film point and which lens a sample belongs to, and which direction.
#include "integral/views/light_field.h"

#include "integral/frame/recorded_camera.h"
#include "integral/views/parallel_views.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace integral;

BOOST_AUTO_TEST_SUITE(views_light_field)

namespace {

FrameMetadata geometry(Arrangement arrangement, double slant, int width, int height, double pixel)
{
    FrameMetadata m;
    m.sheet = {arrangement, 1.2, 3.08, 1.6, slant, {0.05, 0.1}};
    m.film = {width, height, {pixel, pixel}};
    m.aperture = {300, 200, 200, ApertureShape::rectangle};
    return m;
}

/// Each pixel's column and row, as red and green of linear light.
Frame places(const FrameMetadata& m)
{
    Frame frame;
    frame.image = make_image<float>(m.film.width, m.film.height, 3, {Encoding::Kind::linear});
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x)
            store_pixel(frame.image, x, y, {x + 0.5f, y + 0.5f, 1, 1});
    set_metadata(frame, m);
    return frame;
}

} // namespace

BOOST_AUTO_TEST_CASE(samples_show_their_film_points)
{
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 9.0, 90.0})
            for (const double pixel : {0.1, 0.087}) {
                const Frame frame = places(geometry(arrangement, slant, 101, 77, pixel));
                const FrameMetadata& m = *frame.metadata;
                const LightFieldAxes axes(m, natural_views(m));
                const bool whole = pixel == 0.1 && arrangement != Arrangement::hexagonal &&
                                   slant != 9;
                BOOST_TEST(axes.is_exact() == whole);
                const Image samples = *light_field_samples(frame, axes, 1);
                const auto mask = light_field_mask(m, axes, 1);
                const SheetOptics optics = recorded_camera(m).optics;
                std::size_t at = 0, imaged = 0;
                for (int v = 0; v < axes.v(); ++v)
                    for (int u = 0; u < axes.u(); ++u)
                        for (int t = 0; t < axes.t(); ++t)
                            for (int s = 0; s < axes.s(); ++s, ++at) {
                                if (!mask[at])
                                    continue;
                                ++imaged;
                                const Vec2 point = axes.film_point(v, u, t, s);
                                const Vec2 pixels = pixel_from_film(m.film, point);
                                const int row = (v * axes.u() + u) * axes.t() + t;
                                const Colour c = stored_pixel(samples, s, row);
                                BOOST_REQUIRE(std::fabs(c.r - pixels.x) < 1e-4);
                                BOOST_REQUIRE(std::fabs(c.g - pixels.y) < 1e-4);
                                // The mask's lens, whose ray goes where the axes say.
                                const auto ray = optics.map(point, LensMapping::automatic).ray;
                                BOOST_REQUIRE(ray);
                                const Vec2 pole = axes.pole(t, s);
                                BOOST_REQUIRE((ray->lens == optics.lattice().nearest(pole)));
                                if (arrangement == Arrangement::lenticular)
                                    continue; // the slit fixes the other component
                                const Vec2 way = *axes.aperture_point(v, u, m.aperture.distance);
                                BOOST_REQUIRE(length(pole + way - ray->aperture_point) < 1e-6);
                            }
                BOOST_TEST(imaged > mask.size() / 4);
            }
}

BOOST_AUTO_TEST_CASE(hexagonal_rows_alternate)
{
    const FrameMetadata m = geometry(Arrangement::hexagonal, 0, 101, 77, 0.1);
    const LightFieldAxes axes(m, {6, 5});
    BOOST_TEST(axes.u() == 6);
    BOOST_TEST(axes.v() == 5);
    for (int t = 1; t < axes.t(); ++t) {
        BOOST_TEST(std::fabs(axes.pole(t, 0).x - axes.pole(t - 1, 0).x) == 0.6,
                   boost::test_tools::tolerance(1e-12));
        BOOST_TEST(axes.pole(t - 1, 0).y - axes.pole(t, 0).y == 1.2 * std::sqrt(0.75),
                   boost::test_tools::tolerance(1e-12));
        BOOST_TEST(axes.pole(t, 1).x - axes.pole(t, 0).x == 1.2,
                   boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(a_film_without_a_whole_lens_is_refused)
{
    const FrameMetadata m = geometry(Arrangement::square, 0, 7, 7, 0.1);
    BOOST_CHECK_THROW(LightFieldAxes(m, natural_views(m)), std::invalid_argument);
    FrameMetadata projected = geometry(Arrangement::square, 0, 101, 77, 0.1);
    projected.projection = ProjectionLens();
    BOOST_CHECK_THROW(LightFieldAxes(projected, {12, 12}), std::invalid_argument);
    BOOST_CHECK_THROW(recorded_camera(m, CameraSpace::scene), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
