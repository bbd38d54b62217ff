// SPDX-License-Identifier: AGPL-3.0-or-later
// The inner loops of interlacing.
#ifndef INTEGRAL_OUTPUT_INTERLACE_ROWS_H
#define INTEGRAL_OUTPUT_INTERLACE_ROWS_H

#include <cstddef>
#include <cstdint>

namespace integral {

/// One of several neighbours, and the weight of the next one, in 1/256: 0 for the last.
struct Step {
    std::uint32_t index, weight;
};

/// Of `count` equal parts of a range of 2^32: the one that a phase is in.
inline Step nearest_step(std::uint32_t phase, std::uint32_t count)
{
    return {std::uint32_t((std::uint64_t(phase) * count) >> 32), 0};
}

/// The two whose middles are on either side of the phase; beyond the outermost middles, these
/// alone.
inline Step linear_step(std::uint32_t phase, std::uint32_t count)
{
    // Half a part less, and half a weight more for rounding; a part more, for what is before the
    // first middle.
    const std::uint64_t at = std::uint64_t(phase) * count + 0x80800000u;
    const std::uint32_t next = std::uint32_t(at >> 32);
    if (next == 0)
        return {0, 0};
    return {next - 1, next == count ? 0 : std::uint32_t(at >> 24) & 255};
}

/// The samples of a row of a panel.
template <class Sample> struct InterlacedRow {
    Sample* samples;
    int count;                   ///< of them
    const std::uint32_t* phases; ///< one a sample
    std::uint32_t phase;         ///< to be added to them
    const Sample* views; ///< a row of each view's picture, one after the other, and samples for one
                         ///< more view
    std::uint32_t view_step; ///< samples from view to view
    std::uint32_t view_count;
    const std::uint32_t* places;  ///< in a view's row, one a sample,
    const std::uint32_t* weights; ///< and 65536 times the weight of the sample three farther on, in
                                  ///< 1/256, with what is left of 256
};

/// Fills it, by a plain loop; and for 8 bits by whatever the machine has that is faster, to the
/// same bits.
template <class Sample>
void interlace_row_portably(const InterlacedRow<Sample>& row, bool blend_views, bool blend_pixels);
template <class Sample>
void interlace_row(const InterlacedRow<Sample>& row, bool blend_views, bool blend_pixels);

/// to[i] = a[i] + (b[i] - a[i]) weight/256, rounded. `weight`: 0 to 255.
template <class Sample>
void blend_rows_portably(Sample* to, const Sample* a, const Sample* b, std::size_t count,
                         std::uint32_t weight);
template <class Sample>
void blend_rows(Sample* to, const Sample* a, const Sample* b, std::size_t count,
                std::uint32_t weight);

} // namespace integral

#endif
