// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares error estimates with known errors: of single pixels with a known distribution of light,
// of populations of pixels, and of whole small frames.
#include "integral/frame/error_estimate.h"
#include "tests/unit/optics_sheets.h"
#include "tests/unit/pixel_origins.h"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <limits>
#include <random>

using namespace pixel_origins;

BOOST_AUTO_TEST_SUITE(frame_error_estimate)

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 nan_value = std::numeric_limits<double>::quiet_NaN();
const OutputCurve srgb; // from linear light
const OutputCurve straight{{Encoding::Kind::linear}, {Encoding::Kind::linear}};

std::mt19937_64 engine; // seeded by every case that uses it
double uniform() { return std::uniform_real_distribution<double>(0, 1)(engine); }
double normal() { return std::normal_distribution<double>()(engine); }

Light grey(double value) { return {value, value, value}; }

/// The light that reaches a pixel: random samples of it, and their mean.
struct Distribution {
    const char* name;
    std::function<double()> sample;
    double mean;
    double kept;        ///< the fraction of the plain estimate's bias that the jackknife may leave
    double besides = 0; ///< the bias that it may add, where nearly all of the light is cut off
    double of_one = 0;  ///< the fraction of one sample's squared error that it may add to that
};

Distribution edge(const char* name, double dark, double bright, double covered, double kept,
                  double of_one = 0)
{
    return {name,
            [=] { return uniform() < covered ? bright : dark; },
            dark + covered * (bright - dark),
            kept,
            0,
            of_one};
}

const Distribution distributions[] = {
    edge("edge", 0.2, 0.8, 0.5, 0.03),
    edge("little of a bright object", 0.02, 0.5, 0.1, 0.05),
    edge("black and white", 0, 1, 0.5, 0.2),
    edge("little white on black", 0, 1, 0.1, 0.45, 0.015), // where sRGB is at its steepest
    {"smooth", [] { return 0.2 + 0.6 * uniform(); }, 0.5, 0.03},
    {"dark", [] { return 0.02 * uniform(); }, 0.01, 0.08},
    {"clipped", [] { return 2 * std::sqrt(uniform()); }, 4 / 3.0, 0, 2e-5},
    {"a lamp, half in sight", [] { return uniform() < 0.5 ? 0.1 : 40; }, 20.05, 0, 1.5e-4}};

/// A mean with its standard error.
struct Mean {
    double sum = 0, squares = 0;
    int count = 0;
    void add(double value) { sum += value, squares += value * value, ++count; }
    double value() const { return sum / count; }
    double error() const
    {
        return std::sqrt(std::max(0.0, squares / count - value() * value()) / count);
    }
};

double squared(double x) { return x * x; }

} // namespace

