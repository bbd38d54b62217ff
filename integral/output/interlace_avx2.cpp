// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/interlace_avx2.h"

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

/// Pairs of weights for madd from the weights of eight steps: what is left of 256, and the weight.
__attribute__((target("avx2"))) inline __m256i weight_pairs(__m256i steps)
{
    const __m256i twice = _mm256_setr_epi8(0, -1, 0, -1, 4, -1, 4, -1, 8, -1, 8, -1, 12, -1, 12, -1,
                                           0, -1, 0, -1, 4, -1, 4, -1, 8, -1, 8, -1, 12, -1, 12,
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

/// Fetches what lies at eight places: a byte of each, or of two places eight bytes. Loads one by
/// one take less than half the time of gather instructions on the processors on which this was
/// measured, and taking the places from halves of a register less than from memory.
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

    std::uint64_t two_[4];
};

/// The two rows of four pixels and of their right neighbours, blended: 256 times the values, in
/// turns. `lower`, `upper`: two pixels each, as pair_rows has made them.
template <bool rounds_rows>
__attribute__((target("avx2"))) inline __m256i blend_rows(__m128i lower, __m128i upper,
                                                          __m256i weights)
{
    const __m256i ends = _mm256_setr_epi8(0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1,
                                          0, -1, 1, -1, 6, -1, 7, -1, 8, -1, 9, -1, 14, -1, 15, -1);
    const __m256i samples = _mm256_inserti128_si256(_mm256_castsi128_si256(lower), upper, 1);
    const __m256i sums = _mm256_madd_epi16(_mm256_shuffle_epi8(samples, ends), weights);
    if (!rounds_rows)
        return sums;
    return _mm256_and_si256(_mm256_add_epi32(sums, _mm256_set1_epi32(128)),
                            _mm256_set1_epi32(~255));
}

/// Eight pixels of a view, blended: 65536 times their values less 128.
template <bool rounds_rows>
__attribute__((target("avx2"))) inline __m256i blend_pixels(const EightPlaces& at,
                                                            const std::uint8_t* view,
                                                            __m256i x_weights, __m256i y_weights)
{
    const __m256i first = blend_rows<rounds_rows>(at.eights<0>(view), at.eights<4>(view),
                                                  _mm256_unpacklo_epi32(y_weights, y_weights));
    const __m256i second = blend_rows<rounds_rows>(at.eights<2>(view), at.eights<6>(view),
                                                   _mm256_unpackhi_epi32(y_weights, y_weights));
    // madd takes numbers of 16 bits with a sign, so 128 is taken away from all values.
    const __m256i with_sign = _mm256_xor_si256(_mm256_packus_epi32(first, second),
                                               _mm256_set1_epi16(short(32768)));
    return _mm256_madd_epi16(with_sign, x_weights);
}

/// Eight numbers of 16 bits.
__attribute__((target("avx2"))) inline __m256i eight(const std::uint16_t* at)
{
    return _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
}

/// Makes the steps of eight subpixels, as nearest_step and linear_step do. `published`: phases of
/// 32 bits with a shift; else of 16 bits without.
template <bool published, bool linear> class EightSteps {
public:
    __attribute__((target("avx2"))) explicit EightSteps(const RowAxis& axis)
        : high_(axis.phases.high),
          low_(axis.phases.low),
          shift_(_mm256_set1_epi32(int(axis.phases.shift))),
          parts_(_mm256_set1_epi32(int(axis.parts))),
          add_(_mm256_set1_epi32(int((published ? 0 : axis.parts / 2) + (linear ? 0x8080 : 0)))),
          last_(_mm256_set1_epi32(int(axis.parts << 8)))
    {
    }

    /// Those of subpixels from i on.
    __attribute__((target("avx2"))) __m256i of(int i) const
    {
        __m256i place = eight(high_ + i);
        if (published) {
            const __m256i phase = _mm256_add_epi32(
                _mm256_or_si256(_mm256_slli_epi32(place, 16), eight(low_ + i)), shift_);
            place = _mm256_add_epi32(_mm256_mullo_epi32(_mm256_srli_epi32(phase, 16), parts_),
                                     _mm256_mulhi_epu16(phase, parts_));
        } else {
            place = _mm256_mullo_epi32(place, parts_);
        }
        const __m256i step = _mm256_srli_epi32(_mm256_add_epi32(place, add_), 8),
                      whole = _mm256_set1_epi32(256);
        if (!linear)
            return _mm256_andnot_si256(_mm256_set1_epi32(255), step);
        return _mm256_sub_epi32(_mm256_min_epu32(_mm256_max_epu32(step, whole), last_), whole);
    }

private:
    const std::uint16_t *high_, *low_;
    __m256i shift_, parts_, add_, last_;
};

/// Eight subpixels at a time; returns how many are done.
template <bool blends_views, bool blends_pixels, bool published>
__attribute__((target("avx2"))) int make_samples(std::uint8_t* samples, const PanelRow& row,
                                                 const ViewRows<std::uint8_t>& rows)
{
    constexpr int place = blends_pixels ? 2 : 1; // bytes from sample to sample
    static const std::int32_t channel_places[10] = {0,         place, 2 * place, 0,         place,
                                                    2 * place, 0,     place,     2 * place, 0};
    const EightSteps<published, blends_views> across(row.across);
    const EightSteps<false, blends_pixels> x(row.x); // where not `published`
    const EightSteps<false, blends_pixels> y(row.y);
    const bool several_rows = rows.row_step > 0; // never where `published`
    const Step* const x_steps = row.x_steps;
    const __m256i y_of_all = _mm256_set1_epi32(
        int(step_among(row.y.parts, row.y.phases[0], blends_pixels)));
    const std::uint8_t *const views = rows.samples, *const next_views = views + rows.view_step;
    const std::uint16_t* const high = row.across.phases.high;
    const int count = row.count;
    const __m256i place_steps = _mm256_set1_epi32(int((3 * place) | rows.view_step << 16)),
                  row_step = _mm256_set1_epi32(int(rows.row_step)),
                  rows_mask = _mm256_set1_epi32(int(rows_kept - 1));
    int i = 0;
    for (int channel = 0; i + 8 <= count; i += 8, channel = channel ? channel - 1 : 2) {
        const __m256i view = across.of(i), column = published ? vector(x_steps + i) : x.of(i);
        const __m256i line = published || !(blends_pixels || several_rows) ? y_of_all : y.of(i);
        __m256i places = _mm256_madd_epi16( // of the view and the column
            _mm256_blend_epi16(_mm256_srli_epi32(column, 8), _mm256_slli_epi32(view, 8), 0xaa),
            place_steps);
        if (!published && several_rows)
            places = _mm256_add_epi32(
                places, _mm256_mullo_epi32(_mm256_and_si256(_mm256_srli_epi32(line, 8), rows_mask),
                                           row_step));
        const EightPlaces at(_mm256_add_epi32(places, vector(channel_places + channel)));
        __m128i made;
        if (blends_pixels) {
            const __m256i x_weights = weight_pairs(column), y_weights = weight_pairs(line);
            const __m256i left = blend_pixels<published>(at, views, x_weights, y_weights);
            if (blends_views) { // rounded, and with the 128 that they are less
                const __m256i right = blend_pixels<published>(at, next_views, x_weights, y_weights);
                const __m256i weight = _mm256_and_si256(view, _mm256_set1_epi32(255));
                const __m256i sum = _mm256_add_epi32(
                    _mm256_slli_epi32(left, 8),
                    _mm256_mullo_epi32(_mm256_sub_epi32(right, left), weight));
                made = bytes_of<3>(_mm256_add_epi32(sum, _mm256_set1_epi32(int(0x80800000))));
            } else {
                made = bytes_of<2>(_mm256_add_epi32(left, _mm256_set1_epi32(0x808000)));
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
        if (!published) {
            const __m128i unseen = _mm_cmpeq_epi16(
                _mm_loadu_si128(reinterpret_cast<const __m128i*>(high + i)), _mm_set1_epi16(-1));
            made = _mm_andnot_si128(_mm_packs_epi16(unseen, unseen), made);
        }
        _mm_storel_epi64(reinterpret_cast<__m128i*>(samples + i), made);
    }
    return i;
}

template <bool published>
int make_any_samples(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
                     Blending blending)
{
    if (blending.views)
        return blending.pixels ? make_samples<true, true, published>(samples, row, rows)
                               : make_samples<true, false, published>(samples, row, rows);
    return blending.pixels ? make_samples<false, true, published>(samples, row, rows)
                           : make_samples<false, false, published>(samples, row, rows);
}

} // namespace

int fast_row(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
             Blending blending)
{
    const auto is_short = [](const PhaseRow& phases) {
        return !phases.low && phases.shift == 0 && !phases.is_one;
    };
    // Numbers of views and columns, and steps from view to view, are taken by 15 bits.
    if (std::max({row.across.parts, row.x.parts, row.y.parts, rows.view_step}) >= 32768)
        return 0;
    const PhaseRow &across = row.across.phases, &x = row.x.phases, &y = row.y.phases;
    if (across.low && row.x_steps && y.is_one && blending.rounds_rows && !row.has_unseen)
        return make_any_samples<true>(samples, row, rows, blending);
    if (is_short(across) && is_short(x) && is_short(y) && !blending.rounds_rows && row.has_unseen)
        return make_any_samples<false>(samples, row, rows, blending);
    return 0;
}

__attribute__((target("avx2"))) Range fast_range(const std::uint16_t* numbers, int count)
{
    Range range{numbers[0], numbers[0]};
    int i = 0;
    __m256i least = _mm256_set1_epi16(short(numbers[0])), greatest = least;
    for (; i + 16 <= count; i += 16) {
        least = _mm256_min_epu16(least, vector(numbers + i));
        greatest = _mm256_max_epu16(greatest, vector(numbers + i));
    }
    std::uint16_t leasts[16], greatests[16];
    store(leasts, least);
    store(greatests, greatest);
    for (int k = 0; k < 16; ++k) {
        range.least = std::min(range.least, leasts[k]);
        range.greatest = std::max(range.greatest, greatests[k]);
    }
    for (; i < count; ++i) {
        range.least = std::min(range.least, numbers[i]);
        range.greatest = std::max(range.greatest, numbers[i]);
    }
    return range;
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

} // namespace integral

#endif
