// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the reconstruction of anti-aliased frames on scenes in closed form.
#include "integral/reconstruction/pass_rows.h"
#include "integral/reconstruction/reconstruction.h"
#include "integral/reconstruction/sample_fit.h"
#include "integral/sampling/sample_points.h"
#include "tests/unit/sampled_frame.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

using namespace sampled_frame;

BOOST_AUTO_TEST_SUITE(reconstruction_frames)

BOOST_AUTO_TEST_CASE(lines_are_stored)
{
    Sampled frame(sheet(Arrangement::square), chequers(5, 2), 4);
    const Lattice& lattice = frame.camera.optics.lattice();
    double furthest = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const BeamSamples::Pixel& pixel = frame.samples.pixel(x, y);
            if (pixel.number == 0)
                continue;
            const Vec2 centre{x + 0.5, y + 0.5};
            const auto pole = frame.camera.optics
                                  .map(film_from_pixel(frame.camera.film, centre),
                                       frame.camera.mapping)
                                  .ray;
            const LightFieldRay line = light_field_ray(
                lattice, frame.sampler.first_sample(centre, *pole, false));
            const LightFieldRay& stored = pixel.first.line;
            for (int k = 0; k < 2; ++k)
                furthest = std::max({furthest, std::fabs(double(stored.point[k]) - line.point[k]),
                                     20 * std::fabs(double(stored.slope[k]) - line.slope[k])});
        }
    BOOST_TEST(furthest < 0.001);  // mm, at the sheet and 20 mm away
    frame.samples.forget_above(0); // keeps what begins in row 0
    BOOST_TEST(frame.samples.pixel(20, 20).more != nullptr);
}

BOOST_AUTO_TEST_CASE(fine_texture_becomes_clear, *boost::unit_test::label("many_pixels"))
{
    // Squares about as wide as a beam: nothing but other pixels' samples helps.
    const struct {
        Arrangement arrangement;
        double slant, most;
    } sheets[] = {{Arrangement::square, 0, 0.45},      {Arrangement::square, 20, 0.45},
                  {Arrangement::hexagonal, 0, 0.5},    {Arrangement::lenticular, 0, 0.7},
                  {Arrangement::lenticular, 15, 0.75}, {Arrangement::lenticular, -70, 0.85}};
    for (const auto& one : sheets)
        for (double depth : {-25.0, -6.0, 0.0, 8.0, 40.0}) {
            const CameraParameters p = sheet(one.arrangement, one.slant);
            const double slopes = p.sheet.ior * p.film.pixel_pitch.x / p.sheet.thickness,
                         patch = p.sheet.pitch + std::fabs(depth) * slopes,
                         found = ratio(p, chequers(depth, 1.5 * patch), 4);
            BOOST_TEST(found < one.most, int(one.arrangement)
                                             << " turned by " << one.slant << ", depth " << depth
                                             << ": " << found);
        }
}

BOOST_AUTO_TEST_CASE(negative_light_counts)
{
    // Negative light counts as in a pixel's own mean; without it, most pixels would be too bright.
    const Scene squares = chequers(6, 1);
    const Scene scene = [&](const BeamRay& ray) {
        Look look = squares(ray);
        look.grey = look.grey > 0.5 ? 0.5 : -0.6;
        return look;
    };
    BOOST_TEST(ratio(sheet(Arrangement::square), scene, 4) < 0.5);
}

