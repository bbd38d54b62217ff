// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that pixels mapped in runs equal pixels mapped one by one, bit for bit, and so do rays
// through given lenses; and that the mapping `automatic`, which takes short cuts, agrees with its
// definition.
#include "integral/optics/pixel_run.h"
#include "integral/sampling/pixel_sampler.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <string>

using namespace integral;

namespace {

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same(Vec2 a, Vec2 b) { return same(a.x, b.x) && same(a.y, b.y); }
bool same(Vec3 a, Vec3 b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

struct Found {
    long imaged = 0, searched = 0, not_imaged = 0;
};

/// Compares the runs that begin at every pixel of a frame with one_ray and sight_line.
Found compare(const CameraParameters& parameters, const ViewFrame& view, int width, int height,
              const std::string& what)
{
    const IntegralCamera camera = make_camera(parameters, view, width, height);
    const PixelSampler sampler(camera, 1);
    Found found;
    BOOST_REQUIRE_MESSAGE(sampler.gives_one_ray(), what);
    PixelRun run;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; x += run_length - 1) {
            map_pixel_run(camera, {x + 0.5, y + 0.5}, run);
            for (int k = 0; k < run_length; ++k) {
                const std::string pixel = what + ": pixel " + std::to_string(x + k) + ", " +
                                          std::to_string(y);
                PixelOutcome one;
                const auto ray = sampler.one_ray({x + k + 0.5, y + 0.5}, one);
                const PixelOutcome outcome = outcome_of(run.mapped[k]);
                found.imaged += one.imaged;
                found.searched += one.searched;
                found.not_imaged += one.outside_aperture + one.total_reflection;
                BOOST_REQUIRE_MESSAGE(outcome.imaged == one.imaged &&
                                          outcome.searched == one.searched &&
                                          outcome.outside_aperture == one.outside_aperture &&
                                          outcome.total_reflection == one.total_reflection,
                                      pixel << " has another outcome");
                if (!ray)
                    continue;
                const SightLine line = sight_line(camera, *ray);
                BOOST_REQUIRE_MESSAGE(outcome.lens == one.lens, pixel << " has another lens");
                BOOST_REQUIRE_MESSAGE(same(line.origin, run.lines[k].origin) &&
                                          same(line.direction, run.lines[k].direction) &&
                                          same(line.length, run.lines[k].length),
                                      pixel << " has another line");
            }
        }
    return found;
}

/// Compares rays_through and beam_rays with ray_through and beam_ray, for pixels of a frame and
/// random points of lenses nearby. Returns how many got light through and how many did not.
Found compare_through_lenses(const IntegralCamera& camera, std::mt19937& random)
{
    Found found;
    const auto even = [&](double most) {
        return std::uniform_real_distribution<double>(-most, most)(random);
    };
    const Lattice& lattice = camera.optics.lattice();
    const double aside = 2.5 * lattice.pitch(), radius = 0.6 * lattice.pitch(),
                 height = camera.slit_height({0, 0});
    for (int y = 0; y < camera.film.height; ++y)
        for (int x = 0; x < camera.film.width; x += run_length) {
            RayRun<Vec2> film_points;
            RayRun<LensPoint> points;
            const int number = 1 + (x / run_length + y) % run_length;
            for (int k = 0; k < number; ++k) {
                film_points[k] = film_from_pixel(camera.film, {x + k + 0.5, y + 0.5});
                points[k] = {even(radius) * lattice.across(), even(height)};
                if (lattice.arrangement() != Arrangement::lenticular)
                    points[k] = {points[k].offset + even(radius) * lattice.along()};
            }
            const LensIndex lens = lattice.nearest(film_points[0] + Vec2{even(aside), even(aside)});
            RayRun<std::optional<LensRay>> rays;
            RayRun<std::optional<BeamRay>> beams;
            camera.optics.rays_through(number, film_points, lens, rays);
            beam_rays(camera.optics, number, film_points, lens, points, beams);
            for (int k = 0; k < number; ++k) {
                const auto ray = camera.optics.ray_through(film_points[k], lens);
                const auto beam = beam_ray(camera.optics, film_points[k], lens, points[k]);
                BOOST_REQUIRE(ray.has_value() == rays[k].has_value());
                BOOST_REQUIRE(beam.has_value() == beams[k].has_value());
                (ray && beam ? found.imaged : found.not_imaged) += 1;
                if (ray)
                    BOOST_REQUIRE(ray->lens == rays[k]->lens &&
                                  same(ray->direction, rays[k]->direction) &&
                                  same(ray->pole, rays[k]->pole) &&
                                  same(ray->aperture_point, rays[k]->aperture_point));
                if (beam)
                    BOOST_REQUIRE(same(beam->direction, beams[k]->direction) &&
                                  same(beam->point, beams[k]->point) &&
                                  same(beam->aperture_point, beams[k]->aperture_point));
            }
        }
    return found;
}

/// Maps by the definition of `automatic`: closest, and accurate only where the check of closest
/// fails. Compares the results with map's, bit for bit.
void compare_with_definition(const CameraParameters& parameters, const ViewFrame& view, int width,
                             int height, const std::string& what)
{
    const IntegralCamera camera = make_camera(parameters, view, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec2 film_point = film_from_pixel(camera.film, {x + 0.5, y + 0.5});
            const MappedPoint closest = camera.optics.map(film_point, LensMapping::closest);
            MappedPoint expected = camera.optics.map(film_point, LensMapping::accurate);
            if (!expected.ray)
                expected.empty = closest.empty;
            if (closest.ray)
                expected = closest;
            const MappedPoint mapped = camera.optics.map(film_point, LensMapping::automatic);
            const std::string pixel = what + ": pixel " + std::to_string(x) + ", " +
                                      std::to_string(y);
            BOOST_REQUIRE_MESSAGE(mapped.ray.has_value() == expected.ray.has_value() &&
                                      mapped.empty == expected.empty &&
                                      mapped.searched == expected.searched,
                                  pixel << " is mapped otherwise");
            if (mapped.ray)
                BOOST_REQUIRE_MESSAGE(
                    mapped.ray->lens == expected.ray->lens &&
                        same(mapped.ray->direction, expected.ray->direction) &&
                        same(mapped.ray->aperture_point.x, expected.ray->aperture_point.x) &&
                        same(mapped.ray->aperture_point.y, expected.ray->aperture_point.y),
                    pixel << " has another ray");
        }
}

ViewFrame view_of(int width, int height, double pitch, double distance)
{
    return {
        {0.3, 2, -distance}, {0, 0, distance}, {width * pitch, 0, 0}, {0, height * pitch, 0}, 1};
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_pixel_run)

BOOST_AUTO_TEST_CASE(a_run_is_its_pixels)
{
    constexpr int width = 150, height = 100;
    constexpr double pitch = mm_per_inch / 300;
    for (const auto arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 9.46, -30.0, 45.0, 60.0, -89.0, 90.0})
            for (const bool limited : {false, true}) {
                CameraParameters parameters;
                const bool lenticular = arrangement == Arrangement::lenticular;
                parameters.sheet = {arrangement,
                                    lenticular ? 1.27 : 1.124,
                                    lenticular ? 3.08 : 3.23,
                                    lenticular ? 1.6 : 1.675,
                                    slant,
                                    {0.1, -0.2}};
                if (limited)
                    parameters.depth_range = Vec2{40, 90};
                parameters.mapping = limited ? LensMapping::closest : LensMapping::automatic;
                const std::string what = std::to_string(int(arrangement)) + ", " +
                                         std::to_string(slant) +
                                         (limited ? " degrees, limited" : " degrees");
                compare(parameters, view_of(width, height, pitch, 350), width, height, what);
            }
}

