// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/interlace_avx2.h"

#ifdef INTEGRAL_HAS_AVX2

#include <algorithm>
#include <cstring>
#include <immintrin.h>

namespace integral {
namespace {

__attribute__((target("avx2"))) inline __m256i vector(const void* at)
{
    return _mm256_loadu_si256(static_cast<const __m256i*>(at));
}
__attribute__((target("avx2"))) inline void store(void* at, __m256i value)
{
    _mm256_storeu_si256(static_cast<__m256i*>(at), value);
}

/// Pairs of weights for madd, from the steps of EightSteps: 256 less a step's weight, and the
/// weight.
__attribute__((target("avx2"))) inline __m256i weight_pairs(__m256i steps)
{
    const __m256i twice = _mm256_setr_epi8(1, -1, 1, -1, 5, -1, 5, -1, 9, -1, 9, -1, 13, -1, 13, -1,
                                           1, -1, 1, -1, 5, -1, 5, -1, 9, -1, 9, -1, 13, -1, 13,
                                           -1);
    return _mm256_add_epi32(
        _mm256_xor_si256(_mm256_shuffle_epi8(steps, twice), _mm256_set1_epi32(255)),
        _mm256_set1_epi32(1));
}

/// One byte of each of eight numbers of 32 bits; byte 0 is the lowest.
template <int byte> __attribute__((target("avx2"))) inline __m128i bytes_of(__m256i lanes)
{
    const __m256i order = _mm256_setr_epi8(
        byte, byte + 4, byte + 8, byte + 12, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
        -1, -1, byte, byte + 4, byte + 8, byte + 12, -1, -1, -1, -1, -1, -1, -1, -1);
    const __m256i bytes = _mm256_shuffle_epi8(lanes, order);
    return _mm_or_si128(_mm256_castsi256_si128(bytes), _mm256_extracti128_si256(bytes, 1));
}

/// Fetches data from eight places: one or four bytes from each, or eight bytes from two of them. On
/// the processors where this was measured, single loads take less than half the time of gather
/// instructions, and places come faster from the halves of a register than from memory.
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

    /// One byte from each place, in the lower half of the result.
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

