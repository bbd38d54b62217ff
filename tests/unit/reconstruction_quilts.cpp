// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the samples of a quilt's views, and the reconstruction of anti-aliased quilts, on scenes in
// closed form.
#include "integral/frame/view_eyes.h"
#include "integral/reconstruction/pass_rows.h"
#include "integral/reconstruction/view_reuse.h"
#include "integral/sampling/quilt_sampler.h"
#include "tests/unit/sampled_frame.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <set>

using namespace sampled_frame;

namespace {

/// A quilt of 160 x 90 pixels: 12 views of upright (or lying) lenticular lenses in 4 x 3 tiles, or
/// 4 x 3 views of square lenses. `more`: columns and rows of pixels that are left over. `zone`:
/// width and height of the zone of the eyes, mm (nothing: the sheet's).
QuiltSampler quilt_of(Arrangement arrangement, double slant = 0, std::uint64_t seed = 3,
                      int more = 0, std::optional<Vec2> zone = {})
{
    CameraParameters p = sheet(arrangement, slant);
    p.film.pixel_pitch = {0.5, 0.5};
    p.capture_aperture = zone;
    return QuiltSampler(camera_of(p, 160, 90), {4, 3}, 160 + more, 90 + more, seed);
}

constexpr struct {
    Arrangement arrangement;
    double slant;
} sheets[] = {
    {Arrangement::lenticular, 0}, {Arrangement::lenticular, 90}, {Arrangement::square, 0}};

/// A quilt of a scene, with one sample a pixel.
struct SampledQuilt {
    QuiltSampler sampler;
    QuiltGeometry geometry = sampler.geometry();
    LightFieldImage first{geometry.width, geometry.height};
    BeamSamples samples{geometry.width, geometry.height, ViewReuse(geometry).most_tilt(),
                        ViewReuse(geometry).footprint().furthest_depth()};
    Reconstruction reconstruction{geometry, first, samples, 0.0005};

    SampledQuilt(QuiltSampler quilt, const Scene& scene) : sampler(std::move(quilt))
    {
        for (int y = 0; y < geometry.height; ++y)
            for (int x = 0; x < geometry.width; ++x) {
                const BeamRay ray = *sampler.sample(x, y, false, 0);
                const Look look = scene(ray);
                const float grey = float(look.grey);
                const double value = encode(grey);
                const auto line = [&](const BeamRay& one) {
                    return light_field_ray(sampler.upright(), one);
                };
                samples.set_first(x, y, line(*sampler.ray({x + 0.5, y + 0.5})), *sampler.tile(x, y),
                                  {line(ray), look.depth, {grey, grey, grey, 0}, look.tilt});
                first.set(x, y, {value, value, value, 0}, *sampler.tile(x, y), look.depth);
                reconstruction.set(x, y, {grey, grey, grey, 0}, 0.05);
            }
    }

    /// The RMS errors of the pixels at least 4 away from their tile's edge: of the first samples,
    /// and reconstructed.
    std::array<double, 2> errors(const Scene& scene)
    {
        const auto scratch = Reconstruction::make_scratch();
        std::vector<Reconstruction::Result> pixels;
        const PictureBlock all{0, 0, geometry.width - 1, geometry.height - 1};
        reconstruction.estimate(all, all, *scratch);
        reconstruction.reconstruct(all, encode, *scratch, pixels);
        std::array<double, 2> sums{};
        int number = 0;
        const auto is_inside = [](int place, int side) {
            return place % side >= 4 && place % side < side - 4;
        };
        for (int y = 0; y < geometry.height; y += 2)
            for (int x = 0; x < geometry.width; x += 3) {
                if (!is_inside(x, geometry.tile_width) || !is_inside(y, geometry.tile_height))
                    continue;
                double right = 0;
                constexpr int rays = 256;
                for (int k = 0; k < rays; ++k)
                    right += scene(*sampler.reference(x, y, 7, unsigned(k))).grey / rays;
                const auto square = [&](double grey) {
                    return std::pow(encode(float(grey)) - encode(float(right)), 2);
                };
                const auto& light = pixels[std::size_t(y) * geometry.width + x];
                const double own = scene(*sampler.sample(x, y, false, 0)).grey;
                sums[0] += square(own);
                sums[1] += square(light ? (*light)[1] : own);
                ++number;
            }
        return {std::sqrt(sums[0] / number), std::sqrt(sums[1] / number)};
    }
};

double ratio_of(Arrangement arrangement, double slant, const Scene& scene,
                std::optional<Vec2> zone = {})
{
    double before = 0, after = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const auto errors = SampledQuilt(quilt_of(arrangement, slant, seed, 0, zone), scene)
                                .errors(scene);
        before += errors[0] * errors[0];
        after += errors[1] * errors[1];
    }
    return std::sqrt(after / before);
}

