// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the reconstruction of anti-aliased frames on scenes in closed form, which are looked at
// along the rays of the optics: the reconstruction itself has only paraxial steps between pixels.
#include "integral/lightfield/reconstruction.h"
#include "tests/unit/pixel_origins.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

using namespace pixel_origins;

namespace {

constexpr int width = 90, height = 80;

/// What is seen at a place (mm) of the scene: a colour and its depth.
struct Seen {
    double colour, depth;
};
using Scene = std::function<Seen(const BeamRay&)>;

Vec2 place_at(const BeamRay& ray, double depth)
{
    const double way = depth / ray.direction.z;
    return {ray.point.x + way * ray.direction.x, ray.point.y + way * ray.direction.y};
}

/// Waves on a plane that is parallel to the sheet.
Scene waves(double depth, double period)
{
    return [=](const BeamRay& ray) {
        const Vec2 place = place_at(ray, depth);
        const double turn = 2 * 3.14159265358979 / period;
        return Seen{0.5 + 0.2 * std::sin(turn * place.x) + 0.2 * std::cos(turn * place.y), depth};
    };
}

/// A frame of noisy pixels, and what its pixels are without noise.
struct Noisy {
    IntegralCamera camera;
    FirstSamples first;
    Reconstruction reconstruction;
    std::vector<double> truth, mean; ///< NaN for an empty pixel
    double noise;

    Noisy(const CameraParameters& parameters, const Scene& scene, double noise)
        : camera(camera_of(parameters, width, height)),
          first(camera),
          reconstruction(camera, first, 0.001),
          truth(std::size_t(width) * height, NAN),
          mean(truth),
          noise(noise)
    {
        std::mt19937 random(7);
        std::normal_distribution<double> bell(0, noise);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto ray = camera.optics
                                     .map(film_from_pixel(camera.film, {x + 0.5, y + 0.5}),
                                          LensMapping::closest)
                                     .ray;
                if (!ray)
                    continue;
                const Seen seen = scene(pole_beam(*ray));
                truth[at(x, y)] = seen.colour;
                mean[at(x, y)] = seen.colour + bell(random);
                first.set(x, y, grey(seen.colour), ray->lens, seen.depth);
                put(x, y, mean[at(x, y)]);
            }
    }

    static std::size_t at(int x, int y) { return std::size_t(y) * width + x; }
    static ComparedColour grey(double value) { return {value, value, value, 0}; }
    /// The noise is the same in three components. Where halves show no error, three times as much
    /// as stated is expected.
    void put(int x, int y, double value) { reconstruction.set(x, y, grey(value), noise * noise); }

    /// The RMS error of the reconstructed pixels in terms of that of the noisy ones.
    double ratio()
    {
        reconstruction.estimate(0, 0, width - 1, height - 1);
        Reconstruction::Scratch scratch;
        double before = 0, after = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double true_one = truth[at(x, y)];
                const auto found = reconstruction.reconstructed(x, y, scratch);
                if (!found)
                    continue;
                before += std::pow(mean[at(x, y)] - true_one, 2);
                after += std::pow((*found)[1] - true_one, 2);
            }
        return std::sqrt(after / before);
    }
};

CameraParameters sheet(Arrangement arrangement, double slant = 0)
{
    CameraParameters p = parameters_of(arrangement);
    p.sheet.slant = slant;
    p.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    p.mapping = LensMapping::closest;
    return p;
}

} // namespace

BOOST_AUTO_TEST_SUITE(lightfield_reconstruction)

BOOST_AUTO_TEST_CASE(noise_falls_and_texture_stays)
{
    // Waves of six patches' width, which neighbouring pixels see shifted by up to a third of a
    // wave: whoever looks for the overlapping pixels at other places destroys them.
    const struct {
        Arrangement arrangement;
        double slant, most;
    } sheets[] = {{Arrangement::square, 0, 0.63},      {Arrangement::square, 20, 0.63},
                  {Arrangement::hexagonal, 0, 0.63},   {Arrangement::lenticular, 0, 0.75},
                  {Arrangement::lenticular, 15, 0.85}, {Arrangement::lenticular, -70, 0.93}};
    for (const auto& one : sheets)
        for (double depth : {-25.0, -6.0, 0.0, 8.0, 40.0}) {
            const CameraParameters p = sheet(one.arrangement, one.slant);
            const double slopes = p.sheet.ior * p.film.pixel_pitch.x / p.sheet.thickness;
            const double patch = p.sheet.pitch + std::fabs(depth) * slopes;
            Noisy frame(p, waves(depth, 6 * patch), 0.05);
            const double ratio = frame.ratio();
            BOOST_TEST(ratio < one.most, int(one.arrangement)
                                             << " turned by " << one.slant << ", depth " << depth
                                             << ": " << ratio);
        }
}

