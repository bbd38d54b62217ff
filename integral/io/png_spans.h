// SPDX-License-Identifier: AGPL-3.0-or-later
// Orders the bytes of a PNG file for libpng: text chunks before the pixels, so that the file's
// document is known before any pixel is read.
#ifndef INTEGRAL_IO_PNG_SPANS_H
#define INTEGRAL_IO_PNG_SPANS_H

#include "integral/io/input_file.h"

#include <cstdint>
#include <vector>

namespace integral {

/// A contiguous range of a file's bytes.
struct ByteSpan {
    std::uint64_t at = 0, count = 0;
};

/// A file's bytes in the order in which libpng gets them: chunks of text and Exif that follow the
/// pixels are moved in front of the pixels. Throws std::runtime_error if a chunk is longer than the
/// file, because libpng allocates up to 2 GB for some chunks before it checks that. If not `whole`,
/// the file may be truncated anywhere, and chunks after the first pixels are ignored.
std::vector<ByteSpan> png_spans(const InputFile& file, bool whole);

} // namespace integral

#endif
