// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks the figures of comparisons against values worked out by hand.
#include "integral/compare/compare.h"
#include "integral/compare/compare_limits.h"
#include "integral/compare/similarity.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(compare_pictures)

namespace {

const Encoding linear{Encoding::Kind::linear, 1};
const auto exactly = boost::test_tools::tolerance(1e-6);

Frame flat(int width, int height, int channels, float grey)
{
    Frame frame{make_image<float>(width, height, channels, linear), {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            store_pixel(frame.image, x, y, {grey, grey, grey, 1});
    return frame;
}

} // namespace

BOOST_AUTO_TEST_CASE(equal_pictures)
{
    const Frame a = flat(20, 15, 3, 0.5f);
    const Comparison c = compare(a, a);
    BOOST_TEST(c.rmse == 0);
    BOOST_TEST(std::isinf(c.psnr));
    BOOST_TEST(c.ssim == 1);
    BOOST_TEST(c.largest_difference == 0);
    BOOST_TEST(c.within_two == 1);
    BOOST_CHECK(!c.worst);
}

BOOST_AUTO_TEST_CASE(a_constant_difference)
{
    // |0.75 - 0.5|: RMSE 0.25, PSNR 20 log10 4 = 12.0412 dB; without variance SSIM is
    // (2 a b + C1)/(a^2 + b^2 + C1), C1 = 1e-4.
    const Comparison c = compare(flat(20, 15, 3, 0.75f), flat(20, 15, 3, 0.5f));
    BOOST_TEST(c.rmse == 0.25, exactly);
    BOOST_TEST(c.psnr == 12.041199827, exactly);
    BOOST_TEST(c.ssim == (0.75 + 1e-4) / (0.8125 + 1e-4), exactly);
    BOOST_TEST(c.largest_difference == 0.25, exactly);
    BOOST_TEST(c.within_two == 0);
}

BOOST_AUTO_TEST_CASE(one_pixel)
{
    // One channel of one of 100 pixels differs by 0.6: RMSE sqrt(0.36/300).
    const Frame a = flat(10, 10, 3, 0.2f);
    Frame b = a;
    store_pixel(b.image, 3, 4, {0.2f, 0.8f, 0.2f, 1});
    const Comparison c = compare(a, b);
    BOOST_TEST(c.rmse == std::sqrt(0.36 / 300), exactly);
    BOOST_TEST(c.largest_difference == 0.6, exactly);
    BOOST_TEST(c.within_two == 0.99, exactly);
}

BOOST_AUTO_TEST_CASE(within_two_of_255)
{
    Frame a{make_image<std::uint8_t>(3, 1, 3, {}), {}}, b = a;
    for (int x = 0; x < 3; ++x)
        store_pixel(b.image, x, 0, {float(x + 1) / 255, 0, 0, 1});
    BOOST_TEST(compare(a, b).within_two == 2.0 / 3, exactly);
}

BOOST_AUTO_TEST_CASE(alpha)
{
    // White of alpha 1/4 over black is 1/4 in linear light; alpha itself counts if both have it.
    Frame a = flat(1, 1, 4, 1), b = flat(1, 1, 4, 0.25f), opaque = flat(1, 1, 3, 0.25f);
    store_pixel(a.image, 0, 0, {1, 1, 1, 0.25f});
    BOOST_TEST(compare(a, opaque).rmse == 0, exactly);
    BOOST_TEST(compare(a, b).rmse == std::sqrt(0.75 * 0.75 / 4), exactly);
    Frame multiplied = a;
    multiplied.image = converted(a.image, 32, linear, true);
    BOOST_TEST(compare(a, multiplied).rmse == 0, exactly);
}

BOOST_AUTO_TEST_CASE(encodings)
{
    // Linear 0.2140411 is sRGB 0.5; the figures are computed in the non-linear encoding.
    Frame coded = flat(4, 4, 3, 0.75f);
    coded.image.encoding = {};
    for (const bool swapped : {false, true}) {
        const Frame light = flat(4, 4, 3, 0.2140411405f);
        const Comparison c = swapped ? compare(light, coded) : compare(coded, light);
        BOOST_TEST(c.rmse == 0.25, exactly);
        BOOST_CHECK(c.encoding.kind == Encoding::Kind::srgb);
    }
}

BOOST_AUTO_TEST_CASE(sizes_must_agree)
{
    BOOST_CHECK_THROW(compare(flat(3, 4, 3, 0), flat(4, 3, 3, 0)), std::invalid_argument);
    BOOST_CHECK_THROW(difference_picture(flat(3, 4, 3, 0).image, flat(4, 3, 3, 0).image),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(equal_nan_and_infinity_are_equal)
{
    Frame a = flat(4, 4, 3, 0.5f);
    store_pixel(a.image, 1, 1, {std::nanf(""), 0.5f, 0.5f, 1});
    store_pixel(a.image, 2, 3, {HUGE_VALF, -HUGE_VALF, 0.5f, 1});
    const Comparison c = compare(a, a);
    BOOST_TEST(c.rmse == 0);
    BOOST_TEST(std::isinf(c.psnr));
    BOOST_TEST(c.ssim == 1);
    BOOST_TEST(c.largest_difference == 0);
    BOOST_TEST(c.within_two == 1);
    BOOST_TEST(c.not_finite.equal == 2);
    BOOST_TEST(c.not_finite.unequal == 0);
}

BOOST_AUTO_TEST_CASE(unequal_nan_and_infinity_are_counted_and_left_out)
{
    Frame a = flat(4, 4, 3, 0.5f), b = flat(4, 4, 3, 0.25f);
    store_pixel(a.image, 2, 1, {std::nanf(""), 0.5f, 0.5f, 1}); // in one picture only
    store_pixel(a.image, 1, 2, {HUGE_VALF, 0.5f, 0.5f, 1});     // infinities of opposite sign
    store_pixel(b.image, 1, 2, {-HUGE_VALF, 0.25f, 0.25f, 1});
    store_pixel(a.image, 3, 3, {std::nanf(""), 0.5f, 0.5f, 1}); // NaN against infinity
    store_pixel(b.image, 3, 3, {HUGE_VALF, 0.25f, 0.25f, 1});
    const Comparison c = compare(a, b);
    BOOST_TEST(c.rmse == 0.25, exactly); // over the other 45 channels
    BOOST_TEST(c.largest_difference == 0.25, exactly);
    BOOST_TEST(std::isfinite(c.ssim));
    BOOST_TEST(c.not_finite.equal == 0);
    BOOST_TEST(c.not_finite.unequal == 3);
    BOOST_TEST(c.not_finite.x == 2);
    BOOST_TEST(c.not_finite.y == 1);
    const auto difference = difference_picture(a.image, b.image);
    BOOST_TEST(stored_pixel(difference, 2, 1).r == 1);
    BOOST_TEST(stored_pixel(difference, 2, 1).g == 0.25f, boost::test_tools::tolerance(1e-4f));
}

BOOST_AUTO_TEST_CASE(without_a_finite_value_there_are_no_figures)
{
    const Comparison c = compare(flat(4, 4, 3, std::nanf("")), flat(4, 4, 3, 0.5f));
    BOOST_TEST(std::isnan(c.rmse));
    BOOST_TEST(std::isnan(c.ssim));
    BOOST_TEST(c.within_two == 0);
    BOOST_TEST(c.not_finite.unequal == 16);
    BOOST_CHECK(!figure_of(c, 0));
    Limits limits;
    BOOST_TEST(missed_limits(limits, c).empty());
    limits[0] = 1;
    BOOST_TEST(missed_limits(limits, c) ==
                   std::vector<std::string>{
                       "16 pixels differ by NaN or infinite values, the first at 0,0"},
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(ssim_against_its_definition)
{
    // The definition written out: weights over each whole 11 x 11 window, one window at a time.
    std::mt19937 random(5);
    const int width = 23, height = 14;
    std::vector<float> a, b;
    for (int i = 0; i < width * height; ++i) {
        a.push_back(float(random() % 256) / 255);
        b.push_back(0.5f * a.back() + 0.3f * float(random() % 256) / 255);
    }
    double total = 0;
    int windows = 0;
    for (int y = 5; y < height - 5; ++y)
        for (int x = 5; x < width - 5; ++x, ++windows) {
            double w = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
            for (int pass = 0; pass < 2; ++pass) {
                for (int j = -5; j <= 5; ++j)
                    for (int i = -5; i <= 5; ++i) {
                        const double g = std::exp(-(i * i + j * j) / 4.5);
                        const double p = a[(y + j) * width + x + i], q = b[(y + j) * width + x + i];
                        if (pass == 0) {
                            w += g;
                            ma += g * p;
                            mb += g * q;
                        } else {
                            va += g / w * (p - ma) * (p - ma);
                            vb += g / w * (q - mb) * (q - mb);
                            cov += g / w * (p - ma) * (q - mb);
                        }
                    }
                if (pass == 0) {
                    ma /= w;
                    mb /= w;
                }
            }
            total += (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) /
                     ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
        }
    BOOST_TEST(windows == 13 * 4);
    BOOST_TEST(structural_similarity(a, b, width, height) == total / windows,
               boost::test_tools::tolerance(1e-9));
    BOOST_TEST(structural_similarity(a, a, width, height) == 1);
    BOOST_TEST(structural_similarity(a, b, 2, 3) < 1); // smaller than a window
    BOOST_TEST(structural_similarity(a, a, 2, 3) == 1);
}

BOOST_AUTO_TEST_CASE(worst_micro_image)
{
    // 4 x 3 square lenses of 5 x 5 pixels; two lenses differ, one of them more.
    Frame a = flat(20, 15, 3, 0.5f);
    FrameMetadata m;
    m.sheet = {Arrangement::square, 1, 3, 1.5, 0, {0.5, 0}};
    m.film.pixel_pitch = {0.2, 0.2};
    m.aperture.distance = 300;
    Frame b = a;
    store_pixel(b.image, 7, 7, {0.6f, 0.6f, 0.6f, 1});
    for (int x = 15; x < 20; ++x)
        store_pixel(b.image, x, 12, {0.7f, 0.7f, 0.7f, 1});
    for (const bool first : {true, false}) {
        Frame with = first ? a : b;
        set_metadata(with, m);
        const Comparison c = first ? compare(with, b) : compare(a, with);
        BOOST_REQUIRE(c.worst);
        // Columns 15..19 are x = 1..2 mm, lens 1; rows 10..14 are y = -1.5..-0.5, row -1.
        BOOST_TEST(c.worst->lens.i == 1);
        BOOST_TEST(c.worst->lens.j == -1);
        BOOST_TEST(c.worst->pole.x == 1.5);
        BOOST_TEST(c.worst->pole.y == -1);
        BOOST_TEST(c.worst->rmse == std::sqrt(5 * 0.04 / 25), exactly);
    }
}

BOOST_AUTO_TEST_CASE(difference)
{
    Frame a{make_image<std::uint8_t>(1, 1, 3, {}), {}}, b = a;
    store_pixel(a.image, 0, 0, {10 / 255.f, 50 / 255.f, 1, 1});
    store_pixel(b.image, 0, 0, {30 / 255.f, 20 / 255.f, 0, 1});
    const std::vector<std::uint8_t> plain = {20, 30, 255}, doubled = {40, 60, 255};
    BOOST_CHECK(std::get<std::vector<std::uint8_t>>(difference_picture(a.image, b.image).samples) ==
                plain);
    BOOST_CHECK(std::get<std::vector<std::uint8_t>>(
                    difference_picture(a.image, b.image, 2).samples) == doubled);
}

BOOST_AUTO_TEST_SUITE_END()
