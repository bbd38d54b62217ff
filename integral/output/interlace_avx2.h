// SPDX-License-Identifier: AGPL-3.0-or-later
// The loops of interlacing for processors with AVX2, for views of 8 bits, and the blending of rows
// of 16 bits. Where INTEGRAL_HAS_AVX2 is not defined there are none.
//
// Plain loops that gcc 12 compiled to AVX-512 code took 1.25 to 1.6 times the processor time of
// AVX2 loops (bench/interlace_speed, on a busy machine): most of the work is fetching samples, and
// the compiler does not use vector instructions for that.
#ifndef INTEGRAL_OUTPUT_INTERLACE_AVX2_H
#define INTEGRAL_OUTPUT_INTERLACE_AVX2_H

#include "integral/base/avx2.h"

#ifdef INTEGRAL_HAS_AVX2

#include "integral/output/interlace_rows.h"

namespace integral {

/// As interlace_row, for the first samples of the row: as many as are returned.
int fast_row(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
             Blending blending);

/// As pair_rows, for the first samples of the rows: as many as are returned.
std::size_t fast_pairs(std::uint8_t* to, const std::uint8_t* row, const std::uint8_t* below,
                       std::size_t count);

/// As blend_rows with a weight of 1 to 255, for the first samples: as many as are returned.
std::size_t fast_blend(std::uint8_t* to, const std::uint8_t* row, const std::uint8_t* below,
                       std::size_t count, std::uint32_t weight);
std::size_t fast_blend(std::uint16_t* to, const std::uint16_t* row, const std::uint16_t* below,
                       std::size_t count, std::uint32_t weight);

} // namespace integral

#endif

#endif
