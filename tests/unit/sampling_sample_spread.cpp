// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests how a pixel's samples are distributed over its area and its lens's cell: evenly or at
// random, and independently where they should be.
#include "tests/unit/optics_sheets.h"
#include "tests/unit/pixel_origins.h"

#include <algorithm>

using namespace pixel_origins;

BOOST_AUTO_TEST_SUITE(sampling_sample_spread)

BOOST_AUTO_TEST_CASE(samples_are_spread_evenly_over_all_four_dimensions)
{
    // 64 samples in two halves: each half has one in each 32nd part of every coordinate.
    const IntegralCamera camera = camera_of(parameters_of(Arrangement::square, 8, 8), 60, 60);
    const PixelSampler sampler(camera, 7);
    std::array<double, 4> sum{}, squares{};
    double exact = 1, even_error = 0, random_error = 0;
    const std::array<double, 4> slopes = {0.7, -0.5, 0.9, 0.4};
    for (const double a : slopes)
        exact *= (std::exp(a) - 1) / a;
    const auto error_of = [&](const std::vector<Origin>& list) { // of the mean of exp(slopes . u)
        double mean = 0;
        for (const Origin& at : list) {
            double exponent = 0;
            for (int k = 0; k < 4; ++k)
                exponent += slopes[k] * unit_of(at)[k];
            mean += std::exp(exponent) / list.size();
        }
        return (mean - exact) * (mean - exact);
    };
    int pixels = 0, uneven = 0;
    for_each_pixel(camera, true, [&](Vec2 centre) {
        const auto rays = rays_at(sampler, centre);
        const auto list = origins(camera, centre, rays);
        BOOST_REQUIRE(list.size() == 64u);
        for (int k = 0; k < 4; ++k)
            for (const int half : {0, 1}) {
                std::vector<int> parts(32);
                for (int i = 0; i < 64; ++i)
                    if (rays[i].half == half) {
                        const double u = unit_of(list[i])[k];
                        ++parts[std::clamp(int(32 * u), 0, 31)];
                        sum[k] += u;
                        squares[k] += (u - 0.5) * (u - 0.5);
                    }
                uneven += std::count_if(parts.begin(), parts.end(), [](int n) { return n != 1; }) >
                          0;
            }
        even_error += error_of(list);
        random_error += error_of(origins(camera, centre, random_rays_at(sampler, centre, 64)));
        ++pixels;
    });
    BOOST_TEST(pixels > 1500);
    for (int k = 0; k < 4; ++k) {
        BOOST_TEST(std::fabs(sum[k] / pixels / 64 - 0.5) < 0.0005);
        BOOST_TEST(std::fabs(12 * squares[k] / pixels / 64 - 1) < 0.002);
    }
    BOOST_TEST(uneven <= 2); // but for rounding
    BOOST_TEST_MESSAGE("RMS error: random / even = " << std::sqrt(random_error / even_error));
    BOOST_TEST(random_error > 100 * even_error); // 10 times in the root mean square
}

