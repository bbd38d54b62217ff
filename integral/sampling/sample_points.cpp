// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sampling/sample_points.h"

#include "integral/base/eight_floats.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace integral {

namespace {

/// A bijective hash of 64-bit numbers (the finaliser of SplitMix64, Steele et al. 2014).
std::uint64_t scrambled(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// One number for each dimension.
typedef std::uint32_t FourBits __attribute__((vector_size(16)));

INTEGRAL_INLINE std::uint32_t with_swapped_bytes(std::uint32_t x) { return __builtin_bswap32(x); }
INTEGRAL_INLINE FourBits with_swapped_bytes(FourBits x)
{
    typedef std::uint8_t Bytes __attribute__((vector_size(16)));
    const Bytes bytes = Bytes(x);
    return FourBits(__builtin_shufflevector(bytes, bytes, 3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15,
                                            14, 13, 12));
}

template <class Bits> INTEGRAL_INLINE Bits reversed(Bits x)
{
    x = with_swapped_bytes(x);
    x = (x >> 4 & 0x0f0f0f0f) | (x & 0x0f0f0f0f) << 4;
    x = (x >> 2 & 0x33333333) | (x & 0x33333333) << 2;
    return (x >> 1 & 0x55555555) | (x & 0x55555555) << 1;
}

using Columns = std::array<std::array<std::uint32_t, 32>, point_dimensions>;

/// The columns of the generator matrices of a Sobol sequence in four dimensions, each with its bits
/// in reverse order. The polynomials are 1, x + 1, x^2 + x + 1 and x^3 + x + 1. The initial
/// columns, which can be chosen freely, are those that best distribute up to 128 points in every
/// pair of dimensions, with more weight on the pairs (1, 3) and (2, 4), from which SumSplit makes
/// the coordinates along one axis.
Columns sobol_columns()
{
    constexpr std::uint32_t top = 1u << 31;
    Columns c{};
    c[1][0] = top;
    c[2] = {top, (top >> 1) * 3};
    c[3] = {top, top >> 1, (top >> 2) * 3};
    for (int i = 0; i < 32; ++i) {
        c[0][i] = top >> i;
        if (i > 0)
            c[1][i] = c[1][i - 1] ^ c[1][i - 1] >> 1;
        if (i > 1)
            c[2][i] = c[2][i - 2] ^ c[2][i - 2] >> 2 ^ c[2][i - 1];
        if (i > 2)
            c[3][i] = c[3][i - 3] ^ c[3][i - 3] >> 3 ^ c[3][i - 2];
    }
    for (auto& dimension : c)
        for (std::uint32_t& column : dimension)
            column = reversed(column);
    return c;
}

const Columns columns = sobol_columns();

/// A point of the sequence, the bits of each coordinate in reverse order.
using SobolPoint = std::array<std::uint32_t, point_dimensions>;

SobolPoint sobol_point(std::uint32_t index)
{
    SobolPoint point{};
    for (int bit = 0; index >> bit; ++bit)
        for (int k = 0; k < point_dimensions; ++k)
            point[k] ^= index >> bit & 1 ? columns[k][bit] : 0;
    return point;
}

using FirstPoints = std::array<SobolPoint, 256>;
FirstPoints sobol_points()
{
    FirstPoints points;
    for (std::uint32_t index = 0; index < points.size(); ++index)
        points[index] = sobol_point(index);
    return points;
}

const FirstPoints first_points = sobol_points();

/// A bijection in which each bit depends only on itself and the bits below it. On a coordinate with
/// its bits in reverse order this is Owen scrambling (Laine and Karras 2011; multipliers by Vegdahl
/// 2021).
template <class Bits> INTEGRAL_INLINE Bits scrambled_upwards(Bits x, Bits seed)
{
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1;
    x ^= x * 0x05526c56u;
    return x ^ x * 0x53a22864u;
}

/// The bits of a point's coordinates, highest first.
using PointBits = std::array<std::uint32_t, point_dimensions>;

/// Scrambles all dimensions at once.
INTEGRAL_INLINE PointBits scrambled_at_once(const PointSeeds& seeds, const SobolPoint& point)
{
    FourBits bits, of_seeds;
    std::memcpy(&bits, point.data(), sizeof bits);
    std::memcpy(&of_seeds, seeds.data(), sizeof of_seeds);
    const FourBits result = reversed(scrambled_upwards(bits, of_seeds));
    PointBits scrambled;
    std::memcpy(scrambled.data(), &result, sizeof result);
    return scrambled;
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2 PointBits scrambled_with_avx2(const PointSeeds& seeds, const SobolPoint& point)
{
    return scrambled_at_once(seeds, point);
}
#endif

PointBits scrambled_bits(const PointSeeds& seeds, std::uint32_t index)
{
    const SobolPoint point = index < first_points.size() ? first_points[index] : sobol_point(index);
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return scrambled_with_avx2(seeds, point);
#endif
    return scrambled_at_once(seeds, point);
}

UnitPoint point_of(const PointBits& bits)
{
    UnitPoint point;
    for (int k = 0; k < point_dimensions; ++k)
        point[k] = (bits[k] + 0.5) * 0x1p-32;
    return point;
}

} // namespace

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t value)
{
    return scrambled(seed ^ scrambled(value));
}

PointSeeds point_seeds(std::uint64_t key)
{
    const std::uint64_t a = scrambled(key), b = scrambled(key + 1);
    return {std::uint32_t(a), std::uint32_t(a >> 32), std::uint32_t(b), std::uint32_t(b >> 32)};
}

UnitPoint scrambled_point(const PointSeeds& seeds, std::uint32_t index)
{
    return point_of(scrambled_bits(seeds, index));
}

ShiftedPoints::ShiftedPoints(const PointSeeds& seeds, const UnitPoint& first) : seeds_(seeds)
{
    const PointBits begins = scrambled_bits(seeds, 0);
    for (int k = 0; k < point_dimensions; ++k)
        flipped_[k] = begins[k] ^ std::uint32_t(std::min(first[k] * 0x1p32, 0x1p32 - 1));
}

UnitPoint ShiftedPoints::operator()(std::uint32_t index) const
{
    PointBits bits = scrambled_bits(seeds_, index);
    for (int k = 0; k < point_dimensions; ++k)
        bits[k] ^= flipped_[k];
    return point_of(bits);
}

std::uint32_t place_on_curve(std::uint32_t x, std::uint32_t y)
{
    const auto apart = [](std::uint32_t bits) {
        bits = (bits | bits << 2) & 0x33;
        return (bits | bits << 1) & 0x55;
    };
    return apart(x) | apart(y) << 1;
}

std::uint32_t shuffled_index(std::uint32_t seed, std::uint32_t index)
{
    constexpr std::uint32_t low = 255;
    return (index & ~low) | reversed(scrambled_upwards(reversed(index << 24), seed) & low) >> 24;
}

SumSplit::SumSplit(double ratio)
    : second_is_wide_(!(std::fabs(ratio) <= 1)),
      narrow_(second_is_wide_ ? 1 / ratio : ratio),
      of_narrow_(narrow_ != 0 ? 1 / narrow_ : 0)
{
    if (!std::isfinite(of_narrow_))
        narrow_ = of_narrow_ = 0;
}

SumSplit::Parts SumSplit::operator()(double u, double v) const
{
    // The density of the sum of two uniform variables, on intervals of lengths 1 and k about 0, is
    // a trapezium that rises and falls over a length of k. No branch depends on u, because the
    // processor could not predict it.
    const double k = std::fabs(narrow_), outer = std::min(u, 1 - u);
    const double low = std::sqrt(2 * k * std::min(outer, 0.5 * k)) +
                       std::max(0.0, outer - 0.5 * k) - 0.5 * (1 + k);
    const double sum = std::copysign(low, u - 0.5);
    const double least = std::max(-0.5 * k, sum - 0.5),
                 most = std::min(0.5 * k, sum + 0.5); // range of the narrow coordinate's
                                                      // contribution
    const double part = least + v * (most - least);
    const double narrow = k > 0 ? std::min(0.5, std::max(-0.5, part * of_narrow_)) + 0.5 : v;
    const double wide = std::min(1.0, std::max(0.0, sum - part + 0.5));
    return second_is_wide_ ? Parts{narrow, wide} : Parts{wide, narrow};
}

SumSplit::Parts SumSplit::inverse(const Parts& parts) const
{
    const double k = std::fabs(narrow_);
    const double wide = second_is_wide_ ? parts.second : parts.first,
                 narrow = second_is_wide_ ? parts.first : parts.second;
    const double part = narrow_ * (narrow - 0.5), sum = wide - 0.5 + part;
    const double inside = std::max(0.0, 0.5 * (1 + k) - std::fabs(sum)); // to the trapezium's end
    const double outer = inside < k ? inside * inside / (2 * k) : inside - 0.5 * k;
    const double least = std::max(-0.5 * k, sum - 0.5), most = std::min(0.5 * k, sum + 0.5);
    const double v = most > least ? (part - least) / (most - least) : narrow;
    return {sum < 0 ? outer : 1 - outer, std::min(1.0, std::max(0.0, v))};
}

} // namespace integral