    /// Four bytes from each place.
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

/// Blends eight pixels with their right neighbours. Returns 256 times the values. `weights`: pairs.
__attribute__((target("avx2"))) inline __m256i blend_columns(const EightPlaces& at,
                                                             const std::uint8_t* view,
                                                             __m256i weights)
{
    const __m256i ends = _mm256_setr_epi8(0, -1, 3, -1, 4, -1, 7, -1, 8, -1, 11, -1, 12, -1, 15, -1,
                                          0, -1, 3, -1, 4, -1, 7, -1, 8, -1, 11, -1, 12, -1, 15,
                                          -1);
    return _mm256_madd_epi16(_mm256_shuffle_epi8(at.fours(view), ends), weights);
}

/// Blends four pixels and their right neighbours with the pixels below: 256 times the values, pixel
/// and neighbour alternating. `lower`, `upper`: two pixels each, as pair_rows makes them.
__attribute__((target("avx2"))) inline __m256i blend_rows(__m128i lower, __m128i upper,
                                                          __m256i weights)
{
    const __m256i ends = _mm256_setr_epi8(0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1,
                                          0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1);
    const __m256i samples = _mm256_inserti128_si256(_mm256_castsi128_si256(lower), upper, 1);
    return _mm256_madd_epi16(_mm256_shuffle_epi8(samples, ends), weights);
}

/// Blends eight pixels of a view with their neighbours. Returns 65536 times (value less 128).
__attribute__((target("avx2"))) inline __m256i blend_pixels(const EightPlaces& at,
                                                            const std::uint8_t* view,
                                                            __m256i x_weights, __m256i y_weights)
{
    const __m256i first = blend_rows(at.eights<0>(view), at.eights<4>(view),
                                     _mm256_unpacklo_epi32(y_weights, y_weights));
    const __m256i second = blend_rows(at.eights<2>(view), at.eights<6>(view),
                                      _mm256_unpackhi_epi32(y_weights, y_weights));
    // madd takes signed numbers of 16 bits, so 128 is subtracted from all values.
    const __m256i with_sign = _mm256_xor_si256(_mm256_packus_epi32(first, second),
                                               _mm256_set1_epi16(short(32768)));
    return _mm256_madd_epi16(with_sign, x_weights);
}

/// Loads eight numbers of 16 bits.
__attribute__((target("avx2"))) inline __m256i eight(const std::uint16_t* at)
{
    return _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
}

/// Computes the steps of eight subpixels, like nearest_step and linear_step, from whole phases or
/// from their upper halves. Here the upper 16 bits of a step are its neighbour's number, and bits 8
/// to 15 are the weight of the next neighbour (arbitrary if only the nearest neighbour is used).
template <bool linear> class EightSteps {
public:
    __attribute__((target("avx2"))) EightSteps(const RowAxis& axis, bool whole)
        : shift_(_mm256_set1_epi32(int(axis.phases.shift))),
          parts_(_mm256_set1_epi32(int(axis.parts | (whole ? axis.parts << 16 : 0)))),
          add_(_mm256_set1_epi32(
              int((whole ? 0 : axis.parts / 2) + (linear ? 0x8080 - 0x10000 : 0)))),
          last_(_mm256_set1_epi32(int((axis.parts - 1) << 16)))
    {
    }

    __attribute__((target("avx2"))) __m256i of_whole(const std::uint32_t* phases) const
    {
        const __m256i phase = _mm256_add_epi32(vector(phases), shift_);
        // The upper half times the parts, plus the upper half of (the lower half times the parts).
        return of_places(
            _mm256_add_epi32(_mm256_mulhi_epu16(phase, parts_),
                             _mm256_srli_epi32(_mm256_mullo_epi16(phase, parts_), 16)));
    }

    __attribute__((target("avx2"))) __m256i of_high(const std::uint16_t* phases) const
    {
        return of_places(_mm256_mullo_epi32(eight(phases), parts_));
    }

private:
    __attribute__((target("avx2"))) __m256i of_places(__m256i places) const
    {
        const __m256i steps = _mm256_add_epi32(places, add_);
        if (!linear)
            return steps;
        return _mm256_min_epi32(_mm256_max_epi32(steps, _mm256_setzero_si256()), last_);
    }

    __m256i shift_, parts_, add_, last_;
};

/// Makes eight subpixels at a time; returns the number of subpixels made. `is_separable` as in
/// PanelMapping; if false, all phases are upper halves.
template <bool is_separable, bool blends_views, bool blends_pixels>
__attribute__((target("avx2"))) int make_samples(std::uint8_t* samples, const PanelRow& row,
                                                 const ViewRows<std::uint8_t>& rows)
{
    constexpr bool blends_rows = blends_pixels && !is_separable;
    constexpr int place = blends_rows ? 2 : 1; // bytes from sample to sample
    static const std::int32_t channel_places[10] = {0,         place, 2 * place, 0,         place,
                                                    2 * place, 0,     place,     2 * place, 0};
    const EightSteps<blends_views> across_steps(row.across, is_separable);
    const EightSteps<blends_pixels> x_steps(row.x, is_separable), y_steps(row.y, is_separable);
    const bool several_rows = rows.row_step > 0; // never if is_separable
    const std::uint8_t *const views = rows.samples, *const next_views = views + rows.view_step;
    const std::uint32_t *const whole_across = row.across.phases.phase32,
                               *const x_places = row.x_places, *const x_weights = row.x_weights;
    const std::uint16_t *const across = row.across.phases.phase16, *const x = row.x.phases.phase16,
                               *const y = row.y.phases.phase16;
    const int count = row.count;
    const __m256i place_steps = _mm256_set1_epi32(int((3 * place) | rows.view_step << 16)),
                  view_step = _mm256_set1_epi32(int(rows.view_step << 16)),
                  row_step = _mm256_set1_epi32(int(rows.row_step)),
                  rows_mask = _mm256_set1_epi32(int(rows_kept - 1));
    int i = 0;
    for (int channel = 0; i + 8 <= count; i += 8, channel = channel ? channel - 1 : 2) {
        const __m256i view = is_separable ? across_steps.of_whole(whole_across + i)
                                          : across_steps.of_high(across + i);
        __m256i places, column, line;
        if (is_separable) {
            places = _mm256_add_epi32(_mm256_madd_epi16(view, view_step), vector(x_places + i));
        } else {
            column = x_steps.of_high(x + i);
            const __m256i both = _mm256_blend_epi16(_mm256_srli_epi32(column, 16), view, 0xaa);
            places = _mm256_add_epi32(_mm256_madd_epi16(both, place_steps),
                                      vector(channel_places + channel));
        }
        if (blends_rows || (!is_separable && several_rows))
            line = y_steps.of_high(y + i);
        if (!is_separable && several_rows)
            places = _mm256_add_epi32(
                places, _mm256_mullo_epi32(_mm256_and_si256(_mm256_srli_epi32(line, 16), rows_mask),
                                           row_step));
        const EightPlaces at(places);
        __m128i made;
        if (blends_rows) {
            const __m256i of_x = weight_pairs(column), of_y = weight_pairs(line);
            const __m256i left = blend_pixels(at, views, of_x, of_y);
            if (blends_views) { // rounds, and adds the 128 again
                const __m256i right = blend_pixels(at, next_views, of_x, of_y);
                const __m256i weight = _mm256_and_si256(_mm256_srli_epi32(view, 8),
                                                        _mm256_set1_epi32(255));
                const __m256i sum = _mm256_add_epi32(
                    _mm256_slli_epi32(left, 8),
                    _mm256_mullo_epi32(_mm256_sub_epi32(right, left), weight));
                made = bytes_of<3>(_mm256_add_epi32(sum, _mm256_set1_epi32(int(0x80800000))));
            } else {
                made = bytes_of<2>(_mm256_add_epi32(left, _mm256_set1_epi32(0x808000)));
            }
        } else if (blends_pixels) {
            const __m256i weights = vector(x_weights + i), left = blend_columns(at, views, weights);
            if (blends_views) { // as in blend_pixels, less 128
                const __m256i right = blend_columns(at, next_views, weights),
                              both = _mm256_blend_epi16(left, _mm256_slli_epi32(right, 16), 0xaa);
                const __m256i sum = _mm256_madd_epi16(
                    _mm256_xor_si256(both, _mm256_set1_epi16(short(32768))), weight_pairs(view));
                made = bytes_of<2>(_mm256_add_epi32(sum, _mm256_set1_epi32(0x808000)));
            } else {
                made = bytes_of<1>(_mm256_add_epi32(left, _mm256_set1_epi32(128)));
            }
        } else {
            made = at.bytes(views);
            if (blends_views) {
                const __m256i both = _mm256_cvtepu8_epi16(
                    _mm_unpacklo_epi8(made, at.bytes(next_views)));
                made = bytes_of<1>(_mm256_add_epi32(_mm256_madd_epi16(both, weight_pairs(view)),
                                                    _mm256_set1_epi32(128)));
            }
        }
        if (!is_separable) {
            const __m128i unseen = _mm_cmpeq_epi16(
                _mm_loadu_si128(reinterpret_cast<const __m128i*>(across + i)), _mm_set1_epi16(-1));
            made = _mm_andnot_si128(_mm_packs_epi16(unseen, unseen), made);
        }
        _mm_storel_epi64(reinterpret_cast<__m128i*>(samples + i), made);
    }
    return i;
}

template <bool is_separable>
int make_any_samples(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
                     Blending blending)
{
    if (blending.views)
        return blending.pixels ? make_samples<is_separable, true, true>(samples, row, rows)
                               : make_samples<is_separable, true, false>(samples, row, rows);
    return blending.pixels ? make_samples<is_separable, false, true>(samples, row, rows)
                           : make_samples<is_separable, false, false>(samples, row, rows);
}

} // namespace

int fast_row(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
             Blending blending)
{
    const auto is_high = [](const PhaseRow& phases) {
        return phases.phase16 && phases.shift == 0 && !phases.is_one;
    };
    // Numbers of views and columns, and steps from view to view, must fit 15 bits.
    if (std::max({row.across.parts, row.x.parts, row.y.parts, rows.view_step}) >= 32768)
        return 0;
    if (row.is_separable)
        return make_any_samples<true>(samples, row, rows, blending);
    if (is_high(row.across.phases) && is_high(row.x.phases) && is_high(row.y.phases) &&
        row.has_unseen)
        return make_any_samples<false>(samples, row, rows, blending);
    return 0;
}

__attribute__((target("avx2"))) std::size_t fast_pairs(std::uint8_t* to, const std::uint8_t* row,
                                                       const std::uint8_t* below, std::size_t count)
{
    std::size_t i = 0;
    for (; i + 32 <= count; i += 32) {
        const __m256i upper = vector(row + i), lower = vector(below + i);
        const __m256i first = _mm256_unpacklo_epi8(upper, lower),
                      second = _mm256_unpackhi_epi8(upper, lower);
        store(to + 2 * i, _mm256_permute2x128_si256(first, second, 0x20));
        store(to + 2 * i + 32, _mm256_permute2x128_si256(first, second, 0x31));
    }
    return i;
}

__attribute__((target("avx2"))) std::size_t fast_blend(std::uint8_t* to, const std::uint8_t* row,
                                                       const std::uint8_t* below, std::size_t count,
                                                       std::uint32_t weight)
{
    // Bytes are offset by -128, for products of unsigned weights and signed values. The sum, 256
    // times the value, just fits.
    const __m256i weights = _mm256_set1_epi16(short((256 - weight) | weight << 8)),
                  sign = _mm256_set1_epi8(char(128)), half = _mm256_set1_epi16(128);
    std::size_t i = 0;
    for (; i + 32 <= count; i += 32) {
        const __m256i upper = _mm256_xor_si256(vector(row + i), sign),
                      lower = _mm256_xor_si256(vector(below + i), sign);
        const __m256i first = _mm256_maddubs_epi16(weights, _mm256_unpacklo_epi8(upper, lower));
        const __m256i second = _mm256_maddubs_epi16(weights, _mm256_unpackhi_epi8(upper, lower));
        const __m256i both = _mm256_packs_epi16(
            _mm256_srai_epi16(_mm256_add_epi16(first, half), 8),
            _mm256_srai_epi16(_mm256_add_epi16(second, half), 8));
        store(to + i, _mm256_xor_si256(both, sign));
    }
    return i;
}

__attribute__((target("avx2"))) std::size_t fast_blend(std::uint16_t* to, const std::uint16_t* row,
                                                       const std::uint16_t* below,
                                                       std::size_t count, std::uint32_t weight)
{
    // Samples are offset by -32768, because madd multiplies signed values.
    const __m256i weights = _mm256_set1_epi32(int((256 - weight) | weight << 16)),
                  sign = _mm256_set1_epi16(short(32768)), half = _mm256_set1_epi32(128);
    std::size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const __m256i upper = _mm256_xor_si256(vector(row + i), sign),
                      lower = _mm256_xor_si256(vector(below + i), sign);
        const __m256i first = _mm256_madd_epi16(weights, _mm256_unpacklo_epi16(upper, lower));
        const __m256i second = _mm256_madd_epi16(weights, _mm256_unpackhi_epi16(upper, lower));
        const __m256i both = _mm256_packs_epi32(
            _mm256_srai_epi32(_mm256_add_epi32(first, half), 8),
            _mm256_srai_epi32(_mm256_add_epi32(second, half), 8));
        store(to + i, _mm256_xor_si256(both, sign));
    }
    return i;
}

} // namespace integral

#endif
