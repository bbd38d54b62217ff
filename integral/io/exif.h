// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads from a block of Exif data how its picture is to be shown.
#ifndef INTEGRAL_IO_EXIF_H
#define INTEGRAL_IO_EXIF_H

#include "integral/optics/vec.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace integral {

/// Reads numbers from a block of bytes that is laid out as a TIFF: a header that names the byte
/// order, and directories of fields.
class TiffNumbers {
public:
    /// The header is at bytes[begin]. The bytes must outlive the object.
    TiffNumbers(const std::string& bytes, std::size_t begin);

    /// The number in `count` bytes, 1 to 4, at an offset from the header. Throws std::runtime_error
    /// if the bytes end before that.
    std::uint32_t at(std::size_t offset, int count) const;

private:
    const std::string& bytes_;
    std::size_t begin_;
    bool little_ = false;
};

struct ExifFacts {
    int orientation = 1;             ///< 1 to 8, as in the standard; 1 is upright
    std::optional<Vec2> pixel_pitch; ///< mm, of the picture as it is stored
};

/// The facts in a block of Exif data that begins with its TIFF header. From a broken block, as many
/// cameras and editors write it, it returns the facts that can be read.
ExifFacts exif_facts(const std::string& block);

} // namespace integral

#endif
