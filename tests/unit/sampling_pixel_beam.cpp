// SPDX-License-Identifier: AGPL-3.0-or-later
// The samples that anti-aliasing takes of a pixel's beam: they belong to the pixel's lens and are
// well distributed over the pixel, the lens's cell, and what the beam covers at a depth.
#include "integral/optics/pixel_run.h"
#include "integral/reconstruction/light_field_image.h"
#include "tests/unit/optics_sheets.h"
#include "tests/unit/pixel_origins.h"

#include <algorithm>
#include <limits>
#include <map>

using namespace pixel_origins;

BOOST_AUTO_TEST_SUITE(sampling_pixel_beam)

BOOST_AUTO_TEST_CASE(anti_aliasing_s_samples_are_the_pixel_s_lens_s)
{
    for (const Arrangement arrangement : arrangements)
        for (const Subpixels subpixels : {Subpixels::none, Subpixels::rgb}) {
            CameraParameters p = parameters_of(arrangement);
            p.film.subpixels = subpixels;
            const IntegralCamera camera = camera_of(p, 70, 50);
            const PixelSampler sampler(camera, 1);
            int whole_ones = 0, divided_ones = 0;
            for_each_pixel(camera, false, [&](Vec2 centre) {
                const PixelBeam beam = sampler.beam(centre, false, 20);
                std::array<int, 3> taken{};
                for (std::uint32_t index = 0; index < 16; ++index) {
                    std::vector<PixelRay> rays;
                    sampler.append_sample(beam, index, rays);
                    for (const PixelRay& ray : rays) {
                        const int channel = std::max(ray.channel, 0);
                        const Vec2 at = centre + subpixel_shift(subpixels, centre, channel);
                        const LensIndex lens = lens_at(camera, at);
                        const Origin origin = origin_of(camera, at, ray.ray, lens);
                        ++taken[channel];
                        BOOST_TEST(std::fabs(origin.film.x) <=
                                   (subpixels == Subpixels::none ? 0.5 : 1 / 6.0) + 1e-9);
                        BOOST_TEST(std::fabs(origin.film.y) <= 0.5 + 1e-9);
                        const auto mapped = camera.optics
                                                .map(film_from_pixel(camera.film, at + origin.film),
                                                     camera.mapping)
                                                .ray;
                        BOOST_TEST((mapped && mapped->lens == lens));
                    }
                }
                int imaged = 0; // channels
                for (int channel = 0; channel < (subpixels == Subpixels::none ? 1 : 3); ++channel) {
                    const Vec2 at = centre + subpixel_shift(subpixels, centre, channel);
                    imaged += camera.optics.map(film_from_pixel(camera.film, at), camera.mapping)
                                  .ray.has_value();
                }
                BOOST_TEST(beam.number == imaged);
                for (int k = 0; k < beam.number; ++k) {
                    const int count = taken[std::max(beam.channels[k].channel, 0)];
                    (beam.channels[k].whole ? whole_ones : divided_ones) += 1;
                    if (beam.channels[k].whole)
                        BOOST_TEST(count == 16);
                    else
                        BOOST_TEST(count < 17);
                }
            });
            BOOST_TEST(whole_ones > 1000);
            BOOST_TEST(divided_ones > 200);
        }
}

