// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/interlace_rays.h"

#include "integral/output/interlace_avx2.h"

#include <algorithm>

namespace integral {
namespace {

#ifdef INTEGRAL_HAS_AVX2

/// Steps among `count` equal parts, of RayMapping's parts: linear_step and nearest_step of
/// phase_of_part exactly, as 65536 times the index, and in the second byte the weight. By 32 bits:
/// with part p, phase times count is 65536 p count and what does not depend on p.
class Steps {
public:
    __attribute__((target("avx2"))) Steps(std::uint32_t parts, bool linear)
    {
        count_ = _mm256_set1_epi32(int(parts));
        shift_ = _mm256_set1_epi32(int(parts / 2) + (linear ? 0x8080 - 0x10000 : 0));
        last_ = _mm256_set1_epi32(int((parts - 1) << 16));
    }

    __attribute__((target("avx2"))) __m256i of(__m256i parts) const
    {
        const __m256i at = _mm256_add_epi32(_mm256_mullo_epi32(parts, count_), shift_);
        return _mm256_min_epi32(_mm256_max_epi32(at, _mm256_setzero_si256()), last_);
    }

private:
    __m256i count_, shift_, last_;
};

__attribute__((target("avx2"))) inline __m256i eight(const std::uint16_t* at)
{
    return _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
}

/// Pixels in lines of two rows: each the sums of its two and of the next pixel's two samples by
/// weights.
__attribute__((target("avx2"))) inline __m256i of_two_rows(__m128i lower, __m128i upper,
                                                           __m256i weights)
{
    const __m256i ends = _mm256_setr_epi8(0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1,
                                          0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1);
    const __m256i samples = _mm256_inserti128_si256(_mm256_castsi128_si256(lower), upper, 1);
    return _mm256_madd_epi16(_mm256_shuffle_epi8(samples, ends), weights);
}

/// Eight pixels blended: 65536 times their values less 128.
__attribute__((target("avx2"))) inline __m256i of_four(const EightPlaces& at,
                                                       const std::uint8_t* lines, __m256i x_weights,
                                                       __m256i y_weights)
{
    const __m256i first = of_two_rows(at.eights<0>(lines), at.eights<4>(lines),
                                      _mm256_unpacklo_epi32(y_weights, y_weights));
    const __m256i second = of_two_rows(at.eights<2>(lines), at.eights<6>(lines),
                                       _mm256_unpackhi_epi32(y_weights, y_weights));
    const __m256i less = _mm256_xor_si256(_mm256_packus_epi32(first, second),
                                          _mm256_set1_epi16(short(32768))); // by 128 times 256:
                                                                            // with a sign
    return _mm256_madd_epi16(less, x_weights);
}

template <bool blend_views, bool blend_pixels>
__attribute__((target("avx2"))) int fast_rays(const RayRow& row)
{
    static const std::int32_t channel_of[2][10] = {{0, 1, 2, 0, 1, 2, 0, 1, 2, 0},
                                                   {0, 2, 4, 0, 2, 4, 0, 2, 4, 0}};
    const Steps view_steps(row.view_count, blend_views), x_steps(row.width, blend_pixels),
        y_steps(row.height, blend_pixels);
    const bool several = row.first_line != row.last_line;
    const std::uint8_t* const lines = row.lines +
                                      (several ? 0 : row.first_line % lines_kept * row.line_step);
    const std::uint8_t* const next_lines = lines + row.view_step;
    const std::uint16_t *const of_across = row.across, *const of_x = row.x, *const of_y = row.y;
    std::uint8_t* const samples = row.samples;
    const int count = row.count;
    const __m256i place_steps = _mm256_set1_epi32(
        int((blend_pixels ? 6 : 3) | std::uint32_t(row.view_step) << 16)); // of x and views
    const __m256i line_step = _mm256_set1_epi32(int(row.line_step)),
                  of_lines = _mm256_set1_epi32(int(lines_kept - 1));
    int i = 0;
    for (int channel = 0; i + 8 <= count; i += 8, channel = channel ? channel - 1 : 2) {
        const __m256i view = view_steps.of(eight(of_across + i)), x = x_steps.of(eight(of_x + i));
        const __m256i columns = _mm256_blend_epi16(_mm256_srli_epi32(x, 16), view, 0xaa);
        __m256i place = _mm256_add_epi32(_mm256_madd_epi16(columns, place_steps),
                                         vector(channel_of[blend_pixels] + channel)),
                y;
        if (blend_pixels || several)
            y = y_steps.of(eight(of_y + i));
        if (several)
            place = _mm256_add_epi32(
                place, _mm256_mullo_epi32(_mm256_and_si256(_mm256_srli_epi32(y, 16), of_lines),
                                          line_step));
        const EightPlaces at(place);
        __m128i result;
        if (blend_pixels) {
            const __m256i x_weights = pairs_of<1>(x), y_weights = pairs_of<1>(y),
                          left = of_four(at, lines, x_weights, y_weights);
            if (blend_views) { // with a half for rounding, and the 128 that they are less
                const __m256i right = of_four(at, next_lines, x_weights, y_weights);
                const __m256i weight = _mm256_and_si256(_mm256_srli_epi32(view, 8),
                                                        _mm256_set1_epi32(255));
                const __m256i sum = _mm256_add_epi32(
                    _mm256_slli_epi32(left, 8),
                    _mm256_mullo_epi32(_mm256_sub_epi32(right, left), weight));
                result = bytes_of<3>(_mm256_add_epi32(sum, _mm256_set1_epi32(int(0x80800000))));
            } else {
                result = bytes_of<2>(_mm256_add_epi32(left, _mm256_set1_epi32(0x808000)));
            }
        } else {
            result = at.bytes(lines);
            if (blend_views) {
                const __m256i both = _mm256_cvtepu8_epi16(
                    _mm_unpacklo_epi8(result, at.bytes(next_lines)));
                result = bytes_of<1>(_mm256_add_epi32(_mm256_madd_epi16(both, pairs_of<1>(view)),
                                                      _mm256_set1_epi32(128)));
            }
        }
        const __m128i empty = _mm_cmpeq_epi16(
            _mm_loadu_si128(reinterpret_cast<const __m128i*>(of_across + i)), _mm_set1_epi16(-1));
        _mm_storel_epi64(reinterpret_cast<__m128i*>(samples + i),
                         _mm_andnot_si128(_mm_packs_epi16(empty, empty), result));
    }
    return i;
}

__attribute__((target("avx2"))) std::size_t fast_line(std::uint8_t* to, const std::uint8_t* a,
                                                      const std::uint8_t* b, std::size_t count)
{
    std::size_t i = 0;
    for (; i + 32 <= count; i += 32) {
        const __m256i above = vector(a + i), below = vector(b + i);
        const __m256i low = _mm256_unpacklo_epi8(above, below),
                      high = _mm256_unpackhi_epi8(above, below);
        store(to + 2 * i, _mm256_permute2x128_si256(low, high, 0x20));
        store(to + 2 * i + 32, _mm256_permute2x128_si256(low, high, 0x31));
    }
    return i;
}

#endif

} // namespace

bool has_ray_loop([[maybe_unused]] std::uint32_t view_count, [[maybe_unused]] std::uint32_t width,
                  [[maybe_unused]] std::uint32_t height, [[maybe_unused]] std::size_t view_step)
{
#ifdef INTEGRAL_HAS_AVX2
    // Indices and the step from view to view are of 15 bits, parts times a count and places of 31.
    return has_avx2() && std::max({view_count, width, height}) < 32768 && view_step < 32768 &&
           (view_count + 1) * view_step * lines_kept < 0x7fffff00;
#else
    return false;
#endif
}

int interlace_ray_row([[maybe_unused]] const RayRow& row, [[maybe_unused]] bool blend_views,
                      [[maybe_unused]] bool blend_pixels)
{
#ifdef INTEGRAL_HAS_AVX2
    if (blend_views)
        return blend_pixels ? fast_rays<true, true>(row) : fast_rays<true, false>(row);
    return blend_pixels ? fast_rays<false, true>(row) : fast_rays<false, false>(row);
#else
    return 0;
#endif
}

void make_ray_line(std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b,
                   std::size_t count)
{
    std::size_t i = 0;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        i = fast_line(to, a, b, count);
#endif
    for (; i < count; ++i) {
        to[2 * i] = a[i];
        to[2 * i + 1] = b[i];
    }
}

} // namespace integral
