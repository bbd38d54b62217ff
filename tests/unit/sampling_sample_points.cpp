// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests sample points: they are well distributed, differ between seeds, and SumSplit's sums are
// well distributed.
#include "integral/base/tabulated_curve.h"
#include "integral/sampling/sample_points.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace integral;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

int part(double x, int parts) { return std::min(parts - 1, int(x * parts)); }

/// Checks that each coordinate of `count` points falls once into each of as many equal parts, and
/// the first two together once into each of as many squares.
template <class PointAt> void check_net(int count, const PointAt& point_at)
{
    const int side = int(std::sqrt(count));
    std::vector<int> alone(point_dimensions * count), together(count);
    for (int index = 0; index < count; ++index) {
        const UnitPoint point = point_at(index);
        for (int k = 0; k < point_dimensions; ++k) {
            BOOST_TEST_REQUIRE((point[k] > 0 && point[k] < 1));
            ++alone[k * count + part(point[k], count)];
        }
        ++together[part(point[0], side) * side + part(point[1], side)];
    }
    BOOST_TEST((std::count(alone.begin(), alone.end(), 1) == point_dimensions * count), count);
    BOOST_TEST((std::count(together.begin(), together.end(), 1) == count), count);
}

} // namespace

BOOST_AUTO_TEST_SUITE(sampling_sample_points)

BOOST_AUTO_TEST_CASE(points_are_a_digital_net)
{
    for (const std::uint64_t key : {0ull, 1ull, 12345ull, ~0ull})
        for (const int count : {4, 16, 64, 256, 1024}) // beyond 256 they are not from a table
            for (const std::uint32_t start : {0, 1, 5})
                check_net(count, [&](std::uint32_t k) {
                    return scrambled_point(point_seeds(key), start * count + k);
                });
}

BOOST_AUTO_TEST_CASE(shifted_points_begin_where_they_are_asked_to_and_are_a_net)
{
    for (const UnitPoint first : {UnitPoint{0.1, 0.9, 0.5, 0.3}, UnitPoint{0, 1, 0.25, 1e-12}}) {
        const ShiftedPoints points(point_seeds(7), first);
        for (int k = 0; k < point_dimensions; ++k)
            BOOST_TEST(std::fabs(points(0)[k] - first[k]) <= 0x1p-32);
        for (const int count : {4, 16, 64})
            check_net(count, points);
    }
}

BOOST_AUTO_TEST_CASE(a_curve_fills_one_square_after_the_other)
{
    std::vector<int> places(curve_side * curve_side);
    for (std::uint32_t y = 0; y < curve_side; ++y)
        for (std::uint32_t x = 0; x < curve_side; ++x) {
            const std::uint32_t place = place_on_curve(x, y);
            ++places.at(place);
            for (const std::uint32_t side : {2u, 4u, 8u})
                BOOST_TEST(place / (side * side) ==
                           place_on_curve(x / side * side, y / side * side) / (side * side));
        }
    BOOST_TEST((std::count(places.begin(), places.end(), 1) == curve_side * curve_side));
}

BOOST_AUTO_TEST_CASE(shuffled_indices_fill_the_same_runs)
{
    // Each run of 2^k indices goes to a run of 2^k, and the first index goes to all places equally
    // often.
    std::vector<int> places(16);
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        const std::uint32_t key = std::uint32_t(random_bits(seed, 1));
        ++places[shuffled_index(key, 0x300) % 16];
        for (const std::uint32_t run : {4u, 16u, 256u}) {
            std::vector<int> taken(run);
            const std::uint32_t begin = 0x200 + (seed % (256 / run)) * run,
                                moved = shuffled_index(key, begin) / run;
            for (std::uint32_t k = 0; k < run; ++k) {
                const std::uint32_t at = shuffled_index(key, begin + k);
                BOOST_TEST_REQUIRE(at / run == moved);
                BOOST_TEST_REQUIRE(at / 256 == 2);
                ++taken[at % run];
            }
            BOOST_TEST_REQUIRE(std::count(taken.begin(), taken.end(), 1) == run);
        }
    }
    for (const int number : places)
        BOOST_TEST(std::abs(number - 250) < 80); // five standard deviations
}

BOOST_AUTO_TEST_CASE(scramblings_are_uniform_and_independent)
{
    // Over many scramblings, the first point is evenly distributed; so are pairs of the first
    // points of two scramblings, and pairs of coordinates of one point.
    constexpr int keys = 40000, parts = 10;
    std::vector<int> keys_apart(parts * parts), dimensions_apart(parts * parts);
    for (int key = 0; key < keys; ++key) {
        const auto one = scrambled_point(point_seeds(key), 0),
                   next = scrambled_point(point_seeds(key + 1), 0);
        ++keys_apart[part(one[0], parts) * parts + part(next[0], parts)];
        ++dimensions_apart[part(one[1], parts) * parts + part(one[2], parts)];
    }
    for (const auto& counts : {keys_apart, dimensions_apart}) {
        double chi_square = 0;
        for (const int count : counts)
            chi_square += std::pow(count - keys / 100.0, 2) / (keys / 100.0);
        BOOST_TEST(chi_square < 99 + 5 * std::sqrt(2 * 99.0));
        BOOST_TEST(chi_square > 99 - 5 * std::sqrt(2 * 99.0));
    }
}

