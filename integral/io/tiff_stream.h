// SPDX-License-Identifier: AGPL-3.0-or-later
// Lets libtiff read an InputFile or write a ByteSink. To be included only by the TIFF reader and
// writer.
#ifndef INTEGRAL_IO_TIFF_STREAM_H
#define INTEGRAL_IO_TIFF_STREAM_H

#include "integral/base/file_bytes.h"
#include "integral/io/input_file.h"

#include <tiffio.h>

#include <exception>
#include <memory>

namespace integral {

/// The file that libtiff's callbacks read, or write if `output` is set.
struct TiffStream {
    const InputFile* input = nullptr;
    ByteSink* output = nullptr;
    std::uint64_t position = 0;
    std::exception_ptr failure = nullptr; ///< exception thrown by the output
    std::uint64_t size() const { return output ? output->size() : input->size(); }
};

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffHandle = std::unique_ptr<TIFF, CloseTiff>;

/// Opens a stream in one of libtiff's modes; the stream must outlive the handle. Throws
/// std::runtime_error.
TiffHandle open_tiff(TiffStream& stream, const char* mode);

/// Clears libtiff's last error on this thread.
void clear_tiff_error();

/// Throws std::runtime_error with libtiff's first error since clear_tiff_error or open_tiff, or
/// with `otherwise` if there is none.
[[noreturn]] void fail_tiff(const char* otherwise);

} // namespace integral

#endif