/// Whether a ray goes to the eye of the view of pixel (x, y), from within the pixel.
bool is_of_pixel(const QuiltSampler& sampler, int x, int y, const BeamRay& ray)
{
    const BeamRay left_top = *sampler.ray({double(x), y + 1e-9}),
                  right_bottom = *sampler.ray({x + 1 - 1e-9, y + 1 - 2e-9});
    const auto to_eye = [&](const BeamRay& one) {
        const double way = -sampler.geometry().distance / one.direction.z;
        return Vec2{one.point.x + way * one.direction.x, one.point.y + way * one.direction.y};
    };
    return length(to_eye(ray) - to_eye(left_top)) < 1e-6 && ray.point.x >= left_top.point.x &&
           ray.point.x <= right_bottom.point.x && ray.point.y <= left_top.point.y &&
           ray.point.y >= right_bottom.point.y;
}

} // namespace

BOOST_AUTO_TEST_SUITE(reconstruction_quilts)

BOOST_AUTO_TEST_CASE(samples_are_of_their_pixel)
{
    for (const auto& one : sheets) {
        for (const int more : {0, 1}) {
            const QuiltSampler sampler = quilt_of(one.arrangement, one.slant, 3, more);
            for (const auto& [x, below] : {std::pair(0, 0), {39, 29}, {40, 30}, {159, 89}, {77, 63}})
                for (unsigned k = 0; k < 20; ++k) {
                    const int y = below + more;
                    BOOST_TEST(is_of_pixel(sampler, x, y, *sampler.sample(x, y, false, k)));
                    BOOST_TEST(is_of_pixel(sampler, x, y, *sampler.reference(x, y, 1, k)));
                }
        }
        const QuiltSampler spare = quilt_of(one.arrangement, one.slant, 3, 1);
        BOOST_TEST(!spare.sample(160, 40, false, 0));
        BOOST_TEST(!spare.reference(20, 0, 1, 0));
        BOOST_TEST(spare.outcome(20, 0).outside_aperture == 1);
        BOOST_TEST(spare.outcome(45, 1).lens.i == 1);
        BOOST_TEST(spare.outcome(45, 1).lens.j == 2);
    }
}

BOOST_AUTO_TEST_CASE(samples_are_well_distributed)
{
    const QuiltSampler sampler = quilt_of(Arrangement::lenticular);
    // Where a sample lies in its pixel, in sixteenths, as one number.
    const auto place = [&](int x, int y, unsigned index) {
        const Vec2 from_middle{
            sampler.sample(x, y, false, index)->point.x - sampler.ray({x + 0.5, y + 0.5})->point.x,
            sampler.sample(x, y, false, index)->point.y - sampler.ray({x + 0.5, y + 0.5})->point.y};
        const Vec2 pixel = sampler.geometry().pixel;
        const auto of_four = [](double part) { return int(std::floor(4 * (part + 0.5))); };
        return 4 * of_four(from_middle.y / pixel.y) + of_four(from_middle.x / pixel.x);
    };
    std::set<int> of_pixel, of_square;
    for (unsigned index = 0; index < 16; ++index)
        of_pixel.insert(place(50, 40, index));
    // 4 x 4 pixels of a tile, from its lower left corner.
    for (int k = 0; k < 16; ++k)
        of_square.insert(place(40 + k % 4, 59 - k / 4, 0));
    BOOST_TEST(of_pixel.size() == 16u);
    BOOST_TEST(of_square.size() == 16u);
}

BOOST_AUTO_TEST_CASE(places_are_found_in_other_views)
{
    // The pixel of each other view in which the same place is seen, by projecting the place.
    std::mt19937 random(1);
    for (const auto& one : sheets) {
        const QuiltSampler sampler = quilt_of(one.arrangement, one.slant);
        const QuiltGeometry geometry = sampler.geometry();
        const ViewReuse reuse(geometry);
        ReuseNeighbourhood::Scratch scratch;
        int places = 0;
        for (int k = 0; k < 60; ++k) {
            const int x = int(random() % 160), y = int(random() % 90);
            const double depth = -150 + double(random() % 500);
            const BeamRay own = *sampler.ray({x + 0.5, y + 0.5});
            const Vec2 place = place_at(own, depth);
            reuse.find(x, y, *sampler.tile(x, y), {float(depth)}, scratch);
            std::set<std::ptrdiff_t> found;
            for (const auto& eight : scratch)
                for (int i = 0; i < 8; ++i)
                    if (eight.which >> i & 1)
                        BOOST_TEST(found.insert(eight.index + i).second);
            for (const std::ptrdiff_t index : found) // each is about the place
            {
                const int i = int(index % 160), j = int(index / 160);
                const Vec2 seen = place_at(*sampler.ray({i + 0.5, j + 0.5}), depth),
                           apart = seen - place;
                const double widened = 1 + depth / geometry.distance;
                BOOST_TEST(std::fabs(apart.x) < 1.001 * widened * geometry.pixel.x);
                BOOST_TEST(std::fabs(apart.y) < 1.001 * widened * geometry.pixel.y);
                BOOST_TEST((sampler.tile(i, j)->i != sampler.tile(x, y)->i ||
                            sampler.tile(i, j)->j != sampler.tile(x, y)->j));
            }
            // In the next view on the right, the pixel that contains the place is found.
            const auto tile = *sampler.tile(x, y);
            if (tile.i + 1 >= geometry.tiles.columns)
                continue;
            for (int i = x / 40 * 40 + 40; i < x / 40 * 40 + 80; ++i)
                for (int j = y / 30 * 30; j < y / 30 * 30 + 30; ++j) {
                    const Vec2 apart = place_at(*sampler.ray({i + 0.5, j + 0.5}), depth) - place;
                    const double widened = 1 + depth / geometry.distance;
                    if (std::fabs(apart.x) < 0.499 * widened * geometry.pixel.x &&
                        std::fabs(apart.y) < 0.499 * widened * geometry.pixel.y) {
                        BOOST_TEST(found.count(std::ptrdiff_t(j) * 160 + i) == 1u);
                        ++places;
                    }
                }
        }
        BOOST_TEST(places > 10);
    }
}