BOOST_AUTO_TEST_CASE(means_have_the_error_of_owen_s_scrambling)
{
    // The variance of the mean of x + y + z + w over n = 256 scrambled points is at most that with
    // points jittered in each coordinate's n parts, n^-3/12 each.
    constexpr int n = 256, keys = 2000;
    double squares = 0;
    for (int key = 0; key < keys; ++key) {
        double sum = 0;
        for (int k = 0; k < n; ++k)
            for (const double x : scrambled_point(point_seeds(key), k))
                sum += x - 0.5;
        squares += sum / n * (sum / n);
    }
    const double jittered = point_dimensions / (12.0 * n * n * n);
    BOOST_TEST(squares / keys < 1.2 * jittered);
    BOOST_TEST(squares / keys > 0.8 * jittered); // and not much less: lower bits are random
}

BOOST_AUTO_TEST_CASE(a_split_sum_preserves_area)
{
    constexpr int fine = 600, coarse = 10;
    for (const double ratio :
         {0.0, 0.1, -0.5, 1.0, -1.0, 3.0, -20.0, infinity, -infinity, 1e-300, 1e300}) {
        const SumSplit split(ratio);
        std::vector<double> density(coarse * coarse);
        for (int i = 0; i < fine; ++i)
            for (int j = 0; j < fine; ++j) {
                const auto at = split((i + 0.5) / fine, (j + 0.5) / fine);
                BOOST_TEST_REQUIRE(
                    (at.first >= 0 && at.first <= 1 && at.second >= 0 && at.second <= 1));
                density[part(at.first, coarse) * coarse + part(at.second, coarse)] += double(
                                                                                          coarse *
                                                                                          coarse) /
                                                                                      (fine * fine);
            }
        for (const double d : density)
            BOOST_TEST(std::fabs(d - 1) < 0.04, "ratio " << ratio << ": " << d);
    }
}

BOOST_AUTO_TEST_CASE(a_split_sum_follows_from_the_first_coordinate)
{
    for (const double ratio : {0.0, 0.1, -0.5, 1.0, -1.0, 3.0, -20.0, infinity, -infinity}) {
        const SumSplit split(ratio);
        const auto sum = [&](double u, double v) {
            const auto at = split(u, v);
            return std::isinf(ratio) ? at.second - 0.5 : at.first - 0.5 + ratio * (at.second - 0.5);
        };
        const double sense = sum(0.9, 0.5) > sum(0.1, 0.5) ? 1 : -1,
                     size = std::isinf(ratio) ? 1 : 1 + std::fabs(ratio);
        for (double u = 0.001; u < 0.999; u += 0.001) {
            BOOST_TEST(sense * (sum(u + 0.001, 0.5) - sum(u, 0.5)) > 0);
            for (const double v : {0.0, 0.001, 0.3, 0.999})
                BOOST_TEST(std::fabs(sum(u, v) - sum(u, 0.5)) < 1e-14 * size);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_split_sum_has_an_inverse)
{
    for (const double ratio :
         {0.0, 1e-300, 0.1, -0.5, 1.0, -1.0, 3.0, -20.0, 1e300, infinity, -infinity}) {
        const SumSplit split(ratio);
        for (double u = 0.01; u < 1; u += 0.01)
            for (double v = 0.005; v < 1; v += 0.01) {
                const auto back = split.inverse(split(u, v));
                BOOST_TEST_REQUIRE(std::fabs(back.first - u) < 1e-10, ratio << ": " << u);
                // A ratio like 1e-300 leaves nothing of v in the sum.
                if (const double size = std::fabs(ratio);
                    size == 0 || std::isinf(size) || (size > 1e-9 && size < 1e9))
                    BOOST_TEST_REQUIRE(std::fabs(back.second - v) < 1e-10, ratio << ": " << v);
            }
        for (const double x : {0.0, 0.5, 1.0})
            for (const double y : {0.0, 0.5, 1.0}) {
                const auto at = split.inverse({x, y});
                BOOST_TEST((at.first >= 0 && at.first <= 1 && at.second >= 0 && at.second <= 1));
            }
    }
}

BOOST_AUTO_TEST_CASE(a_tabulated_curve_is_the_curve)
{
    for (const double power : {1.0, 1 / 1.8, 1 / 2.2, 1 / 2.6}) {
        const auto curve = [&](float x) { return std::pow(double(x), power); };
        const TabulatedCurve tabulated(curve);
        for (double x = 0x1p-20; x < 128; x *= 1.00037)
            BOOST_TEST(std::fabs(tabulated(float(x)) / curve(float(x)) - 1) < 2e-6);
        BOOST_TEST(tabulated(0) == 0);
        BOOST_TEST(tabulated(-1) == 0);
        BOOST_TEST(tabulated(std::numeric_limits<float>::quiet_NaN()) == 0);
        BOOST_TEST(std::fabs(tabulated(0x1p-21f) - 0.5 * curve(0x1p-20f)) < 1e-9);
        BOOST_TEST(std::fabs(tabulated(1e30f) / curve(128) - 1) < 1e-6);
        BOOST_TEST(std::fabs(tabulated(std::numeric_limits<float>::infinity()) / curve(128) - 1) <
                   1e-6);
    }
}

BOOST_AUTO_TEST_SUITE_END()
