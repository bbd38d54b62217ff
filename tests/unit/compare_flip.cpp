// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks FLIP against values worked out by hand and against an independent, slow implementation
// (flip_oracle.h).
#include "integral/compare/comparison_rules.h"
#include "integral/compare/flip.h"
#include "integral/compare/flip_loops.h"

#include "tests/unit/flip_oracle.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(compare_flip)

namespace {

/// A picture of bars, a point, noise and flat parts.
flip_oracle::Picture test_picture(int width, int height, unsigned seed, double scale)
{
    flip_oracle::Picture picture{width, height, {}};
    std::mt19937 random(seed);
    const auto noise = [&] { return scale * double(random() % 1000) / 999; };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            flip_oracle::Three p = {0.2L * scale, 0.5L * scale, 0.1L * scale};
            if (x > width / 2)
                p = {0.9L * scale, 0.1L * scale, 0.3L * scale};
            if (y < height / 3)
                p = {noise(), noise(), noise()};
            if (x == width / 4 && y == height / 2)
                p = {scale, scale, scale};
            picture.pixels.push_back(p);
        }
    return picture;
}

std::vector<float> channel(const flip_oracle::Picture& picture, int k)
{
    std::vector<float> values;
    for (const auto& pixel : picture.pixels)
        values.push_back(float(pixel[std::size_t(k)]));
    return values;
}

struct MapAndFigures {
    std::vector<float> map;
    FlipFigures figures;
};

/// Map and figures of FLIP when the rows are added `rows` at a time.
MapAndFigures flip_of_pictures(const flip_oracle::Picture& a, const flip_oracle::Picture& b,
                               const FlipSettings& settings, int rows)
{
    MapAndFigures result;
    Flip flip(a.width, a.height, settings, [&](int first, int count, const float* map) {
        BOOST_TEST(first * a.width == int(result.map.size()));
        result.map.insert(result.map.end(), map, map + std::size_t(count) * a.width);
    });
    std::vector<float> light[2][3];
    for (int k = 0; k < 3; ++k) {
        light[0][k] = channel(a, k);
        light[1][k] = channel(b, k);
    }
    for (int y = 0; y < a.height; y += rows) {
        const std::size_t at = std::size_t(y) * a.width;
        const auto part = [&](int picture) {
            return LightRows{light[picture][0].data() + at, light[picture][1].data() + at,
                             light[picture][2].data() + at};
        };
        flip.add(part(0), part(1), std::min(rows, a.height - y));
    }
    result.figures = flip.result();
    return result;
}

/// The greatest difference between a map and the oracle's; infinite where their sizes differ.
double distance_of(const std::vector<float>& map, const std::vector<flip_oracle::Real>& expected)
{
    double greatest = map.size() == expected.size() ? 0 : INFINITY;
    for (std::size_t i = 0; i < std::min(map.size(), expected.size()); ++i)
        greatest = std::max(greatest, std::fabs(double(map[i]) - double(expected[i])));
    return greatest;
}

flip_oracle::Picture flat(int width, int height, flip_oracle::Three colour)
{
    return {width, height, std::vector<flip_oracle::Three>(std::size_t(width) * height, colour)};
}

} // namespace

