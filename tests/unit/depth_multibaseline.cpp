// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the depth that is measured in light fields of known depth: planes painted with waves, whose
// rays are computed by a formula.
#include "integral/depth/depth_files.h"
#include "integral/depth/depth_scores.h"
#include "integral/depth/multibaseline.h"
#include "integral/depth/ray_trace.h"
#include "integral/optics/lens_mapping.h"
#include "tests/unit/replay_frames.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace integral;

namespace {

/// Paint at a point, with waves of `length` and longer.
Colour paint(double x, double y, double length)
{
    const double a = 2 * pi / length;
    const auto wave = [&](double across, double down, double phase) {
        return std::sin(a * (across * x + down * y) + phase);
    };
    const double r = wave(0.83, 0.41, 1) + wave(-0.31, 0.77, 2) + wave(0.53, -0.19, 0),
                 g = wave(0.67, -0.53, 3) + wave(0.29, 0.71, 0) + wave(-0.47, 0.11, 5),
                 b = wave(0.37, 0.89, 4) + wave(-0.91, 0.23, 1) + wave(0.13, 0.41, 2);
    return {float(0.5 + 0.15 * r), float(0.5 + 0.15 * g), float(0.5 + 0.15 * b), 1};
}

/// Two planes as seen from 5 x 5 eyes: one with the disparity `back`, and in front of it a square
/// with the disparity `front`.
struct TwoPlanes {
    static constexpr int size = 96, grid = 5;
    double back, front;

    bool in_square(double x, double y) const { return std::fabs(x) < 20 && std::fabs(y) < 20; }
    Image view(int column, int row) const
    {
        Image image = make_image<std::uint8_t>(size, size, 3, Encoding());
        const double eye_x = column - grid / 2, eye_y = row - grid / 2;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double px = x - 0.5 * size, py = y - 0.5 * size;
                const auto on = [&](double disparity) { // the point's place in the middle view
                    return Vec2{px + disparity * eye_x, py - disparity * eye_y};
                };
                const Vec2 near = on(front), far = on(back);
                store_pixel(image, x, y,
                            in_square(near.x, near.y) ? paint(near.x, near.y, 7)
                                                      : paint(far.y, far.x + 40, 9));
            }
        return image;
    }
    ViewSet views() const
    {
        std::vector<Image> all;
        for (int row = 0; row < grid; ++row)
            for (int column = 0; column < grid; ++column)
                all.push_back(view(column, row));
        return view_set(all, {grid, grid}, std::nullopt);
    }
    std::vector<float> truth() const
    {
        std::vector<float> truth;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                truth.push_back(float(in_square(x - 0.5 * size, y - 0.5 * size) ? front : back));
        return truth;
    }
};

double median_of(std::vector<float> values)
{
    std::vector<float> known;
    for (const float v : values)
        if (std::isfinite(v))
            known.push_back(v);
    BOOST_REQUIRE(!known.empty());
    std::nth_element(known.begin(), known.begin() + std::ptrdiff_t(known.size() / 2), known.end());
    return known[known.size() / 2];
}

/// A frame of a painted plane `depth` mm behind the sheet: each film pixel shows where its ray
/// meets the plane.
Frame frame_of_plane(const FrameMetadata& geometry, double depth)
{
    const SheetOptics optics(geometry.sheet, geometry.aperture);
    Frame frame;
    const Film& film = geometry.film;
    frame.image = make_image<std::uint16_t>(film.width, film.height, 3, Encoding());
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const auto mapped = optics.map(film_from_pixel(film, {x + 0.5, y + 0.5}),
                                           LensMapping::automatic);
            if (!mapped.ray)
                continue;
            const LensRay& ray = *mapped.ray;
            const double along = depth / ray.direction.z;
            store_pixel(frame.image, x, y,
                        paint(ray.pole.x + along * ray.direction.x,
                              ray.pole.y + along * ray.direction.y, 5 * geometry.sheet.pitch));
        }
    set_metadata(frame, geometry);
    return frame;
}

} // namespace

BOOST_AUTO_TEST_SUITE(depth_multibaseline)

BOOST_AUTO_TEST_CASE(planes_on_both_sides_and_their_edges)
{
    for (const TwoPlanes scene :
         {TwoPlanes{-1.37, 0.82}, TwoPlanes{-0.4, 0.05}, TwoPlanes{0.61, 1.73}}) {
        ViewSet views = scene.views();
        soften(views, 2);
        const auto map = multibaseline(views, {}, 2, {});
        BOOST_REQUIRE(map);
        const DepthScores scores = depth_scores(views, map->disparity, scene.truth(), 8);
        BOOST_TEST_CONTEXT("back " << scene.back << ", front " << scene.front)
        {
            BOOST_TEST(scores.all.bad[0] < 3);
            BOOST_TEST(scores.texture.bad[0] < 0.3);
            BOOST_TEST(scores.texture.bad[1] < 3);
            BOOST_TEST(map->range.least < scene.back);
            BOOST_TEST(map->range.greatest > scene.front);
        }
    }
}

