// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/interlace_rays.h"

#include "integral/output/interlace_avx2.h"

namespace integral {
namespace {

#ifdef INTEGRAL_HAS_AVX2

/// Steps among `count` equal parts, of RayMapping's parts, by 32 bits: linear_step and nearest_step of phase_of_part exactly. With part p,
/// phase times count, and what is added for rounding, is p count 65537 + sum; what is kept of it, divided by 65536, is p count + (p count + sum)/65536.
class Steps {
public:
    __attribute__((target("avx2"))) Steps(std::uint32_t parts, bool linear)
    {
        const std::uint64_t sum = parts * std::uint64_t(32768) + (linear ? 0x80800000u : 0u);
        count = _mm256_set1_epi32(int(parts));
        high = _mm256_set1_epi32(int(sum >> 16));
        low = _mm256_set1_epi32(int(sum & 65535));
        last = _mm256_set1_epi32(int(parts << 8));
    }

    __attribute__((target("avx2"))) __m256i nearest(__m256i parts) const { return _mm256_srli_epi32(kept(parts), 16); }

    /// 256 times the index, and the weight of the next in the lowest 8 bits.
    __attribute__((target("avx2"))) __m256i linear(__m256i parts) const
    {
        const __m256i whole = _mm256_set1_epi32(256);
        return _mm256_sub_epi32(_mm256_min_epu32(_mm256_max_epu32(_mm256_srli_epi32(kept(parts), 8), whole), last), whole);
    }

private:
    __attribute__((target("avx2"))) __m256i kept(__m256i parts) const
    {
        const __m256i product = _mm256_mullo_epi32(parts, count);
        return _mm256_add_epi32(_mm256_add_epi32(product, high), _mm256_srli_epi32(_mm256_add_epi32(product, low), 16));
    }
    __m256i count, high, low, last;
};

__attribute__((target("avx2"))) inline __m256i eight(const std::uint16_t* at)
{
    return _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
}

/// Pixels in lines of two rows: each the sums, less 128 times 256, of its two and of the next pixel's two samples by weights.
__attribute__((target("avx2"))) inline __m256i of_two_rows(__m128i lower, __m128i upper, __m256i weights)
{
    const __m256i ends = _mm256_setr_epi8(0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1,
                                          0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1);
    const __m256i samples = _mm256_inserti128_si256(_mm256_castsi128_si256(lower), upper, 1);
    return _mm256_sub_epi32(_mm256_madd_epi16(_mm256_shuffle_epi8(samples, ends), weights), _mm256_set1_epi32(32768));
}

/// Eight pixels blended: 65536 times their values less 128.
__attribute__((target("avx2"))) inline __m256i of_four(const EightPlaces& at, const std::uint8_t* lines, __m256i x_weights, __m256i y_weights)
{
    const __m256i first = of_two_rows(at.eights<0>(lines), at.eights<4>(lines), _mm256_unpacklo_epi32(y_weights, y_weights));
    const __m256i second = of_two_rows(at.eights<2>(lines), at.eights<6>(lines), _mm256_unpackhi_epi32(y_weights, y_weights));
    return _mm256_madd_epi16(_mm256_packs_epi32(first, second), x_weights);
}

template <bool blend_views, bool blend_pixels> __attribute__((target("avx2"))) int fast_rays(const RayRow& row)
{
    static const std::int32_t channel_of[] = {0, 1, 2, 0, 1, 2, 0, 1, 2, 0};
    const Steps view_steps(row.view_count, blend_views), x_steps(row.width, blend_pixels), y_steps(row.height, blend_pixels);
    const std::uint8_t* next_lines = row.lines + std::size_t(row.width) * 3 * (blend_pixels ? 2 : 1); // of the next view
    const __m256i byte = _mm256_set1_epi32(255), view_step = _mm256_set1_epi32(int(row.width * 3)), line_step = _mm256_set1_epi32(int(row.line_step));
    const __m256i of_lines = _mm256_set1_epi32(int(lines_kept - 1));
    int i = 0;
    for (int channel = 0; i + 8 <= row.count; i += 8, channel = channel ? channel - 1 : 2) {
        const __m256i across = eight(row.across + i);
        __m256i x, y, view, x_weights, y_weights;
        if (blend_pixels) {
            x = x_steps.linear(eight(row.x + i));
            y = y_steps.linear(eight(row.y + i));
            x_weights = pairs(_mm256_and_si256(x, byte));
            y_weights = pairs(_mm256_and_si256(y, byte));
            x = _mm256_srli_epi32(x, 8);
            y = _mm256_srli_epi32(y, 8);
        } else {
            x = x_steps.nearest(eight(row.x + i));
            y = y_steps.nearest(eight(row.y + i));
        }
        __m256i view_weight;
        if (blend_views) {
            view = view_steps.linear(across);
            view_weight = _mm256_and_si256(view, byte);
            view = _mm256_srli_epi32(view, 8);
        } else {
            // What no eye sees may be past the last view.
            view = _mm256_min_epu32(view_steps.nearest(across), _mm256_set1_epi32(int(row.view_count - 1)));
        }
        __m256i place = _mm256_add_epi32(_mm256_mullo_epi32(view, view_step), _mm256_add_epi32(x, _mm256_add_epi32(x, x)));
        place = _mm256_add_epi32(place, vector(channel_of + channel));
        if (blend_pixels)
            place = _mm256_add_epi32(place, place);
        place = _mm256_add_epi32(place, _mm256_mullo_epi32(_mm256_and_si256(y, of_lines), line_step));
        const EightPlaces at(place);
        __m128i result;
        if (blend_pixels) {
            const __m256i left = of_four(at, row.lines, x_weights, y_weights);
            if (blend_views) {
                const __m256i right = of_four(at, next_lines, x_weights, y_weights);
                const __m256i sum = _mm256_add_epi32(_mm256_slli_epi32(left, 8), _mm256_mullo_epi32(_mm256_sub_epi32(right, left), view_weight));
                result = bytes_of<3>(_mm256_add_epi32(sum, _mm256_set1_epi32(1 << 23)));
            } else {
                result = bytes_of<2>(_mm256_add_epi32(left, _mm256_set1_epi32(1 << 15)));
            }
            result = _mm_xor_si128(result, _mm_set1_epi8(char(128)));
        } else {
            result = at.bytes(row.lines);
            if (blend_views) {
                const __m256i both = _mm256_cvtepu8_epi16(_mm_unpacklo_epi8(result, at.bytes(next_lines)));
                result = bytes_of<1>(_mm256_add_epi32(_mm256_madd_epi16(both, pairs(view_weight)), _mm256_set1_epi32(128)));
            }
        }
        const __m128i empty = _mm_cmpeq_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(row.across + i)), _mm_set1_epi16(-1));
        _mm_storel_epi64(reinterpret_cast<__m128i*>(row.samples + i), _mm_andnot_si128(_mm_packs_epi16(empty, empty), result));
    }
    return i;
}

