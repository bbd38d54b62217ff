// SPDX-License-Identifier: AGPL-3.0-or-later
// Unpacks the samples of TIFFs. To be included only by the TIFF reader.
#ifndef INTEGRAL_IO_TIFF_SAMPLES_H
#define INTEGRAL_IO_TIFF_SAMPLES_H

#include "integral/io/tiff_layout.h"

#include <half.h> // of OpenEXR

#include <cstring>
#include <limits>
#include <type_traits>

namespace integral {

/// Calls take(k, value) for `count` integers of `bits` bits each, the highest first, packed without
/// gaps.
template <class Take>
void for_each_packed(const unsigned char* bytes, int bits, std::size_t count, Take take)
{
    std::uint32_t held = 0;
    int have = 0;
    for (std::size_t k = 0; k < count; ++k) {
        while (have < bits) {
            held = held << 8 | *bytes++;
            have += 8;
        }
        have -= bits;
        take(k, held >> have & ((1u << bits) - 1));
    }
}

/// Unpacks a row's samples: to integers of the full range of their type, or to floats. Palette
/// indices are unchanged.
template <class Sample>
void unpack(const TiffLayout& l, const unsigned char* bytes, std::vector<Sample>& row)
{
    if constexpr (std::is_floating_point<Sample>::value) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            double wide;
            half narrow;
            if (l.bits == 16) {
                std::memcpy(&narrow, bytes + 2 * k, 2);
                row[k] = narrow;
            } else if (l.bits == 64) {
                std::memcpy(&wide, bytes + 8 * k, 8);
                row[k] = float(wide);
            } else {
                std::memcpy(&row[k], bytes + 4 * k, 4);
            }
        }
    } else {
        constexpr std::uint32_t full = std::numeric_limits<Sample>::max();
        if (l.bits == 8 * sizeof(Sample)) {
            std::memcpy(row.data(), bytes, row.size() * sizeof(Sample));
        } else if (l.bits == 32) {
            for (std::size_t k = 0; k < row.size(); ++k) {
                std::uint32_t value;
                std::memcpy(&value, bytes + 4 * k, 4);
                row[k] = Sample(value >> 16);
            }
        } else {
            const std::uint32_t most = (1u << l.bits) - 1;
            const bool indices = !l.palette.empty();
            for_each_packed(bytes, l.bits, row.size(), [&](std::size_t k, std::uint32_t value) {
                row[k] = Sample(indices ? value : (value * full + most / 2) / most);
            });
        }
    }
}

} // namespace integral

#endif
