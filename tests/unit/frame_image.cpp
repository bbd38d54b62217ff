// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests pictures in memory, and the parallel loop over rows.
#include "integral/base/parallel.h"
#include "integral/frame/linear_writer.h"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <cmath>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(frame_image)

namespace {

const Encoding linear{Encoding::Kind::linear, 1}, srgb, power{Encoding::Kind::power, 2.2};

} // namespace

BOOST_AUTO_TEST_CASE(encodings)
{
    // IEC 61966-2-1: at the break, and at 0.5.
    BOOST_TEST(decode(srgb, 0.04045) == 0.04045 / 12.92);
    BOOST_TEST(decode(srgb, 0.5) == 0.2140411405, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(encode(srgb, 0.2140411405) == 0.5, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(decode(power, 0.5) == 0.2176376408, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(decode(linear, -3.5) == -3.5);
    for (const Encoding e : {linear, srgb, power})
        for (double v = -2; v <= 2; v += 1.0 / 64)
            BOOST_TEST(std::abs(encode(e, decode(e, v)) - v) < 1e-7); // sRGB's pieces meet to 1e-8
    BOOST_CHECK(same_encoding(linear, {Encoding::Kind::linear, 2}));
    BOOST_CHECK(!same_encoding(power, {Encoding::Kind::power, 1.8}));
}

BOOST_AUTO_TEST_CASE(light_and_back_keeps_every_integer)
{
    for (const Encoding e : {linear, srgb, power}) {
        Image eight = make_image<std::uint8_t>(256, 1, 3, e), same = eight;
        auto& bytes = std::get<std::vector<std::uint8_t>>(eight.samples);
        for (int i = 0; i < 256; ++i)
            bytes[3 * i] = bytes[3 * i + 1] = bytes[3 * i + 2] = std::uint8_t(i);
        const LinearReader read(eight);
        for (int x = 0; x < 256; ++x)
            store_linear(same, x, 0, read(x, 0));
        BOOST_CHECK(same.samples == eight.samples);

        Image sixteen = make_image<std::uint16_t>(65536, 1, 3, e), again = sixteen;
        auto& words = std::get<std::vector<std::uint16_t>>(sixteen.samples);
        for (int i = 0; i < 65536; ++i)
            words[3 * i] = std::uint16_t(i);
        const LinearReader read16(sixteen);
        for (int x = 0; x < 65536; ++x)
            store_linear(again, x, 0, read16(x, 0));
        BOOST_CHECK(again.samples == sixteen.samples);
    }
}

BOOST_AUTO_TEST_CASE(alpha_is_taken_into_account_in_linear_light)
{
    Image image = make_image<float>(1, 1, 4, power);
    store_pixel(image, 0, 0, {0.5f, 1, 0, 0.25f});
    const Colour light = LinearReader(image)(0, 0);
    BOOST_TEST(light.r == 0.25f * 0.2176376408f, boost::test_tools::tolerance(1e-6f));
    BOOST_TEST(light.g == 0.25f);
    BOOST_TEST(light.a == 0.25f);

    const Image multiplied = converted(image, 32, linear, true);
    BOOST_TEST(stored_pixel(multiplied, 0, 0).g == 0.25f);
    const Image back = converted(multiplied, 32, power, false);
    BOOST_TEST(stored_pixel(back, 0, 0).r == 0.5f, boost::test_tools::tolerance(1e-6f));
    BOOST_TEST(stored_pixel(back, 0, 0).a == 0.25f);
}

BOOST_AUTO_TEST_CASE(stored_values_are_rounded_and_cut)
{
    Image image = make_image<std::uint8_t>(2, 1, 3, srgb);
    store_pixel(image, 0, 0, {-1, 2, std::numeric_limits<float>::quiet_NaN(), 1});
    store_pixel(image, 1, 0, {0.5f, 254.4f / 255, 254.6f / 255, 1});
    const std::vector<std::uint8_t> expected = {0, 255, 0, 128, 254, 255};
    BOOST_CHECK(std::get<std::vector<std::uint8_t>>(image.samples) == expected);
    BOOST_TEST(sample_bits(image) == 8);
    BOOST_TEST(sample_bits(converted(image, 16, srgb, false)) == 16);
    BOOST_TEST(stored_pixel(converted(image, 16, srgb, false), 1, 0).r == 128 / 255.0f);
}

BOOST_AUTO_TEST_CASE(every_row_is_done_once)
{
    for (const int threads : {0, 1, 3, 64}) {
        std::vector<std::atomic<int>> times(100);
        int last = 0;
        BOOST_CHECK(for_each_row(
            100, threads, [&](int row) { ++times[std::size_t(row)]; },
            [&](int done, int total) {
                BOOST_TEST(done == ++last);
                return total == 100;
            }));
        BOOST_TEST(last == 100);
        for (const auto& count : times)
            BOOST_TEST(count == 1);
    }
    BOOST_CHECK(for_each_row(0, 4, [](int) { throw std::logic_error("no row"); }));
}

BOOST_AUTO_TEST_CASE(a_writer_stores_what_store_linear_stores)
{
    std::vector<float> lights{-1, 0, 1, 2, NAN, INFINITY};
    for (int k = 0; k < 200000; ++k)
        lights.push_back(std::ldexp(float(k % 1000) / 1000, -(k / 1000) / 6));
    for (const Encoding e :
         {linear, srgb, power, {Encoding::Kind::power, 0.2}, {Encoding::Kind::power, 90}})
        for (int sample = 0; sample < 255; ++sample) { // beside the border of two samples
            const float border = float(decode(e, (sample + 0.5) / 255));
            for (const float light :
                 {std::nextafter(border, 0.0f), border, std::nextafter(border, 2.0f)})
                lights.push_back(light);
        }
    for (const Encoding e :
         {linear, srgb, power, {Encoding::Kind::power, 0.2}, {Encoding::Kind::power, 90}})
        for (const int channels : {3, 4}) {
            Image stored = make_image<std::uint8_t>(int(lights.size()), 1, channels, e),
                  written = stored;
            const LinearWriter write(written);
            for (std::size_t k = 0; k < lights.size(); ++k) {
                const Colour light{lights[k], 0.5f * lights[k], lights[lights.size() - 1 - k],
                                   0.7f};
                store_linear(stored, int(k), 0, light);
                write(int(k), 0, light);
            }
            BOOST_CHECK(stored.samples == written.samples);
        }
}

BOOST_AUTO_TEST_CASE(work_stops_when_told_or_broken)
{
    std::atomic<int> rows{0};
    BOOST_CHECK(!for_each_row(
        1000000, 4, [&](int) { ++rows; }, [](int done, int) { return done < 10; }));
    BOOST_TEST(rows < 1000);
    BOOST_CHECK_THROW(for_each_row(100, 4,
                                   [](int row) {
                                       if (row == 50)
                                           throw std::range_error("row 50");
                                   }),
                      std::range_error);
}

BOOST_AUTO_TEST_SUITE_END()