BOOST_AUTO_TEST_CASE(pixels_are_not_darker_than_all_they_show)
{
    // Dark squares next to very bright ones, and squares of negative light.
    const Scene squares = chequers(6, 3);
    const struct {
        double bright, dark, least;
    } all[] = {{40, 0.1, 0.0499}, {0.5, -0.6, -0.901}};
    for (const auto& one : all)
        for (const int number : {1, 4}) {
            const Scene scene = [&](const BeamRay& ray) {
                return Look{squares(ray).grey > 0.5 ? one.bright : one.dark, 6};
            };
            Sampled frame(sheet(Arrangement::square), scene, number);
            const auto pixels = frame.pixels();
            double sum = 0;
            int dark = 0;
            for (int y = 5; y < height - 5; ++y)
                for (int x = 5; x < width - 5; ++x) {
                    const auto& light = pixels[Sampled::at(x, y)];
                    if (!light)
                        continue;
                    BOOST_TEST_REQUIRE((*light)[0] >= one.least, x << ' ' << y);
                    if (std::fabs(frame.truth(scene, x, y) - one.dark) < 1e-3) {
                        sum += (*light)[0];
                        ++dark;
                    }
                }
            BOOST_TEST_REQUIRE(dark > 20);
            BOOST_TEST((one.bright > 1 || std::fabs(sum / dark - one.dark) < 0.03), sum / dark);
        }
}

BOOST_AUTO_TEST_CASE(light_that_cannot_be_stored_tells_nothing_of_noise)
{
    // One pixel is very bright, and the error of its halves is large or not finite: the others are
    // reconstructed as before.
    const Scene scene = chequers(6, 3);
    for (const double halves : {100.0, double(NAN), double(INFINITY)}) {
        Sampled frame(sheet(Arrangement::square), scene, 4);
        const auto before = frame.pixels();
        const int x = 24, y = 21;
        frame.put(x, y, 1000, 1, halves);
        const auto after = frame.pixels();
        double change = 0;
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i)
                if (std::max(std::abs(i - x), std::abs(j - y)) > 4 && before[Sampled::at(i, j)]) {
                    BOOST_TEST_REQUIRE(after[Sampled::at(i, j)].has_value());
                    change = std::fmax(change, std::fabs((*after[Sampled::at(i, j)])[0] -
                                                         (*before[Sampled::at(i, j)])[0]));
                }
        BOOST_TEST(change < 0.002, "halves " << halves << ": " << change);
    }
}

BOOST_AUTO_TEST_CASE(slanted_surfaces_become_clear)
{
    for (double rise : {-1.5, 0.8, 3.0})
        BOOST_TEST(ratio(sheet(Arrangement::square), chequers(4, 2, rise), 4) < 0.6,
                   "rise " << rise);
}

BOOST_AUTO_TEST_CASE(slopes_are_kept)
{
    // The brightness rises evenly, so that samples of a pixel differ only because of their places.
    // At a lens's border all of them lie on one side of the pixel.
    const Scene scene = [&](const BeamRay& ray) {
        const Vec2 place = place_at(ray, 6);
        return Look{0.5 + 0.02 * place.x + 0.01 * place.y, 6};
    };
    BOOST_TEST(ratio(sheet(Arrangement::square), scene, 1) < 0.15);
    BOOST_TEST(ratio(sheet(Arrangement::lenticular), scene, 1) < 0.23);
}

BOOST_AUTO_TEST_CASE(outlines_become_clear)
{
    // A bright plane covers half of a dark one behind it. The samples that reach it lie unevenly.
    // When samples from up to 2.5 steps away were reused (now 2), plain means over them left 0.36
    // of the error on average, and the fit 0.33.
    double sum = 0;
    int number = 0;
    for (double back : {14.0, 60.0, 1e9})
        for (Arrangement arrangement : {Arrangement::square, Arrangement::lenticular}) {
            const Scene scene = [&](const BeamRay& ray) {
                return place_at(ray, 10).x < 1 ? Look{0.8, 10} : Look{0.2, back};
            };
            const double found = ratio(sheet(arrangement), scene, 4);
            BOOST_TEST(found < 0.5, int(arrangement) << ", " << back << " mm: " << found);
            sum += found;
            ++number;
        }
    BOOST_TEST(sum / number < 0.355, sum / number);
}