BOOST_AUTO_TEST_CASE(outlines_stand_where_the_square_ends)
{
    const TwoPlanes scene{-0.4, 1.05};
    ViewSet views = scene.views();
    soften(views, 2);
    const auto map = multibaseline(views, {}, 2, {});
    BOOST_REQUIRE(map);
    // Each row through the square has as many pixels nearer than half-way as the square is wide.
    int nearer = 0, rows = 0;
    for (int y = scene.size / 2 - 12; y < scene.size / 2 + 12; ++y, ++rows)
        for (int x = 0; x < scene.size; ++x)
            nearer += map->disparity[std::size_t(y) * scene.size + x] >
                      0.5 * (scene.back + scene.front);
    const double wide = double(nearer) / rows, truth = 39; // columns 29 to 67: |x - 48| < 20
    BOOST_TEST(std::fabs(wide - truth) < 2 * 0.5);
}

BOOST_AUTO_TEST_CASE(reversed_rays_meet_on_planes_of_whole_pixels_and_at_ghosts_else)
{
    const auto bad = [](const TwoPlanes& scene, bool by_rays) {
        ViewSet views = scene.views();
        soften(views, 2);
        const auto map = by_rays ? ray_trace(views, {}, 2, {}) : multibaseline(views, {}, 2, {});
        BOOST_REQUIRE(map);
        return depth_scores(views, map->disparity, scene.truth(), 8).all.bad[0];
    };
    BOOST_TEST(bad({-1, 0.5}, true) < 5);
    const TwoPlanes between{-0.83, 0.37};
    BOOST_TEST(bad(between, true) > 20);
    BOOST_TEST(bad(between, false) < 3);
}

BOOST_AUTO_TEST_CASE(frames_of_all_sheets)
{
    const auto sheet = [](Arrangement arrangement, double slant, double pixel) {
        FrameMetadata geometry;
        geometry.sheet = {arrangement, 1.1, 3, 1.55, slant, {0.13, -0.2}};
        geometry.film = {240, 150, {pixel, pixel}};
        geometry.aperture = *filling_aperture(geometry.sheet, 300);
        return geometry;
    };
    for (const FrameMetadata& geometry :
         {sheet(Arrangement::lenticular, 0, 0.11), sheet(Arrangement::lenticular, 14, 0.1),
          sheet(Arrangement::square, 0, 0.11), sheet(Arrangement::square, 0, 0.123),
          sheet(Arrangement::square, 17, 0.11), sheet(Arrangement::hexagonal, 0, 0.1)})
        for (const double depth : {-22.0, 0.0, 27.0}) {
            ViewSet views = view_set(frame_of_plane(geometry, depth), 2, {});
            soften(views, 2);
            const auto map = multibaseline(views, {}, 2, {});
            BOOST_REQUIRE(map);
            BOOST_REQUIRE(views.scale);
            BOOST_TEST_CONTEXT("arrangement " << int(geometry.sheet.arrangement) << ", slant "
                                              << geometry.sheet.slant << ", pixel "
                                              << geometry.film.pixel_pitch.x << ", depth " << depth)
            {
                const double found = views.scale->mm(median_of(map->disparity));
                BOOST_TEST(std::fabs(found - depth) < 0.8);
                std::vector<float> truth(views.pixels(), float(views.scale->disparity(depth)));
                const DepthScores scores = depth_scores(views, map->disparity, truth, 1);
                BOOST_TEST(scores.all.bad[0] < 5);
            }
        }
}

BOOST_AUTO_TEST_CASE(lenses_of_very_many_pixels_give_255_views_each_way)
{
    FrameMetadata geometry;
    geometry.sheet = {Arrangement::lenticular, 60, 150, 1.55, 0, {}};
    geometry.film = {2400, 1, {0.1, 0.1}};
    geometry.aperture = *filling_aperture(geometry.sheet, 3000);
    const Vec2 zone = viewing_zone(geometry.sheet, geometry.aperture);
    const ViewSet views = view_set(frame_of_plane(geometry, 0), 2, {});
    BOOST_TEST(views.others.size() == 254u);
    BOOST_TEST(views.scale->ratio * length(views.places.right) == zone.x / 256,
               boost::test_tools::tolerance(1e-12));
    // A lens larger than the film: 2700 pixels against 2400.
    geometry.sheet.pitch = 270;
    geometry.sheet.thickness = 700;
    geometry.aperture = *filling_aperture(geometry.sheet, 3000);
    Frame frame{make_image<std::uint8_t>(2400, 1, 3, Encoding()), std::nullopt};
    set_metadata(frame, geometry);
    BOOST_CHECK_EXCEPTION(
        view_set(frame, 2, {}), std::invalid_argument, [](const std::invalid_argument& error) {
            return std::string(error.what())
                       .find("a lens is as large as 2700x1 pixels, more than the whole "
                             "film") == 0;
        });
}

