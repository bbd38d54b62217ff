// SPDX-License-Identifier: AGPL-3.0-or-later
// What the AVX2 loops of interlacing share. Where INTEGRAL_HAS_AVX2 is not defined there are none.
#ifndef INTEGRAL_OUTPUT_INTERLACE_AVX2_H
#define INTEGRAL_OUTPUT_INTERLACE_AVX2_H

#if defined(__x86_64__) && defined(__GNUC__)
#define INTEGRAL_HAS_AVX2
#include <immintrin.h>

namespace integral {

inline bool has_avx2()
{
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}

__attribute__((target("avx2"))) inline __m256i vector(const void* at) { return _mm256_loadu_si256(static_cast<const __m256i*>(at)); }
__attribute__((target("avx2"))) inline void store(void* at, __m256i value) { _mm256_storeu_si256(static_cast<__m256i*>(at), value); }

/// Weights of 1/256 in lanes of 32 bits as pairs for madd: what is left of 256, and they.
__attribute__((target("avx2"))) inline __m256i pairs(__m256i weights)
{
    return _mm256_add_epi32(_mm256_set1_epi32(256), _mm256_mullo_epi32(weights, _mm256_set1_epi32(65535)));
}

/// Of each of eight lanes of 32 bits one byte, the lowest being 0.
template <int byte> __attribute__((target("avx2"))) inline __m128i bytes_of(__m256i lanes)
{
    const __m256i order = _mm256_setr_epi8(byte, byte + 4, byte + 8, byte + 12, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
                                           -1, -1, -1, -1, byte, byte + 4, byte + 8, byte + 12, -1, -1, -1, -1, -1, -1, -1, -1);
    const __m256i bytes = _mm256_shuffle_epi8(lanes, order);
    return _mm_or_si128(_mm256_castsi256_si128(bytes), _mm256_extracti128_si256(bytes, 1));
}

} // namespace integral

#endif

#endif