BOOST_AUTO_TEST_CASE(searched_for)
{
    // A sheet as wide as its distance from the eye. Near its sides, many pixels are imaged by
    // another lens than the nearest.
    constexpr int width = 240, height = 40;
    constexpr double pitch = 10 * mm_per_inch / 300;
    for (const auto arrangement : {Arrangement::lenticular, Arrangement::square})
        for (const double slant : {0.0, 9.46, 45.0})
            for (const auto mapping : {LensMapping::closest, LensMapping::automatic}) {
                CameraParameters parameters;
                parameters.sheet = {arrangement, 1.27, 3.08, 1.6, slant, {0.1, -0.2}};
                parameters.film.pixel_pitch = {pitch, pitch};
                parameters.mapping = mapping;
                // The size that fills a lens without slant. The default aperture of a slanted sheet
                // is wider, and with it the nearest lens images nearly every pixel.
                const double filling = *filling_width(parameters.sheet, 200,
                                                      parameters.sheet.pitch);
                if (arrangement == Arrangement::square)
                    parameters.capture_aperture = Vec2{filling, filling};
                const std::string what = std::to_string(int(arrangement)) + ", " +
                                         std::to_string(slant) + " degrees";
                const Found found = compare(parameters, view_of(width, height, pitch, 200), width,
                                            height, what);
                if (mapping == LensMapping::closest)
                    BOOST_TEST(found.searched == 0);
                else {
                    BOOST_TEST(found.searched >= 0.09 * found.imaged, what << ": " << found.searched
                                                                           << " searched for, of "
                                                                           << found.imaged);
                    compare_with_definition(parameters, view_of(width, height, pitch, 200), width,
                                            height, what);
                }
            }
}

