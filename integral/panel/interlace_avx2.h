// SPDX-License-Identifier: AGPL-3.0-or-later
// Interlacing loops for processors with AVX2: for views of 8 bits, and for blending rows of 16
// bits. Only present if INTEGRAL_HAS_AVX2 is defined.
//
// Plain loops that gcc 12 compiled to AVX-512 code took 1.25 to 1.6 times the processor time of
// AVX2 loops (bench/interlace_speed, on a busy machine): most of the work is fetching samples, and
// the compiler does not use vector instructions for that.
#ifndef INTEGRAL_PANEL_INTERLACE_AVX2_H
#define INTEGRAL_PANEL_INTERLACE_AVX2_H

#include "integral/base/avx2.h"

#ifdef INTEGRAL_HAS_AVX2

#include "integral/panel/interlace_rows.h"

namespace integral {

/// Does interlace_row's work for the first samples of the row; returns their number.
int fast_row(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
             Blending blending);

/// Does pair_rows' work for the first samples of the rows; returns their number.
std::size_t fast_pairs(std::uint8_t* to, const std::uint8_t* row, const std::uint8_t* below,
                       std::size_t count);

/// Does blend_rows' work, for a weight of 1 to 255, for the first samples; returns their number.
std::size_t fast_blend(std::uint8_t* to, const std::uint8_t* row, const std::uint8_t* below,
                       std::size_t count, std::uint32_t weight);
std::size_t fast_blend(std::uint16_t* to, const std::uint16_t* row, const std::uint16_t* below,
                       std::size_t count, std::uint32_t weight);

} // namespace integral

#endif

#endif