BOOST_AUTO_TEST_CASE(anti_aliasing_s_samples_are_spread_over_pixel_or_cell)
{
    for (const Arrangement arrangement : arrangements) {
        const IntegralCamera camera = camera_of(parameters_of(arrangement));
        const PixelSampler sampler(camera, 7);
        int pixels = 0;
        for_each_pixel(camera, true, [&](Vec2 centre) {
            if (++pixels % 97)
                return;
            // Among the first 4^k points, each of the 4^k equal parts of a coordinate has one
            // point. At the sheet these are the cell's coordinates, far away the pixel's. A
            // hexagonal cell has no such coordinates; there, only the pixel's are checked.
            for (const bool far : {false, true})
                for (const int count : {4, 16, 64}) {
                    if (!far && arrangement == Arrangement::hexagonal)
                        continue;
                    std::vector<PixelRay> rays;
                    const PixelBeam beam = sampler.beam(
                        centre, false, far ? std::numeric_limits<double>::infinity() : 0);
                    for (int index = 0; index < count; ++index)
                        sampler.append_sample(beam, index, rays);
                    BOOST_REQUIRE(int(rays.size()) == count);
                    std::vector<int> dimensions = far ? std::vector{0, 1} : std::vector{2, 3};
                    if (arrangement == Arrangement::lenticular && !far)
                        dimensions = {1, 2}; // along the cylinder, only the pixel's
                    for (const int dimension : dimensions) {
                        std::vector<int> parts(count);
                        for (const Origin& at : origins(camera, centre, rays))
                            ++parts[std::min(count - 1,
                                             std::max(0, int(unit_of(at)[dimension] * count)))];
                        // "Far" is a million pitches, where the place on the cell still moves what
                        // is seen by 1e-5 of a pixel: enough to carry a sample over a part's edge.
                        BOOST_TEST(*std::max_element(parts.begin(), parts.end()) <= 2);
                        BOOST_TEST(std::count(parts.begin(), parts.end(), 1) >= count - 4);
                    }
                }
        });
        BOOST_TEST(pixels > 97);
        const auto first = [&](Vec2 centre, bool alike, const PixelSampler& by) {
            std::vector<PixelRay> rays;
            by.append_sample(by.beam(centre, alike, 0), 0, rays); // at the sheet: equal shares
            return origin_of(camera, centre, rays.at(0).ray, lens_at(camera, centre));
        };
        std::vector<Vec2> whole_ones;
        for_each_pixel(camera, true, [&](Vec2 centre) { whole_ones.push_back(centre); });
        const Vec2 here = whole_ones.at(100), there = whole_ones.at(101);
        BOOST_TEST(first(here, false, sampler).film.x ==
                   first(here, false, PixelSampler(camera, 7)).film.x);
        BOOST_TEST(std::fabs(first(here, false, sampler).film.x -
                             first(here, false, PixelSampler(camera, 8)).film.x) > 1e-6);
        BOOST_TEST(std::fabs(first(here, false, sampler).film.x -
                             first(there, false, sampler).film.x) > 1e-6);
        BOOST_TEST(std::fabs(first(here, true, sampler).film.x -
                             first(there, true, sampler).film.x) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(the_first_sample_is_sample_0_at_any_depth)
{
    // So it is one of the samples that are spread over what the beam covers, although it is taken
    // before the depth is known.
    for (const Arrangement arrangement : arrangements)
        for (const double slant : {0.0, 80.0})
            for (const double tall : {0.0, 100.0}) {
                CameraParameters p = parameters_of(arrangement);
                p.sheet.slant = slant;
                if (tall > 0)
                    p.capture_aperture = Vec2{100, tall};
                const IntegralCamera camera = camera_of(p, 60, 40);
                const PixelSampler sampler(camera, 5);
                for (const double depth :
                     {0.0, -7.0, 20.0, 1e4, std::numeric_limits<double>::infinity()})
                    for_each_pixel(camera, true, [&](Vec2 centre) {
                        const auto pole = camera.optics.map(film_from_pixel(camera.film, centre),
                                                            camera.mapping);
                        const BeamRay first = sampler.first_sample(centre, *pole.ray, false);
                        std::vector<PixelRay> rays;
                        sampler.append_sample(sampler.beam(centre, false, depth), 0, rays);
                        const Vec3 apart = rays.at(0).ray.point - first.point,
                                   turned = rays.at(0).ray.direction - first.direction;
                        BOOST_TEST_REQUIRE(std::sqrt(dot(apart, apart)) < 1e-4);
                        BOOST_TEST_REQUIRE(std::sqrt(dot(turned, turned)) < 1e-4);
                    });
            }
}

BOOST_AUTO_TEST_CASE(first_samples_are_the_same_in_runs)
{
    for (const Arrangement arrangement : arrangements)
        for (const bool alike : {false, true}) {
            const IntegralCamera camera = camera_of(parameters_of(arrangement), 60, 40);
            const PixelSampler sampler(camera, 5);
            int number = 0;
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 60; x += run_length) {
                    PixelRun run;
                    RayRun<BeamRay> samples;
                    map_pixel_run(camera, {x + 0.5, y + 0.5}, run);
                    sampler.first_samples({x + 0.5, y + 0.5}, run.mapped, alike, samples);
                    for (int k = 0; k < run_length; ++k) {
                        const auto& pole = run.mapped[k].ray;
                        if (!pole)
                            continue;
                        const BeamRay one = sampler.first_sample({x + k + 0.5, y + 0.5}, *pole,
                                                                 alike);
                        const Vec3 apart = one.point - samples[k].point,
                                   turned = one.direction - samples[k].direction;
                        BOOST_TEST_REQUIRE(dot(apart, apart) + dot(turned, turned) == 0);
                        ++number;
                    }
                }
            BOOST_TEST(number > 800);
        }
}

BOOST_AUTO_TEST_CASE(samples_are_the_same_in_runs)
{
    enum Kind { plain, tall_slit, full_model, pseudoscopic, prefiltered, subpixels };
    for (const Arrangement arrangement : arrangements)
        for (const Kind kind :
             {plain, tall_slit, full_model, pseudoscopic, prefiltered, Kind::subpixels}) {
            CameraParameters parameters = parameters_of(arrangement);
            if (kind == tall_slit)
                parameters.capture_aperture = Vec2{100, 100};
            if (kind == full_model)
                parameters.model = LensModel::full;
            parameters.pseudoscopic = kind == pseudoscopic;
            parameters.display_prefilter = kind == prefiltered;
            if (kind == Kind::subpixels)
                parameters.film.subpixels = Subpixels::rgb;
            const IntegralCamera camera = camera_of(parameters, 60, 40);
            const PixelSampler sampler(camera, 5);
            int taken = 0, left_out = 0;
            for_each_pixel(camera, false, [&](Vec2 centre) {
                const PixelBeam beam = sampler.beam(centre, false, 20);
                const int number = 1 + int(centre.x) % run_length;
                const std::uint32_t begin = std::uint32_t(centre.y) % 5;
                std::array<RayRun<std::optional<BeamRay>>, 3> runs;
                for (int channel = 0; channel < beam.number; ++channel)
                    sampler.samples(beam.channels[channel], begin, number, runs[channel]);
                for (int k = 0; k < number; ++k) {
                    std::vector<PixelRay> singles;
                    sampler.append_sample(beam, begin + std::uint32_t(k), singles);
                    std::size_t next = 0;
                    for (int channel = 0; channel < beam.number; ++channel) {
                        const auto& from_run = runs[channel][k];
                        const bool single = next < singles.size() &&
                                            singles[next].channel == beam.channels[channel].channel;
                        BOOST_TEST_REQUIRE(from_run.has_value() == single);
                        (single ? taken : left_out) += 1;
                        if (!single)
                            continue;
                        const BeamRay& one = singles[next++].ray;
                        const Vec3 apart = one.point - from_run->point,
                                   turned = one.direction - from_run->direction;
                        const Vec2 beside = one.aperture_point - from_run->aperture_point;
                        BOOST_TEST_REQUIRE(
                            dot(apart, apart) + dot(turned, turned) + dot(beside, beside) == 0);
                    }
                }
            });
            BOOST_TEST(taken > 2000);
            BOOST_TEST((left_out > 100) == (kind != prefiltered));
        }
}

BOOST_AUTO_TEST_CASE(a_beam_is_the_same_where_its_lens_is_known)
{
    for (const Arrangement arrangement : arrangements) {
        const IntegralCamera camera = camera_of(parameters_of(arrangement), 60, 40);
        const PixelSampler sampler(camera, 5);
        LightFieldImage first(camera);
        int imaged = 0, inside = 0;
        for_each_pixel(camera, true, [&](Vec2 centre) {
            const auto pole = camera.optics.map(film_from_pixel(camera.film, centre),
                                                camera.mapping);
            first.set(int(centre.x), int(centre.y), {}, pole.ray->lens, 20);
            ++imaged;
        });
        for_each_pixel(camera, true, [&](Vec2 centre) {
            const auto around = first.lens_around(int(centre.x), int(centre.y));
            if (!around)
                return;
            ++inside;
            for (std::uint32_t index = 0; index < 4; ++index) {
                std::vector<PixelRay> known, searched;
                sampler.append_sample(sampler.beam(centre, false, 20, around), index, known);
                sampler.append_sample(sampler.beam(centre, false, 20), index, searched);
                BOOST_TEST_REQUIRE(searched.size() == 1);
                BOOST_TEST_REQUIRE(known.size() == 1);
                const Vec3 apart = known[0].ray.point - searched[0].ray.point,
                           turned = known[0].ray.direction - searched[0].ray.direction;
                BOOST_TEST_REQUIRE(dot(apart, apart) + dot(turned, turned) == 0);
            }
        });
        BOOST_TEST(inside > imaged / 3);
        BOOST_TEST(inside < imaged);
    }
}

BOOST_AUTO_TEST_CASE(first_samples_behind_a_lens_fill_each_other_s_gaps)
{
    // The mean of each coordinate over the pixels behind a lens errs much less than with as many
    // independent samples.
    for (const Arrangement arrangement : {Arrangement::lenticular, Arrangement::square}) {
        const IntegralCamera camera = camera_of(parameters_of(arrangement));
        const PixelSampler sampler(camera, 3);
        struct Sums {
            int number = 0;
            std::array<double, 4> coordinates{};
        };
        std::map<std::pair<std::int64_t, std::int64_t>, Sums> lenses;
        for_each_pixel(camera, true, [&](Vec2 centre) {
            const auto pole = camera.optics.map(film_from_pixel(camera.film, centre),
                                                camera.mapping);
            const LensIndex lens = pole.ray->lens;
            const Origin at = origin_of(camera, centre,
                                        sampler.first_sample(centre, *pole.ray, false), lens);
            // A cylinder is divided into groups of as many rows as there are pixels across.
            Sums& sums = lenses[{
                lens.i, arrangement == Arrangement::square ? lens.j : std::int64_t(centre.y) / 12}];
            ++sums.number;
            for (int k = 0; k < 4; ++k)
                sums.coordinates[k] += unit_of(at)[k] - 0.5;
        });
        for (int k = 0; k < (arrangement == Arrangement::square ? 4 : 3); ++k) {
            double squares = 0, independent = 0;
            for (const auto& lens : lenses) {
                squares += lens.second.coordinates[k] * lens.second.coordinates[k];
                independent += lens.second.number / 12.0;
            }
            BOOST_TEST_MESSAGE("coordinate " << k << ": " << squares / independent);
            BOOST_TEST(squares < 0.5 * independent);
        }
    }
}

/// The mean squared error of the fraction of a pixel's beam on one side of a straight edge at a
/// depth, estimated from 16 samples. The mean is taken over many pixels and edges of all
/// directions; the true fraction is taken from 2048 random rays.
static double error_of_edges(const IntegralCamera& camera, double depth, double aimed_at)
{
    const PixelSampler sampler(camera, 3);
    double squares = 0;
    int pixels = 0, judged = 0;
    for_each_pixel(camera, true, [&](Vec2 centre) {
        if (++pixels % 31)
            return;
        const auto seen = [&](const PixelRay& ray) {
            const BeamRay& at = ray.ray;
            const double way = (depth - at.point.z) / at.direction.z;
            return Vec2{at.point.x + way * at.direction.x, at.point.y + way * at.direction.y};
        };
        std::vector<PixelRay> truth, samples;
        for (int index = 0; index < 2048; ++index)
            sampler.append_reference_ray(centre, index, 0, truth);
        const PixelBeam beam = sampler.beam(centre, false, aimed_at);
        for (int index = 0; index < 16; ++index)
            sampler.append_sample(beam, index, samples);
        const Vec2 middle = seen(truth[pixels % 64]);
        const Vec2 direction{std::cos(pixels), std::sin(pixels)};
        const auto part = [&](const std::vector<PixelRay>& rays) {
            double within = 0;
            for (const PixelRay& ray : rays)
                within += dot(seen(ray) - middle, direction) > 0;
            return within / rays.size();
        };
        const double error = part(samples) - part(truth);
        squares += error * error;
        ++judged;
    });
    BOOST_REQUIRE(judged > 100);
    return squares / judged;
}

BOOST_AUTO_TEST_CASE(anti_aliasing_s_samples_are_spread_over_what_the_beam_covers,
                     *boost::unit_test::label("many_pixels"))
{
    struct Case {
        Arrangement arrangement;
        double slant;
        bool mirrored;
        double tall;
    };
    for (const Case c : {Case{Arrangement::lenticular, 0, false, 0},
                         {Arrangement::lenticular, 80, false, 0},
                         {Arrangement::lenticular, 0, false, 100},
                         {Arrangement::square, 0, false, 0},
                         {Arrangement::square, 85, false, 0},
                         {Arrangement::square, 0, true, 0}}) {
        CameraParameters p = parameters_of(c.arrangement);
        p.sheet.slant = c.slant;
        p.pseudoscopic = c.mirrored;
        if (c.tall > 0)
            p.capture_aperture = Vec2{100, c.tall};
        const IntegralCamera camera = camera_of(p, 110, 90);
        // Aiming samples at a depth on the other side of the sheet is the worst aim. With a tall
        // slit the beam covers about as much there; its worst aim is the sheet itself.
        double well = 0, wrongly = 0;
        for (const double depth : {-20.0, 15.0, 60.0}) {
            well += error_of_edges(camera, depth, depth);
            wrongly += error_of_edges(camera, depth, c.tall > 0 ? 0 : -depth);
        }
        BOOST_TEST_MESSAGE("squared error aimed well / wrongly: " << well / wrongly);
        BOOST_TEST(well < (c.tall > 0 ? 0.9 : 0.8) * wrongly);
    }
}

BOOST_AUTO_TEST_SUITE_END()
