// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the fit of a scene's depths to a budget against the map of optics.md section 8 in 100-digit
// arithmetic, at random depths and budgets.
#include "integral/sheet/scene_fit.h"

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace integral;
using Exact = boost::multiprecision::cpp_dec_float_100;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Random {
    std::mt19937_64 bits{5};
    double about(double low, double high)
    {
        return std::exp(
            std::uniform_real_distribution<double>(std::log(low), std::log(high))(bits));
    }
};

/// z'/d of a distance from the eye plane, with D = d0 k: K (r - D) / (K D + (1 - K) r).
double exact_depth(const SceneFit& fit, double distance)
{
    const Exact k = fit.parallax, sheet = fit.sheet_distance;
    if (distance == infinity)
        return double(k / (1 - k));
    return double(k * (distance - sheet) / (k * sheet + (1 - k) * distance));
}

bool is_near(double a, double b) { return std::fabs(a - b) <= 1e-11 * std::fabs(b); }

} // namespace

BOOST_AUTO_TEST_SUITE(sheet_scene_fit)

BOOST_AUTO_TEST_CASE(both_ends_are_at_the_ends_of_the_budget)
{
    Random random;
    int deep = 0, shallow = 0;
    for (int k = 0; k < 10000; ++k) {
        const double near = random.about(1e-6, 1e6),
                     far = k % 10 == 0 ? infinity : near * (1 + random.about(1e-3, 1e6)),
                     beta = random.about(1e-3, 0.8);
        const SceneFit fit = fit_to_budget({near, far}, {beta, {}, {}});
        BOOST_TEST_CONTEXT("near " << near << " far " << far << " beta " << beta)
        if (fit.parallax < 1) {
            ++deep;
            BOOST_TEST(is_near(exact_depth(fit, near), -beta));
            BOOST_TEST(is_near(exact_depth(fit, far), beta));
        } else {
            ++shallow;
            BOOST_TEST(fit.parallax == 1);
            BOOST_TEST(exact_depth(fit, near) >= -beta);
            BOOST_TEST(exact_depth(fit, far) <= beta);
            BOOST_TEST(is_near(exact_depth(fit, near), -exact_depth(fit, far)));
        }
    }
    BOOST_TEST(deep > 1000);
    BOOST_TEST(shallow > 1000);
}

BOOST_AUTO_TEST_CASE(a_given_sheet_gets_the_greatest_parallax_that_keeps_both_ends_within)
{
    Random random;
    for (int k = 0; k < 10000; ++k) {
        const double near = random.about(1e-3, 1e3),
                     far = k % 10 == 0 ? infinity : near * random.about(1, 1e4),
                     sheet = near * random.about(0.1, 1e3), beta = random.about(1e-3, 0.8);
        const SceneFit fit = fit_to_budget({near, far}, {beta, sheet, {}});
        BOOST_TEST_CONTEXT("near " << near << " far " << far << " sheet " << sheet)
        {
            BOOST_TEST(fit.sheet_distance == sheet);
            BOOST_TEST(exact_depth(fit, near) >= -beta * (1 + 1e-12));
            BOOST_TEST(exact_depth(fit, far) <= beta * (1 + 1e-12));
            if (fit.parallax < 1)
                BOOST_TEST((is_near(exact_depth(fit, near), -beta) ||
                            is_near(exact_depth(fit, far), beta)));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_given_parallax_gets_the_sheet_from_which_both_ends_are_equally_far)
{
    Random random;
    for (int k = 0; k < 10000; ++k) {
        const double near = random.about(1e-3, 1e3), far = near * random.about(1.001, 1e4),
                     parallax = random.about(1e-3, k % 2 == 0 ? 1 : 100);
        const SceneFit fit = fit_to_budget({near, far}, {0.1, {}, parallax});
        BOOST_TEST_CONTEXT("near " << near << " far " << far << " parallax " << parallax)
        {
            BOOST_TEST(fit.parallax == parallax);
            BOOST_TEST(exact_depth(fit, near) < 0);
            BOOST_TEST(is_near(exact_depth(fit, near), -exact_depth(fit, far)));
        }
    }
    const SceneFit sky = fit_to_budget({3, infinity}, {0.1, {}, 0.25});
    BOOST_TEST(is_near(exact_depth(sky, 3), -exact_depth(sky, infinity)));
    // Infinity is at 0.6/0.4 of the viewing distance at least: only the near end is kept within.
    const SceneFit far = fit_to_budget({3, infinity}, {0.1, {}, 0.6});
    BOOST_TEST(is_near(exact_depth(far, 3), -0.1));
}

BOOST_AUTO_TEST_CASE(a_parallax_over_1_puts_what_is_far_beyond_infinity)
{
    // With K = 3 and a sheet at 10, infinity is seen at K D/(K - 1) = 15.
    const SceneFit fit{10, 3};
    BOOST_TEST(is_near(seen_depth(fit, 14), 3.0 * 4 / (30 - 28)));
    for (const double distance : {15.0, 16.0, 1e9, infinity})
        BOOST_TEST(seen_depth(fit, distance) == infinity);
    BOOST_TEST(part_within(fit, {10, 14, 16, infinity}, 1e6) == 0.5);
    // The near end of a scene before the sky is kept within the budget.
    const SceneFit sky = fit_to_budget({3, infinity}, {0.1, {}, 3});
    BOOST_TEST(sky.parallax == 3);
    BOOST_TEST(is_near(exact_depth(sky, 3), -0.1));
}

BOOST_AUTO_TEST_CASE(one_depth_is_put_on_the_sheet)
{
    const SceneFit fit = fit_to_budget({7, 7}, {0.05, {}, {}});
    BOOST_TEST(fit.sheet_distance == 7);
    BOOST_TEST(fit.parallax == 1);
}

BOOST_AUTO_TEST_CASE(ends_are_the_twentieths_of_the_picture)
{
    std::vector<double> distances;
    for (int k = 100; k >= 0; --k)
        distances.push_back(10 + k);
    BOOST_TEST(depth_ends(distances)->near == 15);
    BOOST_TEST(depth_ends(distances)->far == 105);
    for (int k = 0; k < 10; ++k)
        distances.push_back(infinity);
    BOOST_TEST(depth_ends(distances)->far == infinity);
    BOOST_TEST(!depth_ends({}).has_value());
    BOOST_TEST(!depth_ends({infinity, infinity}).has_value());
    // In front of the sky, the fit uses even a small object.
    distances.assign(100, infinity);
    distances[3] = 8;
    distances[4] = 6;
    BOOST_TEST(depth_ends(distances)->near == 6);
}

BOOST_AUTO_TEST_CASE(nine_tenths_of_the_picture_are_within_after_the_fit)
{
    Random random;
    std::vector<double> distances;
    for (int k = 0; k < 2000; ++k)
        distances.push_back(random.about(2, 900));
    const double beta = 0.05;
    const SceneFit fit = fit_to_budget(*depth_ends(distances), {beta, {}, {}});
    const double within = part_within(fit, distances, beta);
    BOOST_TEST(within >= 0.899);
    BOOST_TEST(within < 0.905);
    BOOST_TEST(part_within({30, 1}, distances, beta) < 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