BOOST_AUTO_TEST_CASE(halves_predict_the_error_of_their_mean)
{
    // Smooth integrands over the four dimensions, and edges. The fraction of points whose
    // coordinates' sum is below 1.6 is given by the Irwin-Hall distribution.
    const std::function<double(const std::array<double, 4>&)> integrands[] = {
        [](const auto& u) { return u[0] * u[1] + u[2] * u[3]; },
        [](const auto& u) { return u[0] + u[1] + u[2] + u[3] < 1.6 ? 1.0 : 0.0; },
        [](const auto& u) { return u[0] + u[2] < 0.8 ? 1.0 : 0.0; },
        [](const auto& u) { return u[1] + u[3] < 0.8 ? 1.0 : 0.0; }};
    const double exact[] = {0.5, (std::pow(1.6, 4) - 4 * std::pow(0.6, 4)) / 24, 0.32, 0.32};
    for (const int samples : {2, 4}) {
        const IntegralCamera camera = camera_of(
            parameters_of(Arrangement::square, samples, samples), 150, 120);
        const PixelSampler sampler(camera, 11);
        double told[4] = {}, found[4] = {}, together[4] = {}, audit[4] = {}, audit_squares[4] = {};
        for_each_pixel(camera, true, [&](Vec2 centre) {
            const auto rays = rays_at(sampler, centre);
            const auto list = origins(camera, centre, rays);
            const auto random = origins(camera, centre, random_rays_at(sampler, centre, 2));
            for (int k = 0; k < 4; ++k) {
                double half[2] = {}, other = 0;
                for (std::size_t i = 0; i < list.size(); ++i)
                    half[rays[i].half] += integrands[k](unit_of(list[i])) / (0.5 * list.size());
                for (const Origin& at : random)
                    other += integrands[k](unit_of(at)) / 2 - exact[k] / 2;
                const double error = 0.5 * (half[0] + half[1]) - exact[k];
                told[k] += 0.25 * (half[0] - half[1]) * (half[0] - half[1]);
                found[k] += error * error;
                together[k] += 0.25 * (half[0] - exact[k]) * (half[1] - exact[k]);
                audit[k] += error * other;
                audit_squares[k] += other * other;
            }
        });
        for (int k = 0; k < 4; ++k) {
            const double correlation = audit[k] / std::sqrt(found[k] * audit_squares[k]);
            BOOST_TEST_MESSAGE(samples << "x" << samples << " integrand " << k << ": told / found "
                                       << told[k] / found[k] << ", halves together "
                                       << together[k] / found[k] << ", audit's correlation "
                                       << correlation);
            BOOST_TEST(std::fabs(told[k] / found[k] - 1) < 0.06);
            BOOST_TEST(std::fabs(together[k] / found[k]) < 0.03);
            // The audit's random rays are independent of the pixel's own samples.
            BOOST_TEST(std::fabs(correlation) < 0.035);
        }
    }
}

BOOST_AUTO_TEST_CASE(random_rays_are_even_and_independent_over_the_lens_s_part)
{
    // A pixel across which the border of two slanted lenses runs.
    CameraParameters p = parameters_of(Arrangement::square);
    p.sheet.slant = 20;
    // The width that fills a lens without slant, so that one lens images nearly the whole pixel.
    const double width = *filling_width(p.sheet, 300, p.sheet.pitch);
    p.capture_aperture = Vec2{width, width};
    const IntegralCamera camera = camera_of(p);
    const PixelSampler sampler(camera, 4);
    Vec2 border{0, 0};
    for_each_pixel(camera, false, [&](Vec2 centre) {
        const auto part = [&](Vec2 shift) {
            const MappedPoint there = camera.optics.map(
                film_from_pixel(camera.film, centre + shift), camera.mapping);
            const MappedPoint own = camera.optics.map(film_from_pixel(camera.film, centre),
                                                      camera.mapping);
            return there.ray && own.ray && there.ray->lens == own.ray->lens;
        };
        if (part({0, 0}) && part({-0.5, -0.5}) && part({-0.5, 0.5}) && !part({0.45, 0}))
            border = centre;
    });
    BOOST_REQUIRE(border.x > 0);
    const int count = random_sheets::count(40000, 400000), cells = 8;
    const auto list = origins(camera, border, random_rays_at(sampler, border, count));
    BOOST_REQUIRE(int(list.size()) == count);

    std::vector<int> film(cells * cells), lens(cells * cells);
    std::array<double, 4> mean{};
    for (const Origin& at : list) {
        const auto u = unit_of(at);
        ++film[int(u[1] * cells) * cells + int(u[0] * cells)];
        ++lens[std::min(cells - 1, int(u[3] * cells)) * cells +
               std::min(cells - 1, int(u[2] * cells))];
        for (int k = 0; k < 4; ++k)
            mean[k] += u[k] / count;
    }
    std::vector<int> whole_cells; // counts of cells that lie wholly behind the lens
    int others = 0;
    for (int cell = 0; cell < cells * cells; ++cell) {
        int own = 0;
        for (int corner = 0; corner < 4; ++corner) {
            const Vec2 at{double(cell % cells + corner % 2) / cells - 0.5,
                          0.5 - double(cell / cells + corner / 2) / cells};
            const MappedPoint there = camera.optics.map(film_from_pixel(camera.film, border + at),
                                                        camera.mapping);
            own += there.ray && there.ray->lens == lens_at(camera, border);
        }
        if (own == 4)
            whole_cells.push_back(film[cell]);
        others += own == 0;
        BOOST_TEST((own > 0 || film[cell] == 0));
    }
    BOOST_TEST(whole_cells.size() > 30u);
    BOOST_TEST(others > 1);
    const auto chi_squared = [](const std::vector<int>& counts) {
        double average = 0, sum = 0;
        for (const int n : counts)
            average += double(n) / counts.size();
        for (const int n : counts)
            sum += (n - average) * (n - average) / average;
        return sum;
    };
    const auto most = [](std::size_t bins) { return bins + 4 * std::sqrt(2.0 * bins); };
    BOOST_TEST(chi_squared(whole_cells) < most(whole_cells.size()));
    BOOST_TEST(chi_squared(lens) < most(lens.size()));
    // Coordinates are independent of each other and of the coordinates of the next index.
    for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 4; ++k) {
            double same = 0, next = 0, a = 0, b = 0;
            for (int i = 0; i + 1 < count; ++i) {
                const double u = unit_of(list[i])[j] - mean[j], v = unit_of(list[i])[k] - mean[k];
                same += u * v;
                next += u * (unit_of(list[i + 1])[k] - mean[k]);
                a += u * u;
                b += v * v;
            }
            const double limit = 4 * std::sqrt(a * b / count);
            if (j != k && !(j < 2 && k < 2)) // x and y depend on each other at slanted borders
                BOOST_TEST(std::fabs(same) < limit);
            BOOST_TEST(std::fabs(next) < limit);
        }
}