BOOST_AUTO_TEST_CASE(output_values)
{
    BOOST_TEST(srgb(0.5) == 0.7353569830524495, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(straight(0.3) == 0.3);
    const OutputCurve power{{Encoding::Kind::power, 2}, {Encoding::Kind::linear}};
    BOOST_TEST(power(0.5) == 0.25, boost::test_tools::tolerance(1e-12));
    for (const OutputCurve& curve : {srgb, straight, power})
        for (const double low : {0.0, -1.0, -infinity, nan_value, -1e300}) {
            BOOST_TEST(curve(low) == 0);
            BOOST_TEST(curve(std::isnan(low) ? 2 : 1 - low) == 1,
                       boost::test_tools::tolerance(1e-12));
        }
}

BOOST_AUTO_TEST_CASE(audited_error_is_unbiased_and_the_plain_error_is_not)
{
    engine.seed(1);
    constexpr int samples = 32;
    const int trials = random_sheets::count(12000, 1000000);
    for (const Distribution& light : distributions)
        for (const double off : {0.0, 0.05, -0.02, 1.0}) { // 1: the pixel is one sample
            Mean audit, plain, error;
            for (int trial = 0; trial < trials; ++trial) {
                const double pixel = off == 1 ? light.sample() : std::max(0.0, light.mean + off);
                const double exact = squared(srgb(pixel) - srgb(light.mean));
                double halves[2] = {};
                for (int i = 0; i < samples; ++i)
                    halves[i % 2] += light.sample() / (samples / 2);
                audit.add(audited_error(srgb, grey(pixel), grey(halves[0]), grey(halves[1])) -
                          exact);
                plain.add(squared(srgb(pixel) - srgb(0.5 * (halves[0] + halves[1]))) - exact);
                error.add(exact);
            }
            const double of_one = off == 1 ? light.of_one * error.value() : 0;
            BOOST_TEST_MESSAGE(light.name << ", off by " << off << ": bias " << audit.value()
                                          << " +- " << audit.error() << ", plain " << plain.value()
                                          << " +- " << plain.error());
            BOOST_TEST(std::fabs(audit.value()) < 4 * audit.error() +
                                                      light.kept * std::fabs(plain.value()) +
                                                      light.besides + of_one,
                       light.name << " off by " << off << ": " << audit.value() << " +- "
                                  << audit.error());
            if (off == 0 && light.mean < 1)
                BOOST_TEST(plain.value() > 20 * plain.error());
        }
}

BOOST_AUTO_TEST_CASE(each_channel_counts_a_third)
{
    const Light same = {0.25, 0.5, 0.75};
    BOOST_TEST(audited_error(straight, same, same, same) == 0);
    BOOST_TEST(audited_error(straight, {0.45, 0.5, 0.65}, same, same) == 0.05 / 3,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(halves_error(straight, {0.2, 0.5, 0.9}, {0.4, 0.5, 0.9}, 8, 8) == 0.01 / 3,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(halves_error(straight, grey(0.2), grey(0.6), 4, 12) == 0.16 * 3 / 16,
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(halves_error_is_the_error_of_their_mean)
{
    engine.seed(2);
    // With a linear encoding, the estimate's mean is the true squared error, however unequal the
    // halves are. With sRGB it is within 25% of it, for edges anywhere in the pixel. (The case
    // the_interval_holds_the_error_of_whole_frames uses PixelSampler's own samples.)
    const int trials = random_sheets::count(40000, 3000000);
    const struct {
        const OutputCurve& curve;
        int first, second;
        double dark, bright, low, high;
    } cases[] = {{straight, 1, 1, 0, 1, 0.97, 1.03},     {straight, 2, 3, 0, 1, 0.97, 1.03},
                 {straight, 8, 8, 0.2, 0.8, 0.97, 1.03}, {srgb, 8, 8, 0, 1, 1, 1.25},
                 {srgb, 8, 8, 0.02, 0.6, 1, 1.2},        {srgb, 8, 8, 0.2, 0.8, 0.97, 1.06},
                 {srgb, 32, 32, 0, 1, 1, 1.2},           {srgb, 32, 32, 0, 3, 1, 1.25}};
    for (const auto& c : cases) {
        Mean told, found;
        for (int trial = 0; trial < trials; ++trial) {
            const double covered = uniform(), mean = c.dark + covered * (c.bright - c.dark);
            double half[2] = {};
            for (int i = 0; i < c.first + c.second; ++i)
                half[i >= c.first] += (uniform() < covered ? c.bright : c.dark) /
                                      (i < c.first ? c.first : c.second);
            told.add(halves_error(c.curve, grey(half[0]), grey(half[1]), c.first, c.second));
            found.add(
                squared(c.curve((c.first * half[0] + c.second * half[1]) / (c.first + c.second)) -
                        c.curve(mean)));
        }
        BOOST_TEST_MESSAGE(c.first << " + " << c.second << " samples of " << c.dark << "/"
                                   << c.bright << ": told / found "
                                   << told.value() / found.value());
        BOOST_TEST(told.value() / found.value() > c.low);
        BOOST_TEST(told.value() / found.value() < c.high);
    }
}

BOOST_AUTO_TEST_CASE(the_interval_holds_the_error_of_heavy_tailed_populations)
{
    engine.seed(3);
    // Squared errors of pixels: most are 0 or small, and a few are large, as at a frame's edges,
    // lines and highlights.
    const auto few = [](double part, std::function<double()> error) {
        return [=] { return uniform() < part ? error() : 0.0; };
    };
    const struct {
        const char* name;
        std::function<double()> error;
        double mean;
    } populations[] = {
        {"0.5% alike", few(0.005, [] { return 0.25; }), 0.00125},
        {"1% alike", few(0.01, [] { return 0.25; }), 0.0025},
        {"1% of all sizes", few(0.01, [] { return squared(uniform()); }), 0.01 / 3},
        {"2% exponential", few(0.02, [] { return -0.05 * std::log(1 - uniform()); }), 0.001},
        {"30% alike", few(0.3, [] { return 0.1; }), 0.03},
        {"lognormal", [] { return 1e-4 * std::exp(1.5 * normal()); }, 1e-4 * std::exp(1.125)},
        {"lognormal, long-tailed", [] { return 1e-4 * std::exp(2 * normal()); },
         1e-4 * std::exp(2.0)},
        {"small, and 1% large", [] { return 1e-4 * uniform() + (uniform() < 0.01 ? 0.2 : 0); },
         0.00205},
        {"1%, and an audit's noise",
         [] { return (uniform() < 0.01 ? 0.1 : 0) + (uniform() < 0.1 ? 0.005 * normal() : 0); },
         0.001},
        {"normal errors", [] { return 1e-3 * squared(normal()); }, 1e-3}};
    const int audits = random_sheets::count(400, 10000);
    for (const auto& population : populations) {
        int too_low = 0, too_high = 0;
        double widest = 0;
        for (int audit = 0; audit < audits; ++audit) {
            ErrorSums sums;
            for (int pixel = 0; pixel < 1000; ++pixel)
                sums.add(population.error());
            const auto result = estimate(sums, ErrorMethod::audit);
            const double truth = std::sqrt(population.mean);
            too_low += truth > result->high;
            too_high += truth < result->low;
            widest = std::max(widest, result->high / result->rms);
        }
        BOOST_TEST_MESSAGE(population.name << ": too low " << 100.0 * too_low / audits
                                           << "%, too high " << 100.0 * too_high / audits
                                           << "%, widest " << widest);
        BOOST_TEST(too_low + too_high <= 0.09 * audits,
                   population.name << ": " << too_low << " and " << too_high);
        BOOST_TEST(too_low <= 0.065 * audits, population.name << ": " << too_low);
        const double of_95 = 0.025 * audits; // and two standard deviations, for chance
        BOOST_TEST(too_high <= of_95 + 2 * std::sqrt(of_95), population.name << ": " << too_high);
        if (population.name == std::string("normal errors"))
            BOOST_TEST(widest < 1.2); // the interval is narrow enough to be useful
    }
}

BOOST_AUTO_TEST_CASE(the_lower_bound_is_that_of_a_rate_of_rare_events)
{
    // Among very many pixels `count` have an error, all the same one.
    for (const double count : {4.0, 5.0, 7.0, 10.0, 30.0, 100.0, 1e4, 1e6}) {
        ErrorSums sums;
        sums.pixels = 1000000000000;
        sums.sum = sums.sum_of_squares = count;
        const auto result = estimate(sums, ErrorMethod::audit, 0);
        const double mean = std::sqrt(count / sums.pixels),
                     exact = std::sqrt(boost::math::gamma_p_inv(count, 0.025) / count);
        BOOST_TEST(result->low / mean == exact, boost::test_tools::tolerance(0.007));
    }
}

BOOST_AUTO_TEST_CASE(the_interval_of_halves_holds_the_frame_s_own_error)
{
    engine.seed(4);
    // The halves of pixels give the expected error; the frame's own error is one random outcome.
    int held = 0;
    const int frames = random_sheets::count(400, 10000);
    for (int frame = 0; frame < frames; ++frame) {
        ErrorSums sums;
        double truth = 0;
        for (int pixel = 0; pixel < 2000; ++pixel) {
            const double variance = uniform() < 0.03 ? 0.02 * uniform() : 1e-5;
            sums.add(variance * squared(normal()));
            truth += variance * squared(normal()) / 2000;
        }
        const auto result = estimate(sums, ErrorMethod::split_halves);
        held += std::sqrt(truth) >= result->low && std::sqrt(truth) <= result->high;
    }
    BOOST_TEST(held >= 0.93 * frames);
}

namespace {

/// Light of a scene without shading: checks behind the sheet, a white disc on black before it, fine
/// lines, a smooth picture.
using Scene = std::function<Light(Vec2 behind, Vec2 before)>;
const std::pair<const char*, Scene> scenes[] = {
    {"checks",
     [](Vec2 p, Vec2) {
         return int(std::floor(p.x / 4) + std::floor(p.y / 4)) % 2 ? Light{0.8, 0.8, 0.9}
                                                                   : Light{0.1, 0.12, 0.3};
     }},
    {"disc",
     [](Vec2, Vec2 p) {
         return length(p) < 2.5 ? Light{1, 1, 1} : Light{0, 0, 0};
     }},
    {"lines", [](Vec2 p, Vec2) { return grey(p.x / 6 - std::floor(p.x / 6) < 0.04 ? 0.9 : 0.05); }},
    {"smooth", [](Vec2 p, Vec2) {
         return Light{0.5 + 0.4 * std::sin(p.x / 3), 0.5 + 0.3 * std::cos(p.y / 2), 0.02};
     }}};

Light seen(const Scene& scene, const BeamRay& ray)
{
    const auto at = [&](double z) {
        const double way = (z - ray.point.z) / ray.direction.z;
        return Vec2{ray.point.x + way * ray.direction.x, ray.point.y + way * ray.direction.y};
    };
    return scene(at(30), at(-10));
}

std::vector<Light> light_of(const Scene& scene, const std::vector<PixelRay>& rays)
{
    std::vector<Light> list;
    for (const PixelRay& ray : rays)
        list.push_back(seen(scene, ray.ray));
    return list;
}

Light mean_of(const std::vector<Light>& list, std::size_t from, std::size_t to)
{
    Light mean{};
    for (std::size_t i = from; i < to; ++i)
        for (int k = 0; k < 3; ++k)
            mean[k] += list[i][k] / (to - from);
    return mean;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_interval_holds_the_error_of_whole_frames)
{
    // 100 small frames, 25 a scene: 15 with a quarter of the pixels audited, 10 judged by their
    // halves.
    int held = 0, frames = 0;
    for (const auto& scene : scenes) {
        Mean told[2], found[2]; // mean squares, by the audit and by halves
        const IntegralCamera one = camera_of(parameters_of(Arrangement::square), 60, 50);
        const IntegralCamera sampled = camera_of(parameters_of(Arrangement::square, 4, 4), 60, 50);
        const PixelSampler reference(one, 1000);
        std::vector<Vec2> pixels;
        std::vector<std::pair<Light, Light>> converged; // two references, to remove their noise
        for_each_pixel(one, false, [&](Vec2 centre) {
            if (const auto rays = random_rays_at(reference, centre, 256); !rays.empty()) {
                pixels.push_back(centre);
                const auto light = light_of(scene.second, rays);
                converged.emplace_back(mean_of(light, 0, 128), mean_of(light, 128, 256));
            }
        });
        for (int seed = 0; seed < 25; ++seed) {
            const bool halves = seed % 5 < 2;
            const PixelSampler sampler(halves ? sampled : one, seed);
            BOOST_REQUIRE(sampler.halves_tell_error() == halves);
            ErrorSums sums;
            double truth = 0;
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                const auto rays = rays_at(sampler, pixels[i]);
                const auto light = light_of(scene.second, rays);
                const Light pixel = mean_of(light, 0, light.size());
                for (int k = 0; k < 3; ++k)
                    truth += (srgb(pixel[k]) - srgb(converged[i].first[k])) *
                             (srgb(pixel[k]) - srgb(converged[i].second[k])) /
                             (3.0 * pixels.size());
                const auto in_first = [](const PixelRay& ray) { return ray.half == 0; };
                const std::size_t first = std::count_if(rays.begin(), rays.end(), in_first);
                if (halves && first > 0 && first < rays.size())
                    sums.add(halves_error(srgb, mean_of(light, 0, first),
                                          mean_of(light, first, light.size()), int(first),
                                          int(light.size() - first)));
                else if (!halves && random_bits(seed, i) % 4 == 0) {
                    const auto half = [&](int set) {
                        std::vector<PixelRay> random;
                        for (std::uint32_t index = 0; index < 4; ++index)
                            sampler.append_reference_ray(pixels[i], set, index, random);
                        const auto seen = light_of(scene.second, random);
                        return mean_of(seen, 0, seen.size());
                    };
                    sums.add(audited_error(srgb, pixel, half(0), half(1)));
                }
            }
            const auto result = estimate(sums,
                                         halves ? ErrorMethod::split_halves : ErrorMethod::audit);
            const double rms = std::sqrt(std::max(0.0, truth));
            BOOST_TEST_MESSAGE(scene.first << (halves ? " halves " : " audit ") << rms << ": "
                                           << result->rms << " in " << result->low << " to "
                                           << result->high);
            held += rms >= result->low && rms <= result->high;
            ++frames;
            told[halves].add(squared(result->rms));
            found[halves].add(truth);
        }
        for (const bool halves : {false, true}) {
            const double ratio = told[halves].value() / found[halves].value();
            BOOST_TEST_MESSAGE(scene.first << (halves ? " halves" : " audit") << ": told / found "
                                           << ratio);
            BOOST_TEST(std::fabs(ratio - 1) < 0.12);
        }
    }
    BOOST_TEST(frames == 100);
    BOOST_TEST(held >= 90);
}

BOOST_AUTO_TEST_CASE(estimates_of_odd_sums)
{
    BOOST_TEST(!estimate({}, ErrorMethod::audit));
    ErrorSums one;
    one.add(0.5);
    BOOST_TEST(!estimate(one, ErrorMethod::split_halves));

    for (const ErrorMethod method : {ErrorMethod::audit, ErrorMethod::split_halves})
        for (const std::vector<double>& values :
             std::vector<std::vector<double>>{{0, 0},
                                              {0.25, 0.25},
                                              {1, 0},
                                              {-0.1, 0.05},
                                              {-1, -1},
                                              {1e-300, 0},
                                              {1e100, 1},
                                              {1e200, 1e200},
                                              {0, 0, 0, 0, 1},
                                              {1, 1, 1, -1e-9}}) {
            ErrorSums sums, parts[2];
            for (std::size_t i = 0; i < values.size(); ++i) {
                sums.add(values[i]);
                parts[i % 2].add(values[i]);
            }
            parts[0].add(parts[1]);
            const auto result = estimate(sums, method);
            BOOST_REQUIRE(result);
            BOOST_TEST(result->pixels == int(values.size()));
            BOOST_CHECK(result->method == method);
            for (const double value : {result->rms, result->low, result->high})
                BOOST_TEST((std::isfinite(value) && value >= 0));
            BOOST_TEST(result->low <= result->rms);
            BOOST_TEST(result->rms <= result->high);
            BOOST_TEST(estimate(parts[0], method)->high == result->high,
                       boost::test_tools::tolerance(1e-12));
            double mean = 0;
            for (const double value : values)
                mean += value / values.size();
            BOOST_TEST(result->rms >= std::min(std::sqrt(std::max(0.0, mean)), result->high));
            if (mean == 0 || mean == -1)
                BOOST_TEST(result->low == 0);
            if (values[0] == 0 && values[1] == 0 && values.size() == 2)
                BOOST_TEST(result->high == 0);
        }

    // Far above 0, rms is the root of the mean. Near 0 and below, its square is the mean expected
    // given that it is not negative: integrals over a normal distribution, computed here in steps.
    for (const double middle : {100.0, 4.0, 1.0, 0.3, 0.0, -0.2, -1.0, -3.0}) {
        ErrorSums sums;
        for (int i = 0; i < 200; ++i) // the standard error is 1
            sums.add(middle + (i % 2 ? 1 : -1) * std::sqrt(199.0));
        double weights = 0, sum = 0;
        for (double value = 5e-4; value < std::max(0.0, middle) + 12; value += 1e-3) {
            const double weight = std::exp(-0.5 * squared(value - middle));
            weights += weight;
            sum += weight * value;
        }
        const auto result = estimate(sums, ErrorMethod::audit);
        BOOST_TEST(squared(result->rms) == sum / weights, boost::test_tools::tolerance(1e-4));
    }
    {
        ErrorSums sums;
        sums.add(0.25);
        sums.add(0.25);
        BOOST_TEST(estimate(sums, ErrorMethod::audit)->rms == 0.5);
    }

    // Independent errors of 0.3 and 0.4 add up to 0.5, and so do their bounds.
    ErrorEstimate both{0.3, 0.15, 0.6, 0.95, ErrorMethod::split_halves, 1000, 1000, 16, 0};
    add_independent(both, {0.4, 0.2, 0.8, 0.95, ErrorMethod::audit, 150, 1000, 32, 2});
    for (const auto& [told, expected] : {std::pair(both.rms, 0.5), std::pair(both.low, 0.25),
                                         std::pair(both.high, 1.0), std::pair(both.seconds, 2.0)})
        BOOST_TEST(told == expected, boost::test_tools::tolerance(1e-12));
    BOOST_CHECK(both.method == ErrorMethod::split_halves);
    BOOST_TEST(both.pixels == 1000);

    // Light of any value, infinite and NaN included, has a finite error.
    for (const double a : {0.5, -3.0, 1e308, infinity, -infinity, nan_value})
        for (const double b : {0.25, 1e308, -1e308, infinity, nan_value}) {
            BOOST_TEST(std::isfinite(audited_error(srgb, grey(a), grey(b), grey(0.5))));
            BOOST_TEST(std::isfinite(audited_error(srgb, grey(0.5), grey(a), grey(b))));
            BOOST_TEST(std::isfinite(halves_error(srgb, grey(a), grey(b), 2, 3)));
        }
}

BOOST_AUTO_TEST_SUITE_END()
