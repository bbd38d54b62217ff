// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the predicted sampling error against limits computed by hand and against random pictures.
#include "integral/sheet/sampling_forecast.h"

#include "integral/sampling/pixel_sampler.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(sheet_sampling_forecast)

namespace {

constexpr double pi = 3.14159265358979323846;

/// A camera of 300 dpi at 300 mm, everything `scale` times as large.
IntegralCamera camera(Arrangement arrangement, double scale = 1)
{
    LensSheet sheet;
    sheet.arrangement = arrangement;
    sheet.pitch *= scale;
    sheet.thickness *= scale;
    const double pixel = mm_per_inch / 300 * scale;
    return {SheetOptics(sheet, *filling_aperture(sheet, 300 * scale)),
            {901, 601, {pixel, pixel}, Subpixels::none},
            {},
            LensMapping::automatic,
            {},
            1,
            1,
            false};
}

std::vector<SamplingForecast> forecast(const IntegralCamera& c, std::vector<double> depths,
                                       double detail,
                                       std::vector<SamplingForecast> settings = sampling_ladder())
{
    BOOST_REQUIRE(forecast_errors(c, depths, detail, settings));
    return settings;
}

Vec2 seen_at(const PixelRay& r, double depth)
{
    const double way = (depth - r.ray.point.z) / r.ray.direction.z;
    return {r.ray.point.x + way * r.ray.direction.x, r.ray.point.y + way * r.ray.direction.y};
}

std::vector<Vec2> points_of(IntegralCamera c, int beam_samples, int pixel_samples, Vec2 centre,
                            std::uint64_t seed, double depth)
{
    c.beam_samples = beam_samples;
    c.pixel_samples = pixel_samples;
    std::vector<PixelRay> rays;
    PixelSampler(c, seed).append_rays(centre, rays);
    std::vector<Vec2> points;
    for (const PixelRay& r : rays)
        points.push_back(seen_at(r, depth));
    return points;
}

/// Random straight edges that meet a circle: a Poisson process of lines, with pi radius/detail
/// lines on average. Along any line, edges are `detail` apart on average.
struct RandomEdges {
    struct Edge {
        Vec2 normal;
        double distance;
    };
    std::vector<Edge> edges;
    RandomEdges(Vec2 centre, double radius, double detail, std::mt19937_64& random)
    {
        std::uniform_real_distribution<double> unit(0, 1);
        const int count = std::poisson_distribution<int>(pi * radius / detail)(random);
        for (int i = 0; i < count; ++i) {
            const double angle = pi * unit(random);
            const Vec2 normal{std::cos(angle), std::sin(angle)};
            edges.push_back({normal, dot(normal, centre) + radius * (2 * unit(random) - 1)});
        }
    }
    int colour(Vec2 p) const
    {
        int crossed = 0;
        for (const Edge& e : edges)
            crossed += dot(e.normal, p) > e.distance;
        return crossed & 1;
    }
    double mean(const std::vector<Vec2>& points) const
    {
        double sum = 0;
        for (const Vec2 p : points)
            sum += colour(p);
        return sum / points.size();
    }
};

} // namespace

BOOST_AUTO_TEST_CASE(one_ray_through_a_narrow_footprint)
{
    // Near the sheet a lenticular lens's beam is its own width, p: sqrt((p/E)/12).
    for (const double detail : {100.0, 1000.0}) {
        const auto errors = forecast(camera(Arrangement::lenticular), {1e-3}, detail, {{1, 1, {}}});
        BOOST_TEST(std::fabs(errors[0].rms[0] / std::sqrt(1.27 / detail / 12) - 1) < 0.01);
    }
}

BOOST_AUTO_TEST_CASE(n_rays_across_a_narrow_footprint)
{
    // N rays, each at random in its own N-th: (p/E)/(6 N^2). The sampler's two independent halves,
    // each an even row shifted at random: 4 * half of that, (p/E)/(3 N^2). Even rows without a
    // shift would have (p/E)/(12 N^2).
    const double detail = 1000;
    for (const int n : {4, 8, 16}) {
        const double square = std::pow(
            forecast(camera(Arrangement::lenticular), {1e-3}, detail, {{n, 1, {}}})[0].rms[0], 2);
        const double stratified = 1.27 / detail / (6.0 * n * n);
        BOOST_TEST(square > 0.5 * stratified, n << " rays: " << square / stratified);
        BOOST_TEST(square < 2.6 * stratified, n << " rays: " << square / stratified);
    }
}