BOOST_AUTO_TEST_CASE(level_outlines_stay_sharp_behind_leaning_lines)
{
    // A pixel is wide along the slit, not across the lines: far away it shows one height only.
    const Scene horizon = [](const BeamRay& ray) {
        return Look{ray.direction.y / ray.direction.z < -0.0003 ? 0.5 : 0.9, INFINITY};
    };
    const Scene edge = [](const BeamRay& ray) {
        return place_at(ray, 5).y < 0.1 ? Look{0.8, 5} : Look{0.2, 40};
    };
    for (const double slant : {2.0, 5.0, 15.0, 30.0}) {
        const CameraParameters leaning = sheet(Arrangement::lenticular, slant);
        BOOST_TEST(Sampled(leaning, horizon, 1).errors(horizon)[1] < 0.001, "slant " << slant);
        if (slant > 10)
            BOOST_TEST(ratio(leaning, edge, 1) < 0.2, "slant " << slant);
    }
}

BOOST_AUTO_TEST_CASE(what_stands_beside_the_eye_hides_its_part)
{
    // Behind a lenticular sheet all rays of a pixel cross the plane of the eye at one height.
    const CameraParameters parameters = sheet(Arrangement::lenticular);
    const double eye = -camera_of(parameters, 8, 8).optics.aperture().distance;
    for (double before : {0.02, 1.0, 20.0}) {
        const Scene scene = [&](const BeamRay& ray) {
            const double x = place_at(ray, eye + before).x / 31;
            return x - std::floor(x) < 0.4 ? Look{0.2, eye + before} : Look{0.8, 20};
        };
        const double found = ratio(parameters, scene, 16);
        BOOST_TEST(found < 0.78, before << " mm before the eye: " << found);
    }
}

BOOST_AUTO_TEST_CASE(near_depths_are_told_apart)
{
    // Two planes, one shortly before the other: the part that the front one hides must not count.
    const struct {
        double front, back, most;
    } planes[] = {{4, 7, 0.35}, {-20, -14, 0.6}};
    for (const auto& one : planes) {
        const Scene scene = [&](const BeamRay& ray) {
            return place_at(ray, one.front).y < 0.3 ? Look{0.2, one.front} : Look{0.8, one.back};
        };
        const double found = ratio(sheet(Arrangement::square), scene, 4);
        BOOST_TEST(found < one.most, one.front << " mm: " << found);
    }
}

BOOST_AUTO_TEST_CASE(what_lies_behind_is_seen_through_gaps)
{
    // A fence in front of a textured wall; the wall differs where the fence hides it.
    const Scene wall = chequers(30, 4);
    const Scene scene = [&](const BeamRay& ray) {
        const double x = place_at(ray, -12).x / 1.7;
        return x - std::floor(x) < 0.4 ? Look{0.05, -12} : wall(ray);
    };
    BOOST_TEST(ratio(sheet(Arrangement::square), scene, 4) < 0.7);
    BOOST_TEST(ratio(sheet(Arrangement::square), scene, 16) < 0.9);
}

BOOST_AUTO_TEST_CASE(what_hides_the_same_part_counts_once)
{
    // Three ridges before a bright sky: all hide the lower part of the beams.
    const Scene scene = [&](const BeamRay& ray) {
        if (place_at(ray, -2).y < 0.4)
            return Look{0.2, -2};
        if (place_at(ray, 10).y < 0.45)
            return Look{0.15, 10};
        if (place_at(ray, 22).y < 0.5)
            return Look{0.1, 22};
        return Look{0.9, 1e9};
    };
    const double found = ratio(sheet(Arrangement::square), scene, 16);
    BOOST_TEST(found < 0.6, found);
}

BOOST_AUTO_TEST_CASE(each_side_of_a_floor_counts_for_itself)
{
    // The floor extends to its horizon. Rays with slopes of the lower half meet its bright upper
    // side, the others its dark lower side.
    const auto found = [](bool tells) {
        return ratio(sheet(Arrangement::square), floor_up_to(1e4, {0.9, 1e9}, 0.6, 0.1, tells), 4);
    };
    BOOST_TEST(found(true) < 0.45);
    BOOST_TEST(found(false) > 0.8); // this floor needs the tilts
}

