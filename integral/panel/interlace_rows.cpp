// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/interlace_rows.h"

#include "integral/panel/interlace_avx2.h"

#include <type_traits>

namespace integral {
namespace {

/// Makes the samples from `first` on. `is_separable` as in PanelMapping.
template <bool is_separable, bool blends_views, bool blends_pixels, class Sample>
void make_samples(Sample* samples, const PanelRow& row, const ViewRows<Sample>& rows, int first)
{
    constexpr bool blends_rows = blends_pixels && !is_separable;
    constexpr std::uint32_t place_step = blends_rows ? 2 : 1;
    constexpr int pixel_bits = blends_rows     ? 16
                               : blends_pixels ? 8
                                               : 0,
                  bits = pixel_bits + (blends_views ? 8 : 0); // sums are 2^bits times the value
    using Sum = std::conditional_t<(bits > 16), std::uint64_t, std::uint32_t>;
    int channel = first % 3;
    for (int i = first; i < row.count; ++i, channel = channel == 2 ? 0 : channel + 1) {
        const std::uint32_t phase = is_separable
                                        ? row.across.phases.phase32[i] + row.across.phases.shift
                                        : row.across.phases[i];
        if (!is_separable && row.has_unseen && phase == PanelMapping::unseen) {
            samples[i] = 0;
            continue;
        }
        const Step across = step_among(row.across.parts, phase, blends_views);
        const Sample* view = rows.samples + std::size_t(index_of(across)) * rows.view_step;
        std::uint32_t x_weight, y_weight = 0;
        if (is_separable) {
            view += row.x_places[i];
            x_weight = row.x_weights[i] >> 16;
        } else {
            const Step x = step_among(row.x.parts, row.x.phases[i], blends_pixels);
            const Step y = step_among(row.y.parts, row.y.phases[i], blends_pixels);
            view += place_step * (3 * index_of(x) + std::uint32_t(channel)) +
                    index_of(y) % rows_kept * std::size_t(rows.row_step);
            x_weight = weight_of(x);
            y_weight = weight_of(y);
        }
        const auto pixel = [&](const Sample* at) -> Sum { // 2^pixel_bits times the value
            if (blends_rows)
                return blend<Sum>(blend<Sum>(at[0], at[1], y_weight),
                                  blend<Sum>(at[6], at[7], y_weight), x_weight);
            return blends_pixels ? blend<Sum>(at[0], at[3], x_weight) : at[0];
        };
        const Sum sum = blends_views ? blend<Sum>(pixel(view), pixel(view + rows.view_step),
                                                  weight_of(across))
                                     : pixel(view);
        samples[i] = Sample((sum + (Sum(1) << bits >> 1)) >> bits);
    }
}

template <bool is_separable, class Sample>
void make_any_samples(Sample* samples, const PanelRow& row, const ViewRows<Sample>& rows,
                      Blending blending, int first)
{
    const auto make = blending.views    ? blending.pixels
                                              ? make_samples<is_separable, true, true, Sample>
                                              : make_samples<is_separable, true, false, Sample>
                         : blending.pixels ? make_samples<is_separable, false, true, Sample>
                                        : make_samples<is_separable, false, false, Sample>;
    make(samples, row, rows, first);
}

template <class Sample>
void portable_row(Sample* samples, const PanelRow& row, const ViewRows<Sample>& rows,
                  Blending blending, int first)
{
    (row.is_separable ? make_any_samples<true, Sample>
                      : make_any_samples<false, Sample>)(samples, row, rows, blending, first);
}

template <class Sample>
void portable_blend(Sample* to, const Sample* row, const Sample* below, std::size_t first,
                    std::size_t count, std::uint32_t weight)
{
    for (std::size_t i = first; i < count; ++i)
        to[i] = Sample((blend<std::uint32_t>(row[i], below[i], weight) + 128) >> 8);
}

template <class Sample>
void portable_pairs(Sample* to, const Sample* row, const Sample* below, std::size_t first,
                    std::size_t count)
{
    for (std::size_t i = first; i < count; ++i) {
        to[2 * i] = row[i];
        to[2 * i + 1] = below[i];
    }
}

} // namespace

template <>
void pair_rows(std::uint8_t* to, const std::uint8_t* row, const std::uint8_t* below,
               std::size_t count)
{
    std::size_t done = 0;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        done = fast_pairs(to, row, below, count);
#endif
    portable_pairs(to, row, below, done, count);
}

template <>
void pair_rows(std::uint16_t* to, const std::uint16_t* row, const std::uint16_t* below,
               std::size_t count)
{
    portable_pairs(to, row, below, 0, count);
}

template <class Sample>
void blend_rows(Sample* to, const Sample* row, const Sample* below, std::size_t count, Step y)
{
    std::size_t done = 0;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2() && weight_of(y) > 0)
        done = fast_blend(to, row, below, count, weight_of(y));
#endif
    portable_blend(to, row, below, done, count, weight_of(y));
}

template void blend_rows(std::uint8_t*, const std::uint8_t*, const std::uint8_t*, std::size_t,
                         Step);
template void blend_rows(std::uint16_t*, const std::uint16_t*, const std::uint16_t*, std::size_t,
                         Step);

template <>
void interlace_row(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
                   Blending blending)
{
    int done = 0;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        done = fast_row(samples, row, rows, blending);
#endif
    portable_row(samples, row, rows, blending, done);
}

template <>
void interlace_row(std::uint16_t* samples, const PanelRow& row, const ViewRows<std::uint16_t>& rows,
                   Blending blending)
{
    portable_row(samples, row, rows, blending, 0);
}

} // namespace integral
