// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the storage of light, and the error estimated from the halves of a pixel's samples.
#include "integral/frame/linear_colour.h"
#include "integral/reconstruction/split_half_error.h"

#include <boost/test/unit_test.hpp>
#include <random>

using namespace integral;

namespace {

LinearColour grey_light(double grey) { return {float(grey), float(grey), float(grey), 0}; }

} // namespace

BOOST_AUTO_TEST_SUITE(frame_linear_colour)

BOOST_AUTO_TEST_CASE(light_is_stored)
{
    for (float value : {0.0f, 0.001f, 0.02f, 0.5f, 1.0f, 7.3f, 60.0f}) {
        const StoredLight stored({value, -value, 2 * value / 3, 1});
        BOOST_TEST(std::fabs(stored.light()[0] - value) < 0.0002 * (1 + value));
        BOOST_TEST(stored.light()[1] == -stored.light()[0]);
        BOOST_TEST(std::fabs(stored.light()[3] - 1) < 0.0002);
        BOOST_TEST(StoredLight::holds({value, -value, 2 * value / 3, 1}));
    }
    BOOST_TEST(!StoredLight::holds({65, 0, 0, 0}));
    BOOST_TEST(!StoredLight::holds({0, -65, 0, 0}));
    BOOST_TEST(!StoredLight::holds({INFINITY, 0, 0, 0}));
    BOOST_TEST(!StoredLight::holds({NAN, 0, 0, 0}));
    BOOST_TEST(StoredLight({NAN, 0, 0, 0}).light()[0] == 0);
}

BOOST_AUTO_TEST_CASE(halves_of_the_samples_show_their_error)
{
    const TabulatedCurve as_it_is([](float x) { return x; });
    SplitHalfError samples_of_four;
    for (const double grey : {0.1, 0.3, 0.2, 0.6}) { // halves: means 0.2 and 0.4, error 0.1
        if (grey <= 0.1)
            BOOST_TEST(samples_of_four.squared_error(as_it_is) == -1);
        samples_of_four.add(grey_light(grey));
    }
    BOOST_TEST(std::abs(samples_of_four.squared_error(as_it_is) - 3 * 0.1 * 0.1) < 1e-6);
    BOOST_TEST(std::abs(samples_of_four.squared_deviations() - 3 * 0.14) < 1e-6); // from mean 0.3
    // On average over random samples, it is the squared error of their mean.
    std::mt19937 random(3);
    double sum = 0;
    constexpr int runs = 20000, samples = 16;
    for (int k = 0; k < runs; ++k) {
        SplitHalfError one;
        for (int n = 0; n < samples; ++n)
            one.add(grey_light(random() & 1));
        sum += one.squared_error(as_it_is);
    }
    const double truth = 3 * 0.25 / samples;
    BOOST_TEST(std::abs(sum / runs - truth) < 0.05 * truth);
}

BOOST_AUTO_TEST_CASE(halves_begin_at_powers_of_two_whatever_was_tried)
{
    // Eight samples; the fifth belongs to another lens: halves of four and of three.
    const TabulatedCurve as_it_is([](float x) { return x; });
    SplitHalfError samples;
    for (int k = 0; k < 8; ++k) {
        if (k == 4)
            samples.add_none();
        else
            samples.add(grey_light(k < 4 ? 0.2 : 0.6));
    }
    const double difference = 0.4, parts = 4.0 / 7 * 3 / 7;
    BOOST_TEST(std::abs(samples.squared_error(as_it_is) - 3 * difference * difference * parts) <
               1e-6);
}

BOOST_AUTO_TEST_CASE(halves_show_that_a_rare_highlight_is_encoded_after_averaging)
{
    // One sample in 100 meets a light of 4, the others meet 0.01; 8 samples a pixel. The error of
    // encoded means is 7 times the error predicted from encoded samples.
    const auto root = [](double x) { return std::sqrt(x); };
    const TabulatedCurve encode([&](float x) { return float(root(x)); });
    std::mt19937 random(5);
    constexpr int runs = 40000, samples = 8;
    constexpr double part = 0.01, bright = 4, dark = 0.01;
    const double right = root(part * bright + (1 - part) * dark);
    double seen = 0, error = 0, of_encoded_samples = 0;
    for (int k = 0; k < runs; ++k) {
        SplitHalfError one;
        double mean = 0, encoded = 0, squares = 0;
        for (int n = 0; n < samples; ++n) {
            const double light = random() % 100 == 0 ? bright : dark;
            one.add(grey_light(light));
            mean += light / samples;
            encoded += root(light) / samples;
            squares += light / samples;
        }
        seen += one.squared_error(encode) / 3;
        error += (root(mean) - right) * (root(mean) - right);
        of_encoded_samples += (squares - encoded * encoded) / (samples - 1);
    }
    BOOST_TEST_MESSAGE("error " << error / runs << ", seen " << seen / runs
                                << ", by encoded samples " << of_encoded_samples / runs);
    BOOST_TEST(seen > 0.4 * error);
    BOOST_TEST(seen < 1.2 * error);
    BOOST_TEST(of_encoded_samples < 0.4 * error);
}

BOOST_AUTO_TEST_SUITE_END()