BOOST_AUTO_TEST_CASE(any_camera)
{
    // Thin and thick sheets, near and far eyes, coarse and fine films, wide and narrow apertures,
    // skewed views.
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
    };
    const auto even = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    long imaged = 0, not_imaged = 0, cameras = 0;
    for (int trial = 0; trial < 400; ++trial) {
        CameraParameters parameters;
        const double pitch = between(0.05, 20);
        parameters.sheet = {trial & 1 ? Arrangement::lenticular : Arrangement::square,
                            pitch,
                            pitch * between(0.5, 8),
                            even(1.01, 2.5),
                            even(-89, 89),
                            {even(-pitch, pitch), even(-pitch, pitch)}};
        const double pixel = pitch / between(2, 40), distance = pitch * between(3, 3000);
        parameters.film.pixel_pitch = {pixel, pixel * between(0.5, 2)};
        parameters.capture_aperture = Vec2{distance * between(0.01, 3),
                                           distance * between(0.01, 3)};
        parameters.beam_samples = 1; // a slit that has a height, too
        if (trial % 3 == 0)
            parameters.depth_range = Vec2{distance * even(0, 1.5), distance * even(0, 3)};
        constexpr int width = 60, height = 20;
        ViewFrame view = view_of(width, height, pixel, distance);
        const double turn = even(-3, 3);
        view.direction = {distance * std::sin(turn), 0, distance * std::cos(turn)};
        view.right = {width * pixel * std::cos(turn), 0, -width * pixel * std::sin(turn)};
        Found found;
        try {
            found = compare(parameters, view, width, height, "camera " + std::to_string(trial));
            compare_with_definition(parameters, view, width, height,
                                    "camera " + std::to_string(trial));
        } catch (const std::invalid_argument&) { // this combination is not a valid camera
            continue;
        }
        imaged += found.imaged;
        not_imaged += found.not_imaged;
        ++cameras;
    }
    BOOST_TEST(cameras > 200);
    BOOST_TEST(imaged > 10000);
    BOOST_TEST(not_imaged > 10000);
    BOOST_TEST_MESSAGE(imaged << " pixels imaged and " << not_imaged << " not, of " << cameras
                              << " cameras");
}

BOOST_AUTO_TEST_CASE(runs_through_given_lenses)
{
    // The lenses are so far away that some light is totally reflected.
    std::mt19937 random(11);
    for (const auto arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const LensModel model :
             {LensModel::pinhole, LensModel::extended_pinhole, LensModel::full})
            for (const double slant : {0.0, 9.46, -60.0}) {
                CameraParameters parameters;
                parameters.sheet = {arrangement, 1.27, 3.08, 1.6, slant, {0.1, -0.2}};
                parameters.model = model;
                parameters.capture_aperture = Vec2{100, 100};
                const IntegralCamera camera = make_camera(
                    parameters, view_of(150, 60, mm_per_inch / 300, 350), 150, 60);
                if (arrangement == Arrangement::lenticular)
                    BOOST_TEST_REQUIRE(camera.slit_height({0, 0}) > 50);
                const Found found = compare_through_lenses(camera, random);
                BOOST_TEST(found.imaged > 1000);
                BOOST_TEST((found.not_imaged > 300) == (model != LensModel::pinhole));
            }
}

BOOST_AUTO_TEST_SUITE_END()
