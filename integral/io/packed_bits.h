// SPDX-License-Identifier: AGPL-3.0-or-later
// Packs two-tone samples, as PDF, PNG and TIFF store them.
#ifndef INTEGRAL_IO_PACKED_BITS_H
#define INTEGRAL_IO_PACKED_BITS_H

#include <cstddef>
#include <vector>

namespace integral {

/// One row of 8-bit samples, each 0 or 255, as bits: the first sample is the highest bit of the
/// first byte, and the row ends at a whole byte.
inline std::vector<unsigned char> packed_bits(const unsigned char* row, std::size_t samples)
{
    std::vector<unsigned char> bits((samples + 7) / 8);
    for (std::size_t k = 0; k < samples; ++k)
        bits[k / 8] |= static_cast<unsigned char>((row[k] & 1) << (7 - k % 8));
    return bits;
}

} // namespace integral

#endif
