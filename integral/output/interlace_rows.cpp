// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/interlace_rows.h"

#include "integral/output/interlace_avx2.h"

namespace integral {
namespace {

template <bool blend_views, bool blend_pixels, class Sample>
void plain_samples(const InterlacedRow<Sample>& row, int first)
{
    for (int i = first; i < row.count; ++i) {
        const std::uint32_t phase = row.phases[i] + row.phase;
        const Step view = blend_views ? linear_step(phase, row.view_count)
                                      : nearest_step(phase, row.view_count);
        const Sample* left = row.views + std::size_t(view.index) * row.view_step + row.places[i];
        const std::uint32_t weight = blend_pixels ? row.weights[i] >> 16 : 0;
        const auto across = [&](const Sample* at) {
            return at[0] * (256 - weight) + at[3] * weight;
        }; // 256 times the value
        if (!blend_views && !blend_pixels)
            row.samples[i] = left[0];
        else if (!blend_views)
            row.samples[i] = Sample((across(left) + 128) >> 8);
        else if (!blend_pixels)
            row.samples[i] = Sample(
                (left[0] * (256 - view.weight) + left[row.view_step] * view.weight + 128) >> 8);
        else
            row.samples[i] = Sample((across(left) * std::uint64_t(256 - view.weight) +
                                     across(left + row.view_step) * std::uint64_t(view.weight) +
                                     32768) >>
                                    16);
    }
}

template <class Sample>
void plain_row(const InterlacedRow<Sample>& row, bool blend_views, bool blend_pixels, int first)
{
    if (blend_views)
        blend_pixels ? plain_samples<true, true>(row, first)
                     : plain_samples<true, false>(row, first);
    else
        blend_pixels ? plain_samples<false, true>(row, first)
                     : plain_samples<false, false>(row, first);
}

template <class Sample>
void plain_blend(Sample* to, const Sample* a, const Sample* b, std::size_t first, std::size_t count,
                 std::uint32_t weight)
{
    for (std::size_t i = first; i < count; ++i)
        to[i] = Sample((a[i] * (256 - weight) + b[i] * weight + 128) >> 8);
}

#ifdef INTEGRAL_HAS_AVX2

/// Of four bytes the first and the last, weighed: 256 times the value.
__attribute__((target("avx2"))) inline __m256i ends_of(__m256i four, __m256i weights)
{
    const __m256i ends = _mm256_setr_epi8(0, -1, 3, -1, 4, -1, 7, -1, 8, -1, 11, -1, 12, -1, 15, -1,
                                          0, -1, 3, -1, 4, -1, 7, -1, 8, -1, 11, -1, 12, -1, 15,
                                          -1);
    return _mm256_madd_epi16(_mm256_shuffle_epi8(four, ends), weights);
}

/// Eight samples at a time; returns how many are done.
template <bool blend_views, bool blend_pixels>
__attribute__((target("avx2"))) int fast_samples(const InterlacedRow<std::uint8_t>& row)
{
    const std::uint32_t *const phases = row.phases, *const places = row.places,
                               *const weights = row.weights;
    const std::uint8_t *const views = row.views, *const next_views = views + row.view_step;
    std::uint8_t* const samples = row.samples;
    const int samples_count = row.count;
    const __m256i row_phase = _mm256_set1_epi32(int(row.phase)),
                  count = _mm256_set1_epi32(int(row.view_count)),
                  view_step = _mm256_set1_epi32(int(row.view_step));
    const __m256i shift = _mm256_set1_epi64x(0x80800000), whole = _mm256_set1_epi32(256),
                  last = _mm256_set1_epi32(int(row.view_count << 8));
    int i = 0;
    for (; i + 8 <= samples_count; i += 8) {
        const __m256i phase = _mm256_add_epi32(vector(phases + i), row_phase);
        const __m256i even = _mm256_mul_epu32(phase, count),
                      odd = _mm256_mul_epu32(_mm256_srli_epi64(phase, 32), count);
        __m256i view, step;
        if (blend_views) {
            // 256 times the next view, and its weight; none beyond the outermost.
            step = _mm256_blend_epi32(_mm256_srli_epi64(_mm256_add_epi64(even, shift), 24),
                                      _mm256_slli_epi64(_mm256_add_epi64(odd, shift), 8), 0xaa);
            step = _mm256_sub_epi32(_mm256_min_epu32(_mm256_max_epu32(step, whole), last), whole);
            view = _mm256_srli_epi32(step, 8);
        } else {
            view = _mm256_blend_epi32(_mm256_srli_epi64(even, 32), odd, 0xaa);
        }
        const EightPlaces at(
            _mm256_add_epi32(_mm256_mullo_epi32(view, view_step), vector(places + i)));
        __m128i result;
        if (blend_pixels) {
            const __m256i pixel_weights = vector(weights + i),
                          left = ends_of(at.fours(views), pixel_weights);
            if (blend_views) {
                // Both by 16 bits with a sign: less 128 times 256.
                const __m256i right = ends_of(at.fours(next_views), pixel_weights),
                              both = _mm256_blend_epi16(left, _mm256_slli_epi32(right, 16), 0xaa);
                const __m256i sum = _mm256_madd_epi16(
                    _mm256_xor_si256(both, _mm256_set1_epi16(short(0x8000))), pairs_of<0>(step));
                result = bytes_of<2>(_mm256_add_epi32(sum, _mm256_set1_epi32(0x808000)));
            } else {
                result = bytes_of<1>(_mm256_add_epi32(left, _mm256_set1_epi32(128)));
            }
        } else {
            result = at.bytes(views);
            if (blend_views) {
                const __m256i both = _mm256_cvtepu8_epi16(
                    _mm_unpacklo_epi8(result, at.bytes(next_views)));
                result = bytes_of<1>(_mm256_add_epi32(_mm256_madd_epi16(both, pairs_of<0>(step)),
                                                      _mm256_set1_epi32(128)));
            }
        }
        _mm_storel_epi64(reinterpret_cast<__m128i*>(samples + i), result);
    }
    return i;
}

/// For weights from 1 to 255.
__attribute__((target("avx2"))) std::size_t fast_blend(std::uint8_t* to, const std::uint8_t* a,
                                                       const std::uint8_t* b, std::size_t count,
                                                       std::uint32_t weight)
{
    // Bytes are taken from -128 on, for products of unsigned weights and signed values; the sum,
    // 256 times the value, just fits.
    const __m256i weights = _mm256_set1_epi16(short((256 - weight) | weight << 8)),
                  sign = _mm256_set1_epi8(char(128)), half = _mm256_set1_epi16(128);
    std::size_t i = 0;
    for (; i + 32 <= count; i += 32) {
        const __m256i left = _mm256_xor_si256(vector(a + i), sign),
                      right = _mm256_xor_si256(vector(b + i), sign);
        const __m256i low = _mm256_maddubs_epi16(weights, _mm256_unpacklo_epi8(left, right));
        const __m256i high = _mm256_maddubs_epi16(weights, _mm256_unpackhi_epi8(left, right));
        const __m256i both = _mm256_packs_epi16(_mm256_srai_epi16(_mm256_add_epi16(low, half), 8),
                                                _mm256_srai_epi16(_mm256_add_epi16(high, half), 8));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to + i), _mm256_xor_si256(both, sign));
    }
    return i;
}

