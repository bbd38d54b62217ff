// SPDX-License-Identifier: AGPL-3.0-or-later
// Arithmetic on eight floats side by side: in one register of processors with AVX2 (EightFloats),
// in two registers of others (TwiceFourFloats). Both types have the same functions and give the
// same results, bit by bit. So a loop over such numbers is written once, as a template
// (INTEGRAL_INLINE), and called from two functions, one of them compiled for AVX2
// (INTEGRAL_TARGET_AVX2). In memory the numbers are an Eight.
#ifndef INTEGRAL_BASE_EIGHT_FLOATS_H
#define INTEGRAL_BASE_EIGHT_FLOATS_H

#include "integral/base/avx2.h"
#include "integral/base/four_floats.h"

#include <cmath>
#include <cstddef>

namespace integral {

#ifdef INTEGRAL_HAS_AVX2
#define INTEGRAL_TARGET_AVX2 __attribute__((target("avx2")))
// Never defined. The declaration is needed because GCC provides the AVX2 builtins in bits() and
// Packing only after a function has been declared for AVX2.
INTEGRAL_TARGET_AVX2 void declared_for_avx2();
#endif

/// Eight floats in memory.
struct alignas(32) Eight {
    float values[8];
    float& operator[](std::size_t k) { return values[k]; }
    float operator[](std::size_t k) const { return values[k]; }
};

/// Eight floats in one register.
typedef float EightFloats __attribute__((vector_size(32)));
typedef std::int32_t EightIntegers __attribute__((vector_size(32)));

/// Eight floats in two registers.
struct TwiceFourIntegers {
    FourIntegers low, high;
};
struct TwiceFourFloats {
    FourFloats low, high;
};
#define INTEGRAL_OPERATOR(Result, Operand, symbol)                                                 \
    INTEGRAL_INLINE Result operator symbol(Operand a, Operand b)                                   \
    {                                                                                              \
        return {a.low symbol b.low, a.high symbol b.high};                                         \
    }
INTEGRAL_OPERATOR(TwiceFourFloats, TwiceFourFloats, +)
INTEGRAL_OPERATOR(TwiceFourFloats, TwiceFourFloats, -)
INTEGRAL_OPERATOR(TwiceFourFloats, TwiceFourFloats, *)
INTEGRAL_OPERATOR(TwiceFourFloats, TwiceFourFloats, /)
INTEGRAL_OPERATOR(TwiceFourIntegers, TwiceFourFloats, <)
INTEGRAL_OPERATOR(TwiceFourIntegers, TwiceFourFloats, >)
#undef INTEGRAL_OPERATOR

/// Load from memory and store to it, at any alignment; broadcast copies one value to all eight
/// elements.
template <class Floats> INTEGRAL_INLINE Floats load(const Eight& memory)
{
    Floats x;
    std::memcpy(&x, &memory, sizeof x);
    return x;
}
template <class Floats> INTEGRAL_INLINE Floats load(const float* memory)
{
    Floats x;
    std::memcpy(&x, memory, sizeof x);
    return x;
}
template <class Floats> INTEGRAL_INLINE void store(Eight& memory, Floats x)
{
    std::memcpy(&memory, &x, sizeof x);
}
template <class Floats> INTEGRAL_INLINE void store(float* memory, Floats x)
{
    std::memcpy(memory, &x, sizeof x);
}
template <class Floats> INTEGRAL_INLINE Floats broadcast(float x);
template <> INTEGRAL_INLINE EightFloats broadcast(float x) { return EightFloats{} + x; }
template <> INTEGRAL_INLINE TwiceFourFloats broadcast(float x)
{
    return {FourFloats{} + x, FourFloats{} + x};
}

/// One float, so that templates also work on a single number.
template <> INTEGRAL_INLINE float broadcast(float x) { return x; }

/// Selects a where a comparison holds, b elsewhere.
INTEGRAL_INLINE float select(bool where, float a, float b) { return where ? a : b; }
INTEGRAL_INLINE FourFloats select(FourIntegers where, FourFloats a, FourFloats b)
{
    return where ? a : b;
}
INTEGRAL_INLINE EightFloats select(EightIntegers where, EightFloats a, EightFloats b)
{
    return where ? a : b;
}
INTEGRAL_INLINE TwiceFourFloats select(TwiceFourIntegers where, TwiceFourFloats a,
                                       TwiceFourFloats b)
{
    return {select(where.low, a.low, b.low), select(where.high, a.high, b.high)};
}
template <class Floats> INTEGRAL_INLINE Floats min(Floats a, Floats b)
{
    return select(a < b, a, b);
}
template <class Floats> INTEGRAL_INLINE Floats max(Floats a, Floats b)
{
    return select(a > b, a, b);
}

INTEGRAL_INLINE float abs(float x) { return std::fabs(x); }
INTEGRAL_INLINE EightFloats abs(EightFloats x)
{
    return EightFloats(EightIntegers(x) & 0x7fffffff);
}
INTEGRAL_INLINE TwiceFourFloats abs(TwiceFourFloats x) { return {abs(x.low), abs(x.high)}; }

/// Bit pattern of a number, read as an integer and converted to float.
INTEGRAL_INLINE float bits_as_number(float x)
{
    std::int32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return float(bits);
}
INTEGRAL_INLINE FourFloats bits_as_number(FourFloats x)
{
    return __builtin_convertvector(FourIntegers(x), FourFloats);
}
INTEGRAL_INLINE EightFloats bits_as_number(EightFloats x)
{
    return __builtin_convertvector(EightIntegers(x), EightFloats);
}
INTEGRAL_INLINE TwiceFourFloats bits_as_number(TwiceFourFloats x)
{
    return {bits_as_number(x.low), bits_as_number(x.high)};
}

/// Mask of the elements for which a comparison holds; bit 0 is the first element's.
INTEGRAL_INLINE unsigned bits(FourIntegers where)
{
#ifdef __SSE__
    return unsigned(__builtin_ia32_movmskps(FourFloats(where)));
#else
    return (where[0] & 1) | (where[1] & 2) | (where[2] & 4) | (where[3] & 8);
#endif
}
INTEGRAL_INLINE unsigned bits(TwiceFourIntegers where)
{
    return bits(where.low) | bits(where.high) << 4;
}
INTEGRAL_INLINE unsigned bits(EightIntegers where)
{
#if defined(INTEGRAL_HAS_AVX2) && !defined(__clang__)
    return unsigned(__builtin_ia32_movmskps256(EightFloats(where)));
#else
    return bits(TwiceFourIntegers{__builtin_shufflevector(where, where, 0, 1, 2, 3),
                                  __builtin_shufflevector(where, where, 4, 5, 6, 7)});
#endif
}

/// Whether a comparison holds for at least one of the eight.
INTEGRAL_INLINE bool any(EightIntegers where) { return bits(where) != 0; }
INTEGRAL_INLINE bool any(TwiceFourIntegers where) { return any(where.low | where.high); }

/// The first four elements, and the last four.
INTEGRAL_INLINE FourFloats low_half(EightFloats x)
{
    return __builtin_shufflevector(x, x, 0, 1, 2, 3);
}
INTEGRAL_INLINE FourFloats high_half(EightFloats x)
{
    return __builtin_shufflevector(x, x, 4, 5, 6, 7);
}
INTEGRAL_INLINE FourFloats low_half(TwiceFourFloats x) { return x.low; }
INTEGRAL_INLINE FourFloats high_half(TwiceFourFloats x) { return x.high; }
template <class Floats> INTEGRAL_INLINE Floats of_halves(FourFloats low, FourFloats high);
template <> INTEGRAL_INLINE EightFloats of_halves(FourFloats low, FourFloats high)
{
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
template <> INTEGRAL_INLINE TwiceFourFloats of_halves(FourFloats low, FourFloats high)
{
    return {low, high};
}
/// Writes the selected elements of eight to memory, without gaps. There must be memory for eight
/// floats; floats behind the written ones may change too.
template <class Floats> class Packing;
template <> class Packing<TwiceFourFloats> {
public:
    /// `which`: bit k selects element k.
    explicit INTEGRAL_INLINE Packing(unsigned which) : which_(which) {}
    INTEGRAL_INLINE void store(float* memory, TwiceFourFloats x) const
    {
        Eight all;
        integral::store(all, x);
        for (unsigned left = which_; left != 0; left &= left - 1)
            *memory++ = all[__builtin_ctz(left)];
    }

private:
    unsigned which_;
};

/// For each 8-bit mask, the indices of its set bits in ascending order, then zeros.
struct OrdersOfBits {
    std::uint8_t of[256][8]{};
    constexpr OrdersOfBits()
    {
        for (int which = 0; which < 256; ++which)
            for (int k = 0, number = 0; k < 8; ++k)
                if (which >> k & 1)
                    of[which][number++] = std::uint8_t(k);
    }
};
constexpr OrdersOfBits orders_of_bits;

template <> class Packing<EightFloats> {
public:
    explicit INTEGRAL_INLINE Packing(unsigned which)
    {
        typedef std::uint8_t EightBytes __attribute__((vector_size(8)));
        EightBytes order;
        std::memcpy(&order, orders_of_bits.of[which], sizeof order);
        order_ = __builtin_convertvector(order, EightIntegers);
    }
    INTEGRAL_INLINE void store(float* memory, EightFloats x) const
    {
#if defined(INTEGRAL_HAS_AVX2) && !defined(__clang__)
        const EightFloats packed = __builtin_ia32_permvarsf256(x, order_);
        std::memcpy(memory, &packed, sizeof packed);
#else
        for (int k = 0; k < 8; ++k)
            memory[k] = x[order_[k]];
#endif
    }

private:
    EightIntegers order_;
};

template <class Floats> INTEGRAL_INLINE float sum_of_eight(Floats x)
{
    return sum_of(low_half(x) + high_half(x));
}

/// See four_floats.h.
INTEGRAL_INLINE void split_pairs(EightFloats pairs, EightFloats& first, EightFloats& second)
{
    typedef std::uint32_t EightBits __attribute__((vector_size(32)));
    split_pairs_as<EightBits, EightIntegers>(pairs, first, second);
}
INTEGRAL_INLINE void split_pairs(TwiceFourFloats pairs, TwiceFourFloats& first,
                                 TwiceFourFloats& second)
{
    split_pairs(pairs.low, first.low, second.low);
    split_pairs(pairs.high, first.high, second.high);
}

/// Transposes two 4 x 4 matrices: the first halves of the rows, and the second halves.
INTEGRAL_INLINE void transpose(EightFloats (&rows)[4])
{
    const EightFloats a = __builtin_shufflevector(rows[0], rows[1], 0, 8, 1, 9, 4, 12, 5, 13),
                      b = __builtin_shufflevector(rows[0], rows[1], 2, 10, 3, 11, 6, 14, 7, 15),
                      c = __builtin_shufflevector(rows[2], rows[3], 0, 8, 1, 9, 4, 12, 5, 13),
                      d = __builtin_shufflevector(rows[2], rows[3], 2, 10, 3, 11, 6, 14, 7, 15);
    rows[0] = __builtin_shufflevector(a, c, 0, 1, 8, 9, 4, 5, 12, 13);
    rows[1] = __builtin_shufflevector(a, c, 2, 3, 10, 11, 6, 7, 14, 15);
    rows[2] = __builtin_shufflevector(b, d, 0, 1, 8, 9, 4, 5, 12, 13);
    rows[3] = __builtin_shufflevector(b, d, 2, 3, 10, 11, 6, 7, 14, 15);
}
INTEGRAL_INLINE void transpose(TwiceFourFloats (&rows)[4])
{
    std::array<FourFloats, 4> low, high;
    for (int k = 0; k < 4; ++k) {
        low[k] = rows[k].low;
        high[k] = rows[k].high;
    }
    transpose(low);
    transpose(high);
    for (int k = 0; k < 4; ++k)
        rows[k] = {low[k], high[k]};
}

/// Sums of a, b, c and d, each over its eight elements.
template <class Floats>
INTEGRAL_INLINE FourFloats sums_of_eight(Floats a, Floats b, Floats c, Floats d)
{
    Floats rows[4] = {a, b, c, d};
    transpose(rows);
    const Floats halves = (rows[0] + rows[1]) + (rows[2] + rows[3]);
    return low_half(halves) + high_half(halves);
}

} // namespace integral

#endif
