// SPDX-License-Identifier: AGPL-3.0-or-later
// The inner loops of interlacing: what is done to each subpixel of a panel's row. Every
// loop has a plain form, and where the machine has AVX2 a fast one that gives the same bits.
#ifndef INTEGRAL_OUTPUT_INTERLACE_ROWS_H
#define INTEGRAL_OUTPUT_INTERLACE_ROWS_H

#include "integral/output/panel_mapping.h"

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
Step nearest_step(std::uint32_t phase, std::uint32_t parts);

/// The two of `parts` equal parts whose middles are on either side of a phase; beyond the middle of
/// an outermost part, that part alone.
Step linear_step(std::uint32_t phase, std::uint32_t parts);

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
    const Step* x_steps; ///< of x; null: they have not been worked out
    bool has_unseen;     ///< as in PanelMapping
};

/// Rows of all views' pictures, close together. Row k of view v begins at
/// samples + (k % rows_kept) * row_step + v * view_step; where row_step is 0 there is one row.
/// Where pixels are blended, each of its samples is followed by the one below it in the picture. A
/// view after the last, and eight samples more, must be readable: they get the weight 0. All places
/// are below 2^31, views narrower than 32768 pixels.
template <class Sample> struct ViewRows {
    const Sample* samples;
    std::uint32_t view_step, row_step; ///< samples
};
constexpr std::uint32_t rows_kept = 4; ///< a power of two

/// to[2 i] = row[i], to[2 i + 1] = below[i].
template <class Sample>
void pair_rows(Sample* to, const Sample* row, const Sample* below, std::size_t count);

/// How samples are made.
struct Blending {
    bool views, pixels;
    /// The two rows of pixels are blended first and rounded to whole values, as where all of a
    /// panel's row shows one height of the picture. Else the result alone is rounded.
    bool rounds_rows;
};

/// The least and the greatest of `count` numbers, which are not none.
struct Range {
    std::uint16_t least, greatest;
};
Range range_of(const std::uint16_t* numbers, int count);

/// 256 times the value between two neighbours.
inline std::uint64_t blend(std::uint64_t a, std::uint64_t b, Step step)
{
    return a * (256 - weight_of(step)) + b * weight_of(step);
}
/// 65536 times the value between four neighbouring pixels.
inline std::uint64_t blend_pixels(std::uint64_t pixel, std::uint64_t below, std::uint64_t right,
                                  std::uint64_t below_right, Step x, Step y, bool rounds_rows)
{
    std::uint64_t left_sum = blend(pixel, below, y), right_sum = blend(right, below_right, y);
    if (rounds_rows) {
        left_sum = (left_sum + 128) & ~std::uint64_t(255);
        right_sum = (right_sum + 128) & ~std::uint64_t(255);
    }
    return blend(left_sum, right_sum, x);
}

/// Fills the samples of a panel's row; what is unseen becomes 0. `rows` must have all rows of
/// pixels that it shows.
template <class Sample>
void interlace_row(Sample* samples, const PanelRow& row, const ViewRows<Sample>& rows,
                   Blending blending);

} // namespace integral

#endif