BOOST_AUTO_TEST_CASE(fine_texture_is_not_smoothed_away)
{
    // Waves that are hardly wider than a patch: overlapping pixels differ, and are not averaged.
    for (double depth : {0.0, 10.0}) {
        const CameraParameters p = sheet(Arrangement::square);
        const double slopes = p.sheet.ior * p.film.pixel_pitch.x / p.sheet.thickness;
        Noisy frame(p, waves(depth, 1.2 * (p.sheet.pitch + depth * slopes)), 0.02);
        BOOST_TEST(frame.ratio() < 1.1);
    }
}

BOOST_AUTO_TEST_CASE(outlines_stay)
{
    // A bright plane covers half of a dark one far behind it.
    const Scene scene = [](const BeamRay& ray) {
        return place_at(ray, 10).x < 1 ? Seen{0.8, 10} : Seen{0.2, 60};
    };
    Noisy frame(sheet(Arrangement::square), scene, 0.05);
    BOOST_TEST(frame.ratio() < 0.7);
}

BOOST_AUTO_TEST_CASE(what_moves_otherwise_stays)
{
    // A reflection: it looks like a texture at another depth than that of the surface.
    const Scene waves_behind = waves(50, 8);
    const Scene scene = [&](const BeamRay& ray) { return Seen{waves_behind(ray).colour, 5}; };
    Noisy frame(sheet(Arrangement::square), scene, 0.01);
    BOOST_TEST(frame.ratio() < 1.2);
}

BOOST_AUTO_TEST_CASE(what_is_not_noisy_is_left_alone)
{
    Noisy frame(sheet(Arrangement::square), waves(5, 6), 0.05);
    const int x = width / 2, y = height / 2;
    const auto quiet = [&](double variance, double value) {
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i)
                frame.reconstruction.set(x + i, y + j, Noisy::grey(value), variance / 3);
        frame.reconstruction.estimate(0, 0, width - 1, height - 1);
        Reconstruction::Scratch scratch;
        return !frame.reconstruction.reconstructed(x, y, scratch);
    };
    BOOST_TEST(!quiet(3e-4, 0.5));
    BOOST_TEST(quiet(2.9e-6, 0.5)); // least_error is 0.001, of three components
    BOOST_TEST(!quiet(3.1e-6, 0.5));
    BOOST_TEST(quiet(3e-4, 8.5)); // is stored as 8
    BOOST_TEST(quiet(NAN, 0.5));
    Reconstruction::Scratch scratch;
    int empty = 0;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            if (std::isnan(frame.truth[Noisy::at(i, j)])) {
                BOOST_TEST_REQUIRE(!frame.reconstruction.reconstructed(i, j, scratch));
                ++empty;
            }
    BOOST_TEST(empty > 0);
}

BOOST_AUTO_TEST_CASE(halves_correct_the_expected_error)
{
    // The same noise, of which the variances say a hundredth: only the halves know of it.
    const auto ratio = [](bool halves_tell) {
        const double noise = 0.05;
        Noisy frame(sheet(Arrangement::square), waves(5, 6), noise);
        std::mt19937 random(5);
        std::normal_distribution<double> bell(0, noise);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (const double mean = frame.mean[Noisy::at(x, y)]; !std::isnan(mean))
                    frame.reconstruction.set(x, y, Noisy::grey(mean), 0.03 * noise * noise,
                                             halves_tell ? 3 * std::pow(bell(random), 2) : -1);
        return frame.ratio();
    };
    const double with = ratio(true), without = ratio(false);
    BOOST_TEST(with < 0.6);
    BOOST_TEST(without > 0.9);
}

BOOST_AUTO_TEST_CASE(no_pixel_depends_on_further_rows)
{
    for (const CameraParameters& p :
         {sheet(Arrangement::square), sheet(Arrangement::hexagonal, 7),
          sheet(Arrangement::lenticular), sheet(Arrangement::lenticular, 25)}) {
        Noisy frame(p, waves(20, 10), 0.05);
        const int reach = rows_reconstructed_from(frame.camera.optics.sheet(), frame.camera.film);
        const auto row = [&](int y) {
            frame.reconstruction.estimate(0, 0, width - 1, height - 1);
            Reconstruction::Scratch scratch;
            std::vector<std::optional<ComparedColour>> pixels;
            for (int x = 0; x < width; ++x)
                pixels.push_back(frame.reconstruction.reconstructed(x, y, scratch));
            return pixels;
        };
        const auto before = row(0);
        const auto change = [&](int from, int to) {
            for (int y = from; y <= to; ++y)
                for (int x = 0; x < width; ++x)
                    if (!std::isnan(frame.truth[Noisy::at(x, y)]))
                        frame.put(x, y, 0.1);
        };
        change(reach + 1, height - 1);
        BOOST_TEST((row(0) == before), int(p.sheet.arrangement) << ": further rows change a pixel");
        change(1, reach);
        BOOST_TEST((row(0) != before));
    }
}

BOOST_AUTO_TEST_SUITE_END()