#endif

} // namespace

template <class Sample>
void interlace_row_portably(const InterlacedRow<Sample>& row, bool blend_views, bool blend_pixels)
{
    plain_row(row, blend_views, blend_pixels, 0);
}

template <class Sample>
void blend_rows_portably(Sample* to, const Sample* a, const Sample* b, std::size_t count,
                         std::uint32_t weight)
{
    plain_blend(to, a, b, 0, count, weight);
}

template <>
void interlace_row(const InterlacedRow<std::uint8_t>& row, bool blend_views, bool blend_pixels)
{
    int done = 0;
#ifdef INTEGRAL_HAS_AVX2
    // Places are counted by 31 bits there, views by 23.
    if (has_avx2() && (std::uint64_t(row.view_count) + 1) * row.view_step < 0x7fffffff &&
        row.view_count < (1u << 23)) {
        if (blend_views)
            done = blend_pixels ? fast_samples<true, true>(row) : fast_samples<true, false>(row);
        else
            done = blend_pixels ? fast_samples<false, true>(row) : fast_samples<false, false>(row);
    }
#endif
    plain_row(row, blend_views, blend_pixels, done);
}

template <>
void blend_rows(std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b, std::size_t count,
                std::uint32_t weight)
{
    std::size_t done = 0;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2() && weight > 0)
        done = fast_blend(to, a, b, count, weight);
#endif
    plain_blend(to, a, b, done, count, weight);
}

template <>
void interlace_row(const InterlacedRow<std::uint16_t>& row, bool blend_views, bool blend_pixels)
{
    plain_row(row, blend_views, blend_pixels, 0);
}

template <>
void blend_rows(std::uint16_t* to, const std::uint16_t* a, const std::uint16_t* b,
                std::size_t count, std::uint32_t weight)
{
    plain_blend(to, a, b, 0, count, weight);
}

template void interlace_row_portably(const InterlacedRow<std::uint8_t>&, bool, bool);
template void interlace_row_portably(const InterlacedRow<std::uint16_t>&, bool, bool);
template void blend_rows_portably(std::uint8_t*, const std::uint8_t*, const std::uint8_t*,
                                  std::size_t, std::uint32_t);
template void blend_rows_portably(std::uint16_t*, const std::uint16_t*, const std::uint16_t*,
                                  std::size_t, std::uint32_t);

} // namespace integral
