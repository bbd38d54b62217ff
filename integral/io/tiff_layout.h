// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads from a TIFF's tags how its pixels are stored. To be included only by the TIFF reader.
#ifndef INTEGRAL_IO_TIFF_LAYOUT_H
#define INTEGRAL_IO_TIFF_LAYOUT_H

#include <tiffio.h>

#include <cstdint>
#include <vector>

namespace integral {

/// The values of a TIFF's tags that decoding needs.
struct TiffLayout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, planar = PLANARCONFIG_CONTIG,
                  photometric = PHOTOMETRIC_MINISBLACK, orientation = ORIENTATION_TOPLEFT;
    bool tiled = false;
    bool by_libtiff = false; ///< its colours need libtiff's conversion to 8-bit RGB
    int inks = 3;            ///< samples of a pixel's colour: 1 (grey, palette), 3, or 4 (CMYK)
    bool alpha = false, premultiplied = false;
    std::vector<std::uint16_t> palette; ///< red of every index, then green, then blue

    /// Bits of a sample after reading: 8, 16 or 32 (floats).
    int read_bits() const;
    int planes() const { return planar == PLANARCONFIG_SEPARATE ? samples : 1; }
    int samples_a_plane() const { return planar == PLANARCONFIG_SEPARATE ? 1 : samples; }
};

/// Reads the layout and makes libtiff convert JPEG's colours to RGB. Throws std::runtime_error for
/// pictures that cannot be read.
TiffLayout tiff_layout(TIFF* tiff);

} // namespace integral

#endif