BOOST_AUTO_TEST_CASE(fine_detail_is_all_error_for_one_ray_and_noise_for_many)
{
    // With detail finer than the samples' distances, samples are independent: the squared error is
    // 1/4 for one ray, 1/(4N) for N.
    const auto errors = forecast(camera(Arrangement::square), {1e5}, 0.5,
                                 {{1, 1, {}}, {2, 2, {}}, {4, 4, {}}});
    for (const SamplingForecast& setting : errors)
        BOOST_TEST(std::fabs(setting.rms[0] / std::sqrt(0.25 / setting.rays()) - 1) < 0.05,
                   setting.rays());
}

BOOST_AUTO_TEST_CASE(forecast_agrees_with_random_pictures, *boost::unit_test::label("many_pixels"))
{
    const double detail = 5;
    for (const Arrangement kind :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double depth : {5.0, 100.0}) {
            const IntegralCamera c = camera(kind);
            const auto settings = forecast(c, {depth}, detail);
            std::vector<double> squares(settings.size());
            std::mt19937_64 random(4 + std::uint64_t(kind));
            int count = 0;
            for (int column = 443; column <= 457; ++column) { // the 15 pixels of the middle lens
                const Vec2 centre{column + 0.5, 300.5};
                const auto whole = points_of(c, 20, 20, centre, 0, depth);
                if (whole.empty())
                    continue;
                double radius = 0;
                for (const Vec2 p : whole)
                    radius = std::max(radius, 1.2 * length(p - whole[0]));
                for (int picture = 0; picture < 250; ++picture, ++count) {
                    const RandomEdges edges(whole[0], radius, detail, random);
                    const double right = edges.mean(whole);
                    for (std::size_t i = 0; i < settings.size(); ++i) {
                        const auto points = points_of(c, settings[i].beam_samples,
                                                      settings[i].pixel_samples, centre, random(),
                                                      depth);
                        squares[i] += points.empty() ? 0 : std::pow(edges.mean(points) - right, 2);
                    }
                }
            }
            BOOST_REQUIRE(count >= 3000);
            for (std::size_t i = 0; i < settings.size(); ++i) {
                const double found = std::sqrt(squares[i] / count);
                BOOST_TEST(std::fabs(settings[i].rms[0] / found - 1) < 0.1,
                           "sheet " << int(kind) << ", depth " << depth << ", "
                                    << settings[i].beam_samples << " x "
                                    << settings[i].pixel_samples << ": " << settings[i].rms[0]
                                    << " foretold, " << found << " found");
            }
        }
}

BOOST_AUTO_TEST_CASE(more_rays_of_both_kinds_leave_less)
{
    for (const Arrangement kind : {Arrangement::lenticular, Arrangement::square}) {
        const auto errors = forecast(camera(kind), {2, 20, 200}, 5,
                                     {{1, 1, {}}, {2, 2, {}}, {4, 4, {}}, {8, 8, {}}});
        for (std::size_t i = 1; i < errors.size(); ++i)
            for (int k = 0; k < 3; ++k)
                BOOST_TEST(errors[i].rms[k] < 0.75 * errors[i - 1].rms[k]);
    }
}

BOOST_AUTO_TEST_CASE(forecast_does_not_depend_on_the_unit)
{
    const auto here = forecast(camera(Arrangement::hexagonal), {10, 80}, 5);
    const auto larger = forecast(camera(Arrangement::hexagonal, 16), {160, 1280}, 80);
    for (std::size_t i = 0; i < here.size(); ++i)
        for (int k = 0; k < 2; ++k)
            BOOST_TEST(std::fabs(here[i].rms[k] - larger[i].rms[k]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(no_forecast_where_nothing_is_imaged)
{
    IntegralCamera c = camera(Arrangement::square);
    // an aperture that no pixel's centre sees
    c.optics = SheetOptics(c.optics.sheet(), {300, 0, 0, ApertureShape::rectangle});
    c.film.height = 600;
    auto settings = sampling_ladder();
    BOOST_CHECK(!forecast_errors(c, {10}, 5, settings));
    for (const SamplingForecast& setting : settings)
        BOOST_TEST(setting.rms.empty());
}

BOOST_AUTO_TEST_SUITE_END()