BOOST_AUTO_TEST_CASE(fine_texture_of_quilts_becomes_clear, *boost::unit_test::label("many_pixels"))
{
    // Squares little wider than a pixel: only other views' samples help.
    for (const auto& one : sheets)
        for (const double depth : {-60.0, -6.0, 0.0, 8.0, 100.0}) {
            const double side = 1.5 * 2 * (1 + depth / 300);
            const double found = ratio_of(one.arrangement, one.slant, chequers(depth, side, 0.3));
            BOOST_TEST(found < 0.55, int(one.arrangement) << " turned by " << one.slant
                                                          << ", depth " << depth << ": " << found);
        }
}

BOOST_AUTO_TEST_CASE(the_sky_of_quilts_becomes_clear)
{
    // Squares of directions, as of a sky that is infinitely far away. The eyes are so near each
    // other that it moves by a pixel or a few from view to view.
    const Scene sky = [](const BeamRay& ray) {
        const auto square = [&](double slope) { return int(std::floor(slope / 0.008)) & 1; };
        const Vec2 slope = (1 / ray.direction.z) * Vec2{ray.direction.x, ray.direction.y};
        return Look{square(slope.x) == square(slope.y) ? 0.7 : 0.1, HUGE_VAL};
    };
    for (const auto& one : sheets) {
        const double found = ratio_of(one.arrangement, one.slant, sky, Vec2{24, 24});
        BOOST_TEST(found < 0.6, int(one.arrangement) << ": " << found);
    }
}

BOOST_AUTO_TEST_CASE(far_views_are_not_used)
{
    // A row of 40 views: eight on either side are used, of a place at the sheet a pixel of each.
    CameraParameters p = sheet(Arrangement::lenticular);
    const QuiltSampler sampler(camera_of(p, 400, 10), {40, 1}, 400, 10);
    const ViewReuse reuse(sampler.geometry());
    ReuseNeighbourhood::Scratch scratch;
    reuse.find(205, 5, *sampler.tile(205, 5), {0}, scratch);
    std::set<std::ptrdiff_t> found;
    for (const auto& eight : scratch)
        for (int i = 0; i < 8; ++i)
            if (eight.which >> i & 1)
                found.insert(eight.index + i - 5 * 400);
    BOOST_TEST(found.size() == 16u);
    BOOST_TEST(*found.begin() == 125);
    BOOST_TEST(*found.rbegin() == 285);
    // The furthest depth is like infinity: places eight views away are there to 1/100 of a pixel.
    const QuiltGeometry geometry = sampler.geometry();
    BOOST_TEST(8 * geometry.by_column.x / geometry.pixel.x * geometry.distance <
               0.01 * reuse.footprint().furthest_depth());
}

BOOST_AUTO_TEST_CASE(outlines_of_quilts_stay)
{
    // A dark edge before bright squares: an outline that lies elsewhere in each view.
    const Scene behind = chequers(80, 7);
    const Scene scene = [&](const BeamRay& ray) {
        const Vec2 place = place_at(ray, -20);
        return place.x + 0.3 * place.y < 3 ? Look{0.02, -20} : behind(ray);
    };
    for (const auto& one : sheets) {
        const double found = ratio_of(one.arrangement, one.slant, scene);
        BOOST_TEST(found < 0.75, int(one.arrangement) << ": " << found);
    }
}

BOOST_AUTO_TEST_CASE(passes_of_quilts_reach_other_tiles)
{
    const QuiltGeometry geometry = quilt_of(Arrangement::lenticular).geometry();
    // Eight steps between 12 views in rows of 4 are two rows of tiles of 30 pixels.
    BOOST_TEST(ViewReuse(geometry).rows() == 60);
    BOOST_TEST(PassRows(geometry, 16, true).estimated_from() == 60);
    BOOST_TEST(PassRows(geometry, 16, false).estimated_from() == 0);
    BOOST_TEST(PassRows(geometry, 16, false).refine_margin() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
