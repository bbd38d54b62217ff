// SPDX-License-Identifier: AGPL-3.0-or-later
// Four floats side by side in a vector register of the processor (vector extensions of GCC and
// Clang): arithmetic and comparisons work on all four at once.
#ifndef INTEGRAL_BASE_FOUR_FLOATS_H
#define INTEGRAL_BASE_FOUR_FLOATS_H

#include <array>
#include <cstdint>
#include <cstring>

namespace integral {

/// Always inlined, so that it is compiled for the processor that its caller is compiled for.
#define INTEGRAL_INLINE __attribute__((always_inline)) inline

typedef float FourFloats __attribute__((vector_size(16)));
typedef std::int32_t FourIntegers __attribute__((vector_size(16)));

inline FourFloats abs(FourFloats x) { return FourFloats(FourIntegers(x) & 0x7fffffff); }
inline FourFloats max(FourFloats a, FourFloats b) { return a > b ? a : b; }
/// Whether a comparison holds for at least one of the four.
inline bool any(FourIntegers x)
{
    std::int64_t halves[2];
    std::memcpy(halves, &x, sizeof x);
    return (halves[0] | halves[1]) != 0;
}
inline float sum_of(FourFloats x) { return (x[0] + x[1]) + (x[2] + x[3]); }

typedef std::int16_t FourShorts __attribute__((vector_size(8)));

/// Reads four 16-bit integers from memory as floats.
inline FourFloats floats_from(const void* integers)
{
    FourShorts narrow;
    std::memcpy(&narrow, integers, sizeof narrow);
    return __builtin_convertvector(__builtin_convertvector(narrow, FourIntegers), FourFloats);
}

/// Splits each element's 32 bits into two 16-bit integers, as floats: `first` gets the integer that
/// comes first in memory, `second` the other. Bits, Integers: vectors of unsigned and signed 32-bit
/// integers, with as many elements as Floats.
template <class Bits, class Integers, class Floats>
INTEGRAL_INLINE void split_pairs_as(Floats pairs, Floats& first, Floats& second)
{
    const Bits bits = Bits(pairs);
    const Floats low = __builtin_convertvector(Integers(bits << 16) >> 16, Floats),
                 high = __builtin_convertvector(Integers(bits) >> 16, Floats);
    constexpr bool low_is_first = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;
    first = low_is_first ? low : high;
    second = low_is_first ? high : low;
}
INTEGRAL_INLINE void split_pairs(FourFloats pairs, FourFloats& first, FourFloats& second)
{
    typedef std::uint32_t FourBits __attribute__((vector_size(16)));
    split_pairs_as<FourBits, FourIntegers>(pairs, first, second);
}

/// Transposes a 4 x 4 matrix.
inline void transpose(std::array<FourFloats, 4>& rows)
{
    const FourFloats a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5),
                     b = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7),
                     c = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5),
                     d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
    rows = {__builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(a, c, 2, 3, 6, 7),
            __builtin_shufflevector(b, d, 0, 1, 4, 5), __builtin_shufflevector(b, d, 2, 3, 6, 7)};
}

} // namespace integral

#endif
