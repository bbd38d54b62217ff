// SPDX-License-Identifier: AGPL-3.0-or-later
// The loops of interlacing for processors with AVX2, for views of 8 bits. Where
// INTEGRAL_HAS_AVX2 is not defined there are none.
//
// Measured for a panel of 3840 x 2160 on two cores (bench/interlace_speed): plain loops that gcc 12
// turns into vectors for AVX-512 take 1.3 to 1.6 times as long, as fetching the samples, which is
// most of the work, becomes no vector code; 60 images a second need these.
#ifndef INTEGRAL_OUTPUT_INTERLACE_AVX2_H
#define INTEGRAL_OUTPUT_INTERLACE_AVX2_H

#if defined(__x86_64__) && defined(__GNUC__)
#define INTEGRAL_HAS_AVX2

#include "integral/output/interlace_rows.h"

namespace integral {

inline bool has_avx2()
{
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}

/// As interlace_row, for the first samples of the row: as many as are returned.
int fast_row(std::uint8_t* samples, const PanelRow& row, const ViewRows<std::uint8_t>& rows,
             Blending blending);

Range fast_range(const std::uint16_t* numbers, int count);

/// As pair_rows, for the first samples of the rows: as many as are returned.
std::size_t fast_pairs(std::uint8_t* to, const std::uint8_t* row, const std::uint8_t* below,
                       std::size_t count);

} // namespace integral

#endif

#endif