BOOST_AUTO_TEST_CASE(rays_that_pass_end_on_the_same_floor_later)
{
    // The floor ends at an edge, far before a wall. Rays that are less steep than the pixel's own,
    // or come from the floor's other side, pass where the pixel's own rays meet the floor.
    for (const double edge : {5., 20.}) {
        const double found = ratio(sheet(Arrangement::square),
                                   floor_up_to(edge, {0.9, 120}, 0.1, 0.9), 4);
        BOOST_TEST(found < 0.75, edge << " mm: " << found);
    }
}

BOOST_AUTO_TEST_CASE(a_floor_is_seen_as_far_as_it_goes)
{
    // The floor ends before the sky. Samples of the sky pass above the floor, next to places where
    // the pixel's own rays have not reached it yet.
    for (const double edge : {3., 10., 1e4}) {
        const double found = ratio(sheet(Arrangement::square),
                                   floor_up_to(edge, {0.9, 1e9}, 0.1, 0.1), 16);
        BOOST_TEST(found < 0.65, edge << " mm: " << found);
    }
}

BOOST_AUTO_TEST_CASE(a_floor_far_below_ends_at_its_horizon)
{
    // Near the horizon few samples meet the floor, at many depths. Treated as layers that hide each
    // other, they would leave 0.46 and 0.78 of the error on average.
    const auto found = [](int number) {
        double sum = 0;
        for (const double height : {-6., -12., -24.})
            sum += ratio(sheet(Arrangement::square),
                         floor_up_to(1e9, {0.9, 1e9}, 0.1, 0.1, true, height), number);
        return sum / 3;
    };
    BOOST_TEST(found(4) < 0.43);
    BOOST_TEST(found(16) < 0.74);
}

BOOST_AUTO_TEST_CASE(rare_spots_are_no_surprise)
{
    // Few samples meet a spot, so that the errors of single pixels are far from those predicted
    // from their samples.
    const Scene scene = [](const BeamRay& ray) {
        const Vec2 place = place_at(ray, 4);
        const auto cell = [](double x) { return std::uint64_t(std::int64_t(std::floor(10 * x))); };
        return Look{random_bits(cell(place.x), cell(place.y)) % 64 == 0 ? 4 : 0.1, 4};
    };
    const double few = ratio(sheet(Arrangement::square), scene, 4),
                 many = ratio(sheet(Arrangement::square), scene, 16);
    BOOST_TEST(few < 0.65, few);
    BOOST_TEST(many < 0.78, many);
}

BOOST_AUTO_TEST_CASE(uneven_samples_show_the_mean_of_a_curve)
{
    // More samples near the middle than at the rim; the beam's own density is even.
    std::mt19937 random(5);
    std::normal_distribution<float> normal(0, 0.5f);
    PlaceSums<TwiceFourFloats> places;
    LightPairSums<TwiceFourFloats> sums[2];
    const auto one = [](float x) { return TwiceFourFloats{{x, 0, 0, 0}, {0, 0, 0, 0}}; };
    for (int k = 0; k < 4000;) {
        const float x = normal(random), y = normal(random) + 0.1f;
        if (std::fabs(x) > 1 || std::fabs(y) > 1)
            continue;
        const float light = 2 + x - 0.5f * y + 3 * x * x - y * y;
        const TwiceFourFloats place[4] = {one(x), one(y), one(x * x - 1 / 3.f),
                                          one(y * y - 1 / 3.f)};
        places.add(one(0.5f), place);
        sums[0].add(one(0.5f), place, {one(0), one(light)});
        ++k;
    }
    BOOST_TEST(PlaceRegression(places).mean_over_beam(ValueSums(sums))[1] == 2 + 1 - 1 / 3.f,
               boost::test_tools::tolerance(0.01f));
}

