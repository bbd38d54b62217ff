// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/interlace_rows.h"

#include "integral/output/interlace_avx2.h"

#include <algorithm>

namespace integral {
namespace {

/// Where a phase is among `parts` equal parts of the range, in 2^-16 of a part.
std::uint64_t place_among(std::uint32_t phase, std::uint32_t parts)
{
    return std::uint64_t(phase) * parts >> 16;
}

/// One sample, of one or two views.
template <class Sample>
Sample sample_of(const Sample* view, std::uint32_t view_step, Step across, Step x, Step y,
                 Blending blending)
{
    const auto pixel = [&](const Sample* at) -> std::uint64_t { // 2^16 times the value
        return blending.pixels
                   ? blend_pixels(at[0], at[1], at[6], at[7], x, y, blending.rounds_rows)
                   : std::uint64_t(at[0]) << 16;
    };
    const std::uint64_t sum = blending.views ? blend(pixel(view), pixel(view + view_step), across)
                                             : pixel(view) << 8;
    return Sample((sum + (1 << 23)) >> 24);
}

/// The samples from `first` on.
template <class Sample>
void plain_row(Sample* samples, const PanelRow& row, const ViewRows<Sample>& rows,
               Blending blending, int first)
{
    const std::uint32_t samples_a_place = blending.pixels ? 2 : 1;
    for (int i = first; i < row.count; ++i) {
        const std::uint32_t phase = row.across.phases[i];
        if (row.has_unseen && phase == PanelMapping::unseen) {
            samples[i] = 0;
            continue;
        }
        const Step across = step_among(row.across.parts, phase, blending.views),
                   x = step_among(row.x.parts, row.x.phases[i], blending.pixels),
                   y = step_among(row.y.parts, row.y.phases[i], blending.pixels);
        const std::size_t place = std::size_t(index_of(across)) * rows.view_step +
                                  samples_a_place * (3 * index_of(x) + i % 3) +
                                  index_of(y) % rows_kept * std::size_t(rows.row_step);
        samples[i] = sample_of(rows.samples + place, rows.view_step, across, x, y, blending);
    }
}

template <class Sample>
void plain_pairs(Sample* to, const Sample* row, const Sample* below, std::size_t first,
                 std::size_t count)
{
    for (std::size_t i = first; i < count; ++i) {
        to[2 * i] = row[i];
        to[2 * i + 1] = below[i];
    }
}

} // namespace

Step nearest_step(std::uint32_t phase, std::uint32_t parts)
{
    return Step(place_among(phase, parts) >> 16) << 8;
}

Step linear_step(std::uint32_t phase, std::uint32_t parts)
{
    // Half a part less, and half a weight more for rounding; and one part more, which keeps what is
    // before the first middle above 0 until it is cut off.
    const Step step = Step((place_among(phase, parts) + 0x8080) >> 8);
    return std::min(std::max(step, Step(256)), parts << 8) - 256;
}

Range range_of(const std::uint16_t* numbers, int count)
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return fast_range(numbers, count);
#endif
    const auto [least, greatest] = std::minmax_element(numbers, numbers + count);
    return {*least, *greatest};
}

template <>
void pair_rows(std::uint8_t* to, const std::uint8_t* row, const std::uint8_t* below,
               std::size_t count)
{
    std::size_t done = 0;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        done = fast_pairs(to, row, below, count);
#endif
    plain_pairs(to, row, below, done, count);
}

template <>
void pair_rows(std::uint16_t* to, const std::uint16_t* row, const std::uint16_t* below,
               std::size_t count)
{
    plain_pairs(to, row, below, 0, count);
}

template <>
void interlace_row(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
                   Blending blending)
{
    int done = 0;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        done = fast_row(samples, row, rows, blending);
#endif
    plain_row(samples, row, rows, blending, done);
}

template <>
void interlace_row(std::uint16_t* samples, const PanelRow& row, const ViewRows<std::uint16_t>& rows,
                   Blending blending)
{
    plain_row(samples, row, rows, blending, 0);
}

} // namespace integral
