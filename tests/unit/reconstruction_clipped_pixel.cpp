// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which part of a pixel at a lens's border counts, against many points of each pixel.
#include "integral/reconstruction/clipped_pixel.h"
#include "tests/unit/sampled_frame.h"

#include <boost/test/unit_test.hpp>

using namespace sampled_frame;

namespace {

/// The part of a pixel behind the lens of its centre, and the mean place of that part: pixels from
/// the centre, right and down.
struct Part {
    double size = 0;
    Vec2 middle{};
};

Part part_by_many_points(const IntegralCamera& camera, Vec2 centre, LensIndex own)
{
    constexpr int side = 48;
    Part part;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const Vec2 place{(i + 0.5) / side - 0.5, (j + 0.5) / side - 0.5};
            const auto ray = camera.optics
                                 .map(film_from_pixel(camera.film, centre + place), camera.mapping)
                                 .ray;
            if (!ray || !(ray->lens == own))
                continue;
            part.size += 1;
            part.middle = part.middle + place;
        }
    part.middle = (1 / part.size) * part.middle;
    part.size /= side * side;
    return part;
}

} // namespace

BOOST_AUTO_TEST_SUITE(reconstruction_clipped_pixel)

BOOST_AUTO_TEST_CASE(the_part_behind_the_own_lens_is_found)
{
    // RMS errors, in pixels, of the rays and sizes of pixels at borders, divided by the errors if
    // every pixel counted as whole. Leaning borders are treated as upright ones.
    const struct {
        Arrangement arrangement;
        double slant, most;
    } sheets[] = {{Arrangement::square, 0, 0.25},
                  {Arrangement::lenticular, 0, 0.25},
                  {Arrangement::hexagonal, 0, 0.5},
                  {Arrangement::lenticular, 15, 0.2}};
    for (const auto& one : sheets) {
        const Sampled frame(sheet(one.arrangement, one.slant), chequers(5, 2), 1);
        const IntegralCamera& camera = frame.camera;
        double lines[2] = {}, sizes[2] = {}; // with the part; with the whole pixel
        for (int y = 1; y + 1 < height; ++y)
            for (int x = 1; x + 1 < width; ++x) {
                const Vec2 centre{x + 0.5, y + 0.5};
                const auto pole = camera.optics
                                      .map(film_from_pixel(camera.film, centre), camera.mapping)
                                      .ray;
                if (!pole || frame.first.lens_around(x, y))
                    continue;
                const auto line_at = [&](Vec2 place) {
                    return light_field_ray(
                        camera.optics.lattice(),
                        pole_beam(*camera.optics.ray_through(
                            film_from_pixel(camera.film, centre + place), pole->lens)));
                };
                const Part part = part_by_many_points(camera, centre, pole->lens);
                const LightFieldRay right = line_at(part.middle), whole = line_at({0, 0}),
                                    next = line_at({1, 0});
                const double pixel = std::hypot(next.slope[0] - whole.slope[0],
                                                next.slope[1] - whole.slope[1]);
                const auto cut = cut_pixel(camera, frame.first, x, y);
                const auto add = [&](int which, const LightFieldRay& line, double size) {
                    for (int k = 0; k < 2; ++k)
                        lines[which] += std::pow((line.slope[k] - right.slope[k]) / pixel, 2);
                    sizes[which] += std::pow(size - part.size, 2);
                };
                add(0, cut ? cut->centre : whole, cut ? cut->size.x * cut->size.y : 1);
                add(1, whole, 1);
            }
        const double of_lines = std::sqrt(lines[0] / lines[1]),
                     of_sizes = std::sqrt(sizes[0] / sizes[1]);
        BOOST_TEST(of_lines < one.most, int(one.arrangement)
                                            << " turned by " << one.slant << ": " << of_lines);
        BOOST_TEST(of_sizes < one.most, int(one.arrangement)
                                            << " turned by " << one.slant << ": " << of_sizes);
    }
}

BOOST_AUTO_TEST_CASE(pixels_at_borders_are_as_clear_as_others)
{
    // Waves far from the sheet, about four pixels long, so that half a pixel matters. The error of
    // pixels at borders, divided by the others' error, would be 3.8 if they counted as whole ones.
    const Scene waves = [&](const BeamRay& ray) {
        const Vec2 place = place_at(ray, 60);
        const auto wave = [&](double x) { return std::sin(x * 0.6); };
        return Look{0.5 + 0.2 * (wave(place.x) + wave(place.y)), 60};
    };
    const CameraParameters parameters = sheet(Arrangement::square);
    double sums[2] = {};
    int numbers[2] = {};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Sampled frame(parameters, waves, 4, 0.0005, seed);
        const auto pixels = frame.pixels();
        for (int y = 14; y < height - 14; ++y)
            for (int x = 14; x < width - 14; ++x) {
                const auto& light = pixels[Sampled::at(x, y)];
                if (!light)
                    continue;
                double truth = 0;
                const auto rays = random_rays_at(frame.sampler, {x + 0.5, y + 0.5}, 400);
                for (const PixelRay& ray : rays)
                    truth += waves(ray.ray).grey / double(rays.size());
                const bool cut = cut_pixel(frame.camera, frame.first, x, y).has_value();
                sums[cut] += std::pow((*light)[1] - truth, 2);
                ++numbers[cut];
            }
    }
    BOOST_TEST_REQUIRE(numbers[1] > 100);
    const double found = std::sqrt(sums[1] / numbers[1] / (sums[0] / numbers[0]));
    BOOST_TEST(found < 1.6, found);
}

BOOST_AUTO_TEST_SUITE_END()
