// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that arithmetic on eight floats gives the same bits with and without AVX2, and the results
// of plain arithmetic.
#include "integral/base/eight_floats.h"

#include <boost/test/unit_test.hpp>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace integral;

namespace {

/// Appends to `results` what each function returns for two groups of eight numbers.
template <class Floats>
INTEGRAL_INLINE void work_out(const Eight& first, const Eight& second, std::vector<Eight>& results)
{
    const Floats a = load<Floats>(first), b = load<Floats>(second);
    results.clear();
    const auto keep = [&](Floats x) __attribute__((always_inline))
    {
        results.emplace_back();
        store(results.back(), x);
    };
    keep(a + b);
    keep(a - b);
    keep(a * b);
    keep(a / b);
    keep(min(a, b));
    keep(max(a, b));
    keep(abs(a));
    keep(select(a < b, a, broadcast<Floats>(2)));
    keep(select(a > b, a, broadcast<Floats>(2)));
    keep(of_halves<Floats>(high_half(a), low_half(b)));
    Floats low, high;
    split_pairs(a, low, high);
    keep(low);
    keep(high);
    Floats rows[4] = {a, b, a - b, a * b};
    transpose(rows);
    for (const Floats& row : rows)
        keep(row);
    keep(broadcast<Floats>(sum_of_eight(a)));
    keep(broadcast<Floats>(any(a < b) ? 1.0f : 0.0f));
    keep(broadcast<Floats>(float(bits(a < b))));
    keep(bits_as_number(a));
    const FourFloats sums = sums_of_eight(a, b, a - b, a * b);
    keep(of_halves<Floats>(sums, sums));
    Eight packed;
    const unsigned less = bits(a < b);
    Packing<Floats>(less).store(packed.values, b);
    std::fill(packed.values + __builtin_popcount(less), packed.values + 8, 0.0f); // unspecified
    keep(load<Floats>(packed.values));
}

void in_two_registers(const Eight& a, const Eight& b, std::vector<Eight>& results)
{
    work_out<TwiceFourFloats>(a, b, results);
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2
void in_one_register(const Eight& a, const Eight& b, std::vector<Eight>& results)
{
    work_out<EightFloats>(a, b, results);
}
#endif

/// Eight pairs of numbers of all magnitudes; some pairs are equal.
std::pair<Eight, Eight> random_numbers(std::mt19937& random)
{
    std::uniform_real_distribution<float> mantissa(-1, 1), exponent(-20, 20);
    std::pair<Eight, Eight> numbers;
    for (int k = 0; k < 8; ++k) {
        numbers.first[k] = mantissa(random) * std::exp2(exponent(random));
        numbers.second[k] = k == int(random() % 16)
                                ? numbers.first[k]
                                : mantissa(random) * std::exp2(exponent(random));
    }
    return numbers;
}

} // namespace

BOOST_AUTO_TEST_SUITE(base_eight_floats)

BOOST_AUTO_TEST_CASE(both_ways_give_the_same_bits)
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2()) {
        std::mt19937 random(5);
        for (int time = 0; time < 1000; ++time) {
            const auto [a, b] = random_numbers(random);
            std::vector<Eight> one, two;
            in_one_register(a, b, one);
            in_two_registers(a, b, two);
            BOOST_TEST_REQUIRE(one.size() == two.size());
            for (std::size_t k = 0; k < one.size(); ++k)
                BOOST_TEST_REQUIRE(std::memcmp(&one[k], &two[k], sizeof(Eight)) == 0,
                                   "function " << k << ", time " << time);
        }
        return;
    }
#endif
    BOOST_TEST_MESSAGE("this processor has no AVX2: there is one way only");
    BOOST_TEST(true);
}

BOOST_AUTO_TEST_CASE(they_do_what_plain_arithmetic_does)
{
    std::mt19937 random(6);
    const auto [a, b] = random_numbers(random);
    std::vector<Eight> results;
    in_two_registers(a, b, results);
    float sum = 0;
    for (int k = 0; k < 8; ++k) {
        BOOST_TEST(results[0][k] == a[k] + b[k]);
        BOOST_TEST(results[3][k] == a[k] / b[k]);
        BOOST_TEST(results[4][k] == std::min(a[k], b[k]));
        BOOST_TEST(results[5][k] == std::max(a[k], b[k]));
        BOOST_TEST(results[6][k] == std::fabs(a[k]));
        BOOST_TEST(results[7][k] == (a[k] < b[k] ? a[k] : 2));
        BOOST_TEST(results[9][k] == (k < 4 ? a[k + 4] : b[k - 4]));
        std::int16_t pair[2];
        std::memcpy(pair, &a.values[k], sizeof pair);
        BOOST_TEST(results[10][k] == pair[0]);
        BOOST_TEST(results[11][k] == pair[1]);
        // The transposed rows 0 to 3: numbers k and k + 4 of a, b, a - b, a * b.
        const int of = k % 4, row = k < 4 ? 0 : 4;
        for (int column = 0; column < 4; ++column) {
            const int place = column + row;
            const float expected[4] = {a[place], b[place], a[place] - b[place],
                                       a[place] * b[place]};
            BOOST_TEST(results[12 + column][row + of] == expected[of]);
        }
        sum += a[k];
    }
    unsigned less = 0;
    for (int k = 0; k < 8; ++k)
        less |= unsigned(a[k] < b[k]) << k;
    BOOST_TEST(results[18][0] == less);
    const auto is_sum = [&](float x) {
        return std::fabs(x - sum) <= 1e-5f * std::fabs(sum) + 1e-2f;
    };
    BOOST_TEST(is_sum(results[16][0]));
    BOOST_TEST(is_sum(results[20][0]));
    for (int k = 0, number = 0; k < 8; ++k)
        if (a[k] < b[k])
            BOOST_TEST(results[21][number++] == b[k]);
}

BOOST_AUTO_TEST_SUITE_END()
