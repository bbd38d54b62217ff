// SPDX-License-Identifier: AGPL-3.0-or-later
// Inner loops of interlacing, over the subpixels of a panel's row. Every loop has a portable form,
// and on machines with AVX2 a fast one that gives the same bits.
#ifndef INTEGRAL_PANEL_INTERLACE_ROWS_H
#define INTEGRAL_PANEL_INTERLACE_ROWS_H

#include "integral/panel/panel_mapping.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace integral {

/// A neighbour (view, or pixel of a view) and the weight of the next one: 256 times the neighbour's
/// number, plus the weight in 1/256. The weight after the last neighbour is 0.
using Step = std::uint32_t;
inline std::uint32_t index_of(Step step) { return step >> 8; }
inline std::uint32_t weight_of(Step step) { return step & 255; }

/// The part that contains a phase, among `parts` equal parts of the range. `parts`: below 2^24.
inline Step nearest_step(std::uint32_t phase, std::uint32_t parts)
{
    return Step((std::uint64_t(phase) * parts) >> 32) << 8;
}

/// The two of `parts` equal parts whose middles are on either side of a phase. Beyond the outermost
/// middles, the outermost part alone.
inline Step linear_step(std::uint32_t phase, std::uint32_t parts)
{
    // The phase in 2^-32 of a part. Half a part is added, so that the upper 32 bits are the number
    // of the later of the two parts; half a step of the weight is added for rounding.
    const std::uint64_t at = std::uint64_t(phase) * parts + 0x80800000u;
    if (at >> 32 == 0)
        return 0;
    return at >> 32 == parts ? (parts - 1) << 8 : Step(at >> 24) - 256;
}

inline Step step_among(std::uint32_t parts, std::uint32_t phase, bool linear)
{
    return linear ? linear_step(phase, parts) : nearest_step(phase, parts);
}

/// One axis (the views, or across or down a view's picture): the phases of a panel's row, and the
/// number of equal parts of the range that they select from.
struct RowAxis {
    PhaseRow phases;
    std::uint32_t parts;
};

/// The subpixels of a panel's row.
struct PanelRow {
    int count; ///< of subpixels
    RowAxis across, x, y;
    /// For a separable mapping, computed once for all rows: each sample's place in a row of a
    /// view's picture; the weights of sample and right neighbour, 256 - w + 65536 * w.
    const std::uint32_t *x_places, *x_weights;
    bool has_unseen, is_separable; ///< as in PanelMapping
};

/// Rows of all views' pictures, close together. Row k of view v begins at
/// samples + (k % rows_kept) * row_step + v * view_step; if row_step is 0, there is one row. If
/// pixels are blended, the one row of a separable mapping is already blended from two rows of the
/// picture; for other mappings, each sample is followed by the sample below it. One further view,
/// and eight samples more, must be readable: they get the weight 0. All places are below 2^31,
/// views narrower than 32768 pixels.
template <class Sample> struct ViewRows {
    const Sample* samples;
    std::uint32_t view_step, row_step; ///< samples
};
constexpr std::uint32_t rows_kept = 4; ///< a power of two

/// to[2 i] = row[i], to[2 i + 1] = below[i].
template <class Sample>
void pair_rows(Sample* to, const Sample* row, const Sample* below, std::size_t count);

/// Blends row[i] and below[i] into to[i] by the weight of a step, rounded.
template <class Sample>
void blend_rows(Sample* to, const Sample* row, const Sample* below, std::size_t count, Step y);

/// Whether neighbouring views and neighbouring pixels are blended.
struct Blending {
    bool views, pixels;
};

/// 256 times the value between two neighbours. `Sum` is unsigned: if b < a, the difference wraps
/// around, and the sum wraps back.
template <class Sum> Sum blend(Sum a, Sum b, std::uint32_t weight)
{
    return a * 256 + (b - a) * weight;
}

/// Fills the samples of a panel's row; unseen samples become 0. `rows` must contain all rows of
/// pixels that the panel's row shows.
template <class Sample>
void interlace_row(Sample* samples, const PanelRow& row, const ViewRows<Sample>& rows,
                   Blending blending);

} // namespace integral

#endif