BOOST_AUTO_TEST_CASE(what_moves_otherwise_stays)
{
    // A reflection looks like a texture at a depth other than the surface's.
    const Scene behind = chequers(50, 10);
    const Scene scene = [&](const BeamRay& ray) { return Look{behind(ray).grey, 5}; };
    BOOST_TEST(ratio(sheet(Arrangement::square), scene, 4) < 1.3);
    BOOST_TEST(ratio(sheet(Arrangement::square), scene, 16) < 1.25);
}

BOOST_AUTO_TEST_CASE(further_samples_are_taken_where_a_pixels_own_light_counts)
{
    // A reflection, as above.
    const Scene behind = chequers(50, 10);
    const Scene reflection = [&](const BeamRay& ray) { return Look{behind(ray).grey, 5}; };
    const Scene small_mirror = [&](const BeamRay& ray) {
        const Vec2 place = place_at(ray, 5);
        return Look{std::hypot(place.x, place.y) < 1.3 ? reflection(ray).grey : 0.3, 5};
    };
    struct Result {
        double without, with; // the error
        double number;        // extra samples per pixel
    };
    const auto try_on = [](const Scene& scene, const RefinementRule& rule) {
        Sampled frame(sheet(Arrangement::square), scene, 4);
        long long number = 0;
        const auto further = frame.further(scene, rule,
                                           [&](int, int, int more) { number += more; });
        const double without = frame.errors(scene)[1], with = frame.errors(scene, &further)[1];
        return Result{without, with, double(number) / (width * height)};
    };
    const Result mirror = try_on(reflection, {2, 0.03, 4, true}),
                 rough = try_on(reflection, {2, 0.1, 4, true}),
                 roughest = try_on(reflection, {2, 0.3, 4, true}),
                 small = try_on(small_mirror, {2, 0.3, 4, true}),
                 at_once = try_on(reflection, {1, 0.03, 4, true}),
                 matte = try_on(chequers(5, 10), {2, 0.03, 4, true});
    BOOST_TEST(mirror.with < 0.6 * mirror.without);
    BOOST_TEST(rough.number < 0.5 * mirror.number);
    BOOST_TEST(rough.with < rough.without);
    // At a high threshold, extra samples are taken only where few pixels need them.
    BOOST_TEST(roughest.number < 0.1 * small.number);
    BOOST_TEST(small.with < 0.92 * small.without);
    BOOST_TEST(at_once.number == 0);
    BOOST_TEST(matte.number < 0.05 * mirror.number);
    BOOST_TEST(matte.with < 1.05 * matte.without);
}

BOOST_AUTO_TEST_CASE(one_sample_a_pixel_will_do)
{
    const Scene scene = chequers(6, 3);
    BOOST_TEST(ratio(sheet(Arrangement::square), scene, 1) < 0.5);
    BOOST_TEST(ratio(sheet(Arrangement::lenticular), scene, 1) < 0.75);
}

BOOST_AUTO_TEST_CASE(what_is_not_noisy_is_left_alone)
{
    Sampled frame(sheet(Arrangement::square), chequers(5, 3), 2, 0.001);
    const int x = width / 2, y = height / 2;
    const auto is_left_alone = [&](double variance, double value) {
        for (int j = -4; j <= 4; ++j)
            for (int i = -4; i <= 4; ++i)
                if (!std::isnan(frame.mean[Sampled::at(x + i, y + j)]))
                    frame.put(x + i, y + j, float(value), variance / 1.5); // 1.5: prior_inflation
        return !frame.pixels({x - 4, y - 4, x + 4, y + 4})[Sampled::at(x, y)];
    };
    BOOST_TEST_REQUIRE(!std::isnan(frame.mean[Sampled::at(x, y)]));
    BOOST_TEST(!is_left_alone(3e-4, 0.5));
    BOOST_TEST(is_left_alone(2.9e-6, 0.5)); // least_error is 0.001, for three components
    BOOST_TEST(!is_left_alone(3.1e-6, 0.5));
    BOOST_TEST(is_left_alone(3e-4, 65));
    BOOST_TEST(is_left_alone(NAN, 0.5));
    const auto pixels = frame.pixels();
    int empty = 0;
    for (std::size_t k = 0; k < pixels.size(); ++k)
        if (std::isnan(frame.mean[k])) {
            BOOST_TEST_REQUIRE(!pixels[k]);
            BOOST_TEST_REQUIRE(frame.reconstruction.error_left(int(k) % width, int(k) / width) ==
                               0);
            ++empty;
        }
    BOOST_TEST(empty > 0);
}

