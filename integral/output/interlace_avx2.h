// SPDX-License-Identifier: AGPL-3.0-or-later
// What the AVX2 loops of interlacing share. Where INTEGRAL_HAS_AVX2 is not defined there are none.
#ifndef INTEGRAL_OUTPUT_INTERLACE_AVX2_H
#define INTEGRAL_OUTPUT_INTERLACE_AVX2_H

#if defined(__x86_64__) && defined(__GNUC__)
#define INTEGRAL_HAS_AVX2
#include <cstdint>
#include <cstring>
#include <immintrin.h>

namespace integral {

inline bool has_avx2()
{
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}

__attribute__((target("avx2"))) inline __m256i vector(const void* at)
{
    return _mm256_loadu_si256(static_cast<const __m256i*>(at));
}
__attribute__((target("avx2"))) inline void store(void* at, __m256i value)
{
    _mm256_storeu_si256(static_cast<__m256i*>(at), value);
}

/// Of weights of 1/256, each one byte of a lane of 32 bits, pairs for madd: what is left of 256,
/// and they.
template <int byte> __attribute__((target("avx2"))) inline __m256i pairs_of(__m256i lanes)
{
    const __m256i twice = _mm256_setr_epi8(byte, -1, byte, -1, byte + 4, -1, byte + 4, -1, byte + 8,
                                           -1, byte + 8, -1, byte + 12, -1, byte + 12, -1, byte, -1,
                                           byte, -1, byte + 4, -1, byte + 4, -1, byte + 8, -1,
                                           byte + 8, -1, byte + 12, -1, byte + 12, -1);
    return _mm256_add_epi32(
        _mm256_xor_si256(_mm256_shuffle_epi8(lanes, twice), _mm256_set1_epi32(255)),
        _mm256_set1_epi32(1));
}

/// Of each of eight lanes of 32 bits one byte, the lowest being 0.
template <int byte> __attribute__((target("avx2"))) inline __m128i bytes_of(__m256i lanes)
{
    const __m256i order = _mm256_setr_epi8(
        byte, byte + 4, byte + 8, byte + 12, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
        -1, -1, byte, byte + 4, byte + 8, byte + 12, -1, -1, -1, -1, -1, -1, -1, -1);
    const __m256i bytes = _mm256_shuffle_epi8(lanes, order);
    return _mm_or_si128(_mm256_castsi256_si128(bytes), _mm256_extracti128_si256(bytes, 1));
}

/// What lies at eight places, of 31 bits: a byte of each, or four, or of two places eight. Loads
/// one by one take less than half the time of the gather instructions on the processors on which
/// this was measured, and places from a register's halves less than from memory.
class EightPlaces {
public:
    __attribute__((target("avx2"))) explicit EightPlaces(__m256i places)
    {
        const __m128i low = _mm256_castsi256_si128(places),
                      high = _mm256_extracti128_si256(places, 1);
        two_[0] = std::uint64_t(_mm_cvtsi128_si64(low));
        two_[1] = std::uint64_t(_mm_extract_epi64(low, 1));
        two_[2] = std::uint64_t(_mm_cvtsi128_si64(high));
        two_[3] = std::uint64_t(_mm_extract_epi64(high, 1));
    }

    /// In the lower half.
    __attribute__((target("avx2"))) __m128i bytes(const std::uint8_t* origin) const
    {
        __m128i all = _mm_cvtsi32_si128(origin[place<0>()]);
        all = _mm_insert_epi8(all, origin[place<1>()], 1);
        all = _mm_insert_epi8(all, origin[place<2>()], 2);
        all = _mm_insert_epi8(all, origin[place<3>()], 3);
        all = _mm_insert_epi8(all, origin[place<4>()], 4);
        all = _mm_insert_epi8(all, origin[place<5>()], 5);
        all = _mm_insert_epi8(all, origin[place<6>()], 6);
        return _mm_insert_epi8(all, origin[place<7>()], 7);
    }

    __attribute__((target("avx2"))) __m256i fours(const std::uint8_t* origin) const
    {
        return _mm256_inserti128_si256(_mm256_castsi128_si256(half<0>(origin)), half<4>(origin), 1);
    }

    template <int first>
    __attribute__((target("avx2"))) __m128i eights(const std::uint8_t* origin) const
    {
        return _mm_unpacklo_epi64(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(origin + place<first>())),
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(origin + place<first + 1>())));
    }

private:
    template <int k> std::uint64_t place() const
    {
        return k % 2 ? two_[k / 2] >> 32 : std::uint32_t(two_[k / 2]);
    }
    template <int k> int four(const std::uint8_t* origin) const
    {
        int value;
        std::memcpy(&value, origin + place<k>(), sizeof value);
        return value;
    }
    template <int k> __attribute__((target("avx2"))) __m128i half(const std::uint8_t* origin) const
    {
        const __m128i all = _mm_insert_epi32(_mm_cvtsi32_si128(four<k>(origin)),
                                             four<k + 1>(origin), 1);
        return _mm_insert_epi32(_mm_insert_epi32(all, four<k + 2>(origin), 2), four<k + 3>(origin),
                                3);
    }

    std::uint64_t two_[4];
};

} // namespace integral

#endif

#endif