BOOST_AUTO_TEST_CASE(dark_pixels_are_not_measured)
{
    FrameMetadata geometry;
    geometry.sheet = {Arrangement::square, 1.1, 3, 1.55, 0, {}};
    geometry.film = {220, 110, {0.11, 0.11}};
    geometry.aperture = *filling_aperture(geometry.sheet, 300);
    geometry.aperture.width *= 0.6; // underfilled: dark bands at the sides of each micro-image
    const ViewSet views = view_set(frame_of_plane(geometry, 15), 2, {});
    const auto map = multibaseline(views, {}, 2, {});
    BOOST_REQUIRE(map);
    BOOST_TEST(std::fabs(views.scale->mm(median_of(map->disparity)) - 15) < 1);
    const SheetOptics optics(geometry.sheet, geometry.aperture);
    for (const DepthView& view : views.others)
        for (const float lit : view.lit)
            BOOST_TEST_REQUIRE((lit == 0 || lit == 1));
}

BOOST_AUTO_TEST_CASE(scale_and_its_inverse)
{
    const DepthScale scale{400, 1.3};
    for (const double mm : {-150.0, -3.0, 0.0, 8.0, 1e4})
        BOOST_TEST(scale.mm(scale.disparity(mm)) == mm, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(scale.disparity(-50) > 0);
    BOOST_TEST(scale.disparity(1e12) == -1.3, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(std::isinf(scale.mm(-1.4)));
}

BOOST_AUTO_TEST_CASE(scores_are_the_toolkits)
{
    // Ten pixels with known errors, one of them not finite. The lower quartile of the other nine is
    // the third smallest.
    ViewSet views;
    views.width = 10;
    views.height = 1;
    for (auto& channel : views.colours)
        channel.assign(10, 0.5f);
    const std::vector<float> truth(10, 1),
        found{1, 1.005f, 0.98f, 1.02f, 1.05f, 0.95f, 1.1f, 2, NAN, 1};
    const DepthScores scores = depth_scores(views, found, truth, 0);
    BOOST_TEST(scores.all.pixels == 9u);
    BOOST_TEST(scores.all.bad[0] == 100 * 2 / 9., boost::test_tools::tolerance(1e-6));
    BOOST_TEST(scores.all.bad[1] == 100 * 4 / 9., boost::test_tools::tolerance(1e-6));
    BOOST_TEST(scores.all.bad[2] == 100 * 6 / 9., boost::test_tools::tolerance(1e-6));
    const double squares = 0.005 * 0.005 + 2 * 0.02 * 0.02 + 2 * 0.05 * 0.05 + 0.01 + 1;
    BOOST_TEST(scores.all.mse == 100 * squares / 9, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(scores.all.lower == 0.5, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(scores.texture.pixels == 0u);
}

BOOST_AUTO_TEST_CASE(planes_are_told_by_the_truth_and_scored_by_their_bumps)
{
    // A plane next to a bowl. An error that grows evenly over the plane leaves it smooth; one that
    // is curved counts as bumpiness.
    ViewSet views;
    views.width = 40;
    views.height = 12;
    for (auto& channel : views.colours)
        channel.assign(views.pixels(), 0.5f);
    std::vector<float> truth, smooth, bumpy;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 40; ++x) {
            const double bowl = x < 20 ? 0 : 0.003 * (x - 19) * (x - 19);
            truth.push_back(float(0.01 * x - 0.02 * y + bowl));
            smooth.push_back(truth.back() + 0.045f + 0.01f * float(x));
            bumpy.push_back(truth.back() + float(0.001 * x * x)); // its second difference is 0.002
        }
    const DepthScores without = depth_scores(views, smooth, truth, 0),
                      with = depth_scores(views, bumpy, truth, 0);
    BOOST_TEST(without.planes.pixels == 16u * 8u); // columns 2 to 17, rows 2 to 9
    BOOST_TEST(without.planes.bad[0] == 100 * 15 / 16., boost::test_tools::tolerance(1e-6));
    BOOST_TEST(without.bumpiness < 1e-4);
    BOOST_TEST(with.bumpiness == 0.2, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