__attribute__((target("avx2"))) std::size_t fast_line(std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b, std::size_t count)
{
    std::size_t i = 0;
    for (; i + 32 <= count; i += 32) {
        const __m256i above = vector(a + i), below = vector(b + i);
        const __m256i low = _mm256_unpacklo_epi8(above, below), high = _mm256_unpackhi_epi8(above, below);
        store(to + 2 * i, _mm256_permute2x128_si256(low, high, 0x20));
        store(to + 2 * i + 32, _mm256_permute2x128_si256(low, high, 0x31));
    }
    return i;
}

#endif

} // namespace

bool has_ray_loop(std::uint32_t view_count, std::uint32_t width, std::uint32_t height)
{
#ifdef INTEGRAL_HAS_AVX2
    // Parts times a count stay within 31 bits, and so do places.
    return has_avx2() && view_count < 32768 && width < 32768 && height < 32768
           && (view_count + 1) * std::uint64_t(width) * 6 * lines_kept < 0x7fffffff;
#else
    return false;
#endif
}

int interlace_ray_row(const RayRow& row, bool blend_views, bool blend_pixels)
{
#ifdef INTEGRAL_HAS_AVX2
    if (blend_views)
        return blend_pixels ? fast_rays<true, true>(row) : fast_rays<true, false>(row);
    return blend_pixels ? fast_rays<false, true>(row) : fast_rays<false, false>(row);
#else
    return 0;
#endif
}

void make_ray_line(std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b, std::size_t count)
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
