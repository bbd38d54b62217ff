// SPDX-License-Identifier: AGPL-3.0-or-later
// The inner loops of interlacing: what is done to each subpixel of a panel's row. Every
// loop has a portable form, and where the machine has AVX2 a fast one that gives the same bits.
#ifndef INTEGRAL_OUTPUT_INTERLACE_ROWS_H
#define INTEGRAL_OUTPUT_INTERLACE_ROWS_H

#include "integral/output/panel_mapping.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace integral {

/// Which of several neighbours (views, or pixels of a view) is taken, and the weight of the one
/// after it: 256 times the neighbour's number, plus the weight in 1/256. The weight of the last
/// neighbour is 0.
using Step = std::uint32_t;
inline std::uint32_t index_of(Step step) { return step >> 8; }
inline std::uint32_t weight_of(Step step) { return step & 255; }

/// The one of `parts` equal parts of the range in which a phase is. `parts`: below 2^24.
inline Step nearest_step(std::uint32_t phase, std::uint32_t parts)
{
    return Step((std::uint64_t(phase) * parts) >> 32) << 8;
}

/// The two of `parts` equal parts whose middles are on either side of a phase; beyond the middle of
/// an outermost part, that part alone.
inline Step linear_step(std::uint32_t phase, std::uint32_t parts)
{
    // Where the later one begins, in 2^-32 of a part, and half a weight more for rounding.
    const std::uint64_t at = std::uint64_t(phase) * parts + 0x80800000u;
    if (at >> 32 == 0)
        return 0;
    return at >> 32 == parts ? (parts - 1) << 8 : Step(at >> 24) - 256;
}

inline Step step_among(std::uint32_t parts, std::uint32_t phase, bool linear)
{
    return linear ? linear_step(phase, parts) : nearest_step(phase, parts);
}

/// Along one axis (the views, or across or down a view's picture): the phases of a panel's row, and
/// among how many equal parts of the range they choose.
struct RowAxis {
    PhaseRow phases;
    std::uint32_t parts;
};

/// The subpixels of a panel's row.
struct PanelRow {
    int count; ///< of subpixels
    RowAxis across, x, y;
    /// Of a plain mapping, what x comes to, worked out once for all rows: the sample's place in a
    /// row of a view's picture, and the weights of it and of its right neighbour,
    /// 256 - w + 65536 * w.
    const std::uint32_t *x_places, *x_weights;
    bool has_unseen, is_plain; ///< as in PanelMapping
};

/// Rows of all views' pictures, close together. Row k of view v begins at
/// samples + (k % rows_kept) * row_step + v * view_step; where row_step is 0 there is one row.
/// Where pixels are blended, that one row of a plain mapping is already what lies between two rows
/// of the picture; with another mapping each sample is followed by the one below it. A view after
/// the last, and eight samples more, must be readable: they get the weight 0. All places are below
/// 2^31, views narrower than 32768 pixels.
template <class Sample> struct ViewRows {
    const Sample* samples;
    std::uint32_t view_step, row_step; ///< samples
};
constexpr std::uint32_t rows_kept = 4; ///< a power of two

/// to[2 i] = row[i], to[2 i + 1] = below[i].
template <class Sample>
void pair_rows(Sample* to, const Sample* row, const Sample* below, std::size_t count);

/// to[i]: what is between row[i] and below[i] by the weight of a step, rounded.
template <class Sample>
void blend_rows(Sample* to, const Sample* row, const Sample* below, std::size_t count, Step y);

/// Which neighbours are blended.
struct Blending {
    bool views, pixels;
};

/// 256 times the value between two neighbours. `Sum` is unsigned: where b < a the difference wraps
/// around, and the sum wraps back.
template <class Sum> Sum blend(Sum a, Sum b, std::uint32_t weight)
{
    return a * 256 + (b - a) * weight;
}

/// Fills the samples of a panel's row; what is unseen becomes 0. `rows` must have all rows of
/// pixels that it shows.
template <class Sample>
void interlace_row(Sample* samples, const PanelRow& row, const ViewRows<Sample>& rows,
                   Blending blending);

} // namespace integral

#endif