BOOST_AUTO_TEST_CASE(flat_black_and_white_by_hand)
{
    // CIELAB of sRGB's green is 87.7355, -86.1816, 83.1866, and of blue 32.3009, 79.1953,
    // -107.8555. With Hunt's effect (a and b times L/100) they are 203.305 apart by HyAB, which to
    // the power 0.7 is 41.2766. Black and white are 100 apart: 25.1189, beyond the knee at 0.4 of
    // 41.2766. Without edges FLIP is 0.95 + 0.05 (25.1189 - 16.5106)/(41.2766 - 16.5106).
    const auto flip = flip_of_pictures(flat(40, 30, {0, 0, 0}), flat(40, 30, {1, 1, 1}), {}, 30);
    BOOST_TEST(flip.figures.mean == 0.967379, boost::test_tools::tolerance(2e-6));
    for (const double quartile : flip.figures.quartiles)
        BOOST_TEST(quartile == 0.967379, boost::test_tools::tolerance(2e-5));
    BOOST_TEST(flip.figures.greatest == 0.967379, boost::test_tools::tolerance(2e-6));
    // Below the knee: greys of L* = 50 and 60 are 10 apart: 0.95 * 10^0.7 / 16.5106.
    const auto grey = [](double l) {
        const double t = (l + 16) / 116;
        return flip_oracle::Real(t * t * t);
    };
    const flip_oracle::Real g = grey(50), h = grey(60);
    BOOST_TEST(flip_of_pictures(flat(5, 4, {g, g, g}), flat(5, 4, {h, h, h}), {}, 1).figures.mean ==
                   0.95 * std::pow(10, 0.7) / 16.5106,
               boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(flat_colours_by_the_papers_formulas)
{
    // In flat pictures the filters change nothing and there are no edges or points, so FLIP is a
    // closed form: CIELAB by sRGB's primaries and D65 (x 0.3127, y 0.3290), Hunt's effect, HyAB to
    // the power 0.7, and the two straight lines that meet at 0.4 of the greatest, 0.95. Worked out
    // with 60 digits, the matrix in fractions.
    struct Pair {
        flip_oracle::Three a, b;
        double flip;
    };
    const Pair pairs[] = {
        {{1, 0, 0}, {0, 1, 0}, 0.98666141483623689025},
        {{0, 1, 0}, {0, 0, 1}, 1},
        {{0.25L, 0.5L, 0.125L}, {0.25L, 0.5L, 0.25L}, 0.37313217089248739881},
        {{0.5L, 0.5L, 0.5L}, {0.5L, 0.5L, 0.53125L}, 0.10151777548296055196},
        {{0x1p-9L, 0x1p-8L, 0x1p-9L}, {0x1p-8L, 0x1p-8L, 0x1p-8L}, 0.04016498734863000419},
    };
    for (const Pair& pair : pairs)
        BOOST_TEST(flip_of_pictures(flat(9, 5, pair.a), flat(9, 5, pair.b), {}, 3).figures.mean ==
                       pair.flip,
                   boost::test_tools::tolerance(2e-5));
}

BOOST_AUTO_TEST_CASE(equal_pictures_have_flip_0)
{
    const auto picture = test_picture(50, 40, 3, 1);
    const auto flip = flip_of_pictures(picture, picture, {}, 7);
    BOOST_TEST(flip.figures.mean == 0);
    BOOST_TEST(flip.figures.greatest == 0);
    BOOST_TEST(flip.figures.quartiles[1] == 0);
}

BOOST_AUTO_TEST_CASE(the_map_against_whole_squares_of_weights)
{
    for (const double ppd : {flip_default_ppd, 25.0}) {
        // Higher than a band of rows, and smaller than a filter.
        for (const auto& size : {std::pair{31, 75}, std::pair{9, 4}}) {
            const auto a = test_picture(size.first, size.second, 1, 1),
                       b = test_picture(size.first, size.second, 2, 0.8);
            FlipSettings settings;
            settings.ppd = ppd;
            const auto flip = flip_of_pictures(a, b, settings, 8);
            const auto expected = flip_oracle::map_of(a, b, ppd);
            BOOST_TEST(distance_of(flip.map, expected) < 1e-5);
            double sum = 0;
            for (const auto value : expected)
                sum += double(value) / double(expected.size());
            BOOST_TEST(flip.figures.mean == sum, boost::test_tools::tolerance(1e-5));
        }
    }
}

BOOST_AUTO_TEST_CASE(hdr_against_whole_squares_of_weights)
{
    const auto a = test_picture(20, 18, 1, 40), b = test_picture(20, 18, 2, 30);
    FlipSettings settings;
    settings.exposures = FlipExposures{-5.2, 1.1, 3};
    const auto flip = flip_of_pictures(a, b, settings, 5);
    BOOST_TEST(distance_of(flip.map,
                           flip_oracle::hdr_map_of(a, b, flip_default_ppd, -5.2L, 1.1L, 3)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(exposures_from_the_median_and_the_greatest_luminance)
{
    FlipExposureMeter meter;
    for (const float luminance : {0.5f, 2.0f, 64.0f, 2.0f, 0.1f})
        meter.add(luminance);
    const FlipExposures e = meter.exposures();
    BOOST_TEST(e.stop - e.start == 5, boost::test_tools::tolerance(1e-4)); // log2(64 / 2)
    BOOST_TEST((e.count == 5 || e.count == 6)); // 5 stops, up to the rounding of the median
    BOOST_TEST(e.at(0) == e.start);
    BOOST_TEST(e.at(e.count - 1) == e.stop, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(double(flip_oracle::aces(64 * std::exp2(flip_oracle::Real(e.start)))) == 0.85,
               boost::test_tools::tolerance(1e-6));
    float mapped = 0;
    const float light = 64;
    tone_map(&mapped, &light, float(std::exp2(e.start)), 1);
    BOOST_TEST(mapped == 0.85f, boost::test_tools::tolerance(1e-6f));
}

BOOST_AUTO_TEST_CASE(exposures_of_dark_pictures)
{
    FlipExposureMeter black;
    black.add(0);
    black.add(NAN);
    BOOST_TEST(black.exposures().count == 1);
    BOOST_TEST(black.exposures().start == 0);
    // Two of five are black: they count for the median.
    FlipExposureMeter partly;
    for (const float luminance : {0.0f, 0.0f, 0.5f, 8.0f, 64.0f})
        partly.add(luminance);
    BOOST_TEST(partly.exposures().stop - partly.exposures().start == 7,
               boost::test_tools::tolerance(1e-4));
    // More than half is black: the median of the other pixels counts.
    FlipExposureMeter mostly;
    for (const float luminance : {0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 4.0f, 16.0f})
        mostly.add(luminance);
    BOOST_TEST(mostly.exposures().stop - mostly.exposures().start == 2,
               boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(infinite_light_is_shown_white)
{
    float mapped[4];
    const float light[4] = {INFINITY, 3e38f, NAN, -1};
    tone_map(mapped, light, 1e3f, 4);
    BOOST_TEST(mapped[0] == 1);
    BOOST_TEST(mapped[1] == 1);
    BOOST_TEST(mapped[2] == 0);
    BOOST_TEST(mapped[3] == 0);
}

BOOST_AUTO_TEST_CASE(quartiles_are_weighted_by_the_values)
{
    // Two very different halves: left black and white (0.967), right greys of L* 50 and 60 (0.288).
    auto a = flat(200, 20, {0, 0, 0}), b = flat(200, 20, {1, 1, 1});
    const auto grey = [](double l) { return flip_oracle::Real(std::pow((l + 16) / 116, 3)); };
    for (int y = 0; y < 20; ++y)
        for (int x = 100; x < 200; ++x) {
            a.pixels[std::size_t(y) * 200 + x] = {grey(50), grey(50), grey(50)};
            b.pixels[std::size_t(y) * 200 + x] = {grey(60), grey(60), grey(60)};
        }
    const auto flip = flip_of_pictures(a, b, {}, 20);
    // The right half has a quarter of the sum: 0.288 / (0.288 + 0.967) = 0.23.
    BOOST_TEST(flip.figures.quartiles[0] > 0.9);
    BOOST_TEST(flip.figures.quartiles[2] < 0.98);
    // Without weights the first quartile would be 0.288.
    BOOST_TEST(flip.map[199] == 0.2884f, boost::test_tools::tolerance(1e-3f));
}

BOOST_AUTO_TEST_CASE(pixels_per_degree_of_a_frame)
{
    // 0.1 mm at 573 mm is 0.01 degrees.
    FrameMetadata m;
    m.film = {100, 100, {0.1, 0.1}, Subpixels::none};
    m.aperture.distance = 0.05 / std::tan(0.005 * 3.14159265358979 / 180);
    BOOST_TEST(pixels_per_degree(m) == 100, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