BOOST_AUTO_TEST_CASE(slit_heights_are_spread_over_the_aperture_s_chord)
{
    for (const ApertureShape shape : {ApertureShape::rectangle, ApertureShape::ellipse})
        for (const double slant : {5.0, 75.0})
            for (const bool random : {false, true}) {
                CameraParameters p = parameters_of(Arrangement::lenticular, 2, 8);
                p.sheet.slant = slant;
                p.aperture_shape = shape;
                p.capture_aperture = slant < 45 ? Vec2{180, 60} : Vec2{60, 180};
                const IntegralCamera camera = camera_of(p, 60, 60);
                const PixelSampler sampler(camera, 9);
                double count = 0, sum = 0, squares = 0, farthest = 0;
                for_each_pixel(camera, true, [&](Vec2 centre) {
                    const auto rays = random ? random_rays_at(sampler, centre, 8)
                                             : rays_at(sampler, centre);
                    for (const Origin& at : origins(camera, centre, rays)) {
                        const Vec2 film_point = film_from_pixel(camera.film, centre + at.film);
                        const MappedPoint pole = camera.optics.map(film_point, camera.mapping);
                        BOOST_REQUIRE(pole.ray);
                        const Vec2 a = pole.ray->aperture_point;
                        const double along = (slant < 45 ? a.x : a.y) / 90;
                        const double chord = shape == ApertureShape::rectangle
                                                 ? 60
                                                 : 60 * std::sqrt(1 - along * along);
                        const double part = at.slit / chord; // -1/2 to 1/2
                        farthest = std::max(farthest, std::fabs(part));
                        sum += part;
                        squares += part * part;
                        ++count;
                    }
                });
                BOOST_TEST(count > 10000);
                BOOST_TEST(farthest < 0.5 + 1e-6);
                BOOST_TEST(farthest > 0.499);
                BOOST_TEST(std::fabs(sum / count) < 4 / std::sqrt(12 * count));
                BOOST_TEST(std::fabs(12 * squares / count - 1) < 4 / std::sqrt(count));
            }
}

BOOST_AUTO_TEST_SUITE_END()