BOOST_AUTO_TEST_CASE(no_pixel_depends_on_further_rows)
{
    for (const CameraParameters& p :
         {sheet(Arrangement::square), sheet(Arrangement::hexagonal, 7),
          sheet(Arrangement::lenticular), sheet(Arrangement::lenticular, 25)}) {
        Sampled frame(p, chequers(20, 3), 2);
        const PassRows rows(frame.camera.optics.sheet(), frame.camera.film, 1, true);
        const int reach = rows.reconstructed_from() + rows.estimated_from();
        const auto row = [&] {
            const auto pixels = frame.pixels({0, 0, width - 1, 0});
            std::vector<std::optional<LinearColour>> lights;
            for (int x = 0; x < width; ++x)
                lights.push_back(pixels[x]);
            return lights;
        };
        const auto before = row();
        BeamSamples::Gathered gathered;
        const auto change = [&](int from, int to) {
            const Scene other = [](const BeamRay&) { return Look{0.9, -3}; };
            for (int y = from; y <= to; ++y)
                for (int x = 0; x < width; ++x)
                    frame.take(x, y, other, 2, gathered);
            frame.samples.store(from, gathered);
        };
        change(reach + 1, height - 1);
        BOOST_TEST((row() == before), int(p.sheet.arrangement) << ": further rows change a pixel");
        change(1, reach);
        BOOST_TEST((row() != before));
    }
}

// noise_left is about the variance between frames of different samples. It is larger, because
// samples are spread more evenly than at random.
BOOST_AUTO_TEST_CASE(noise_left_is_about_what_other_samples_change)
{
    for (const Arrangement arrangement : {Arrangement::square, Arrangement::lenticular}) {
        constexpr int seeds = 12;
        std::vector<double> sums(width * height), squares(sums);
        double told = 0, seen = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            Sampled frame(sheet(arrangement), chequers(8, 3), 4, 0.0005, std::uint64_t(seed));
            const auto pixels = frame.pixels();
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (const auto& light = pixels[Sampled::at(x, y)]) {
                        const double value = encode((*light)[0]);
                        sums[Sampled::at(x, y)] += value;
                        squares[Sampled::at(x, y)] += value * value;
                        told += frame.reconstruction.noise_left(x, y) / seeds;
                    } else
                        BOOST_TEST_REQUIRE(frame.reconstruction.noise_left(x, y) == 0);
        }
        for (std::size_t k = 0; k < sums.size(); ++k)
            seen += 3 * (squares[k] - sums[k] * sums[k] / seeds) / (seeds - 1);
        BOOST_TEST(seen > 0.1 * told, int(arrangement) << ": " << seen << " of " << told);
        BOOST_TEST(seen < told, int(arrangement) << ": " << seen << " of " << told);
    }
}

BOOST_AUTO_TEST_CASE(other_cameras_are_left_out)
{
    const auto possible = [](auto change) {
        CameraParameters p = sheet(Arrangement::square);
        change(p);
        return Reconstruction::possible(camera_of(p, width, height));
    };
    BOOST_TEST(possible([](CameraParameters&) {}));
    BOOST_TEST(!possible([](CameraParameters& p) { p.pseudoscopic = true; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.display_prefilter = true; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.pixel_samples = 4; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.model = LensModel::full; }));
}

BOOST_AUTO_TEST_SUITE_END()
