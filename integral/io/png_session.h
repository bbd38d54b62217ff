// SPDX-License-Identifier: AGPL-3.0-or-later
// State and helpers of the PNG reader and writer; to be included only by them.
#ifndef INTEGRAL_IO_PNG_SESSION_H
#define INTEGRAL_IO_PNG_SESSION_H

#include "integral/base/file_bytes.h"
#include "integral/frame/image.h"
#include "integral/io/png_spans.h"

#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <exception>

namespace integral {

inline constexpr char png_keyword[] = "integral";
inline constexpr double mm_per_metre = 1000;

/// The state that libpng's callbacks need. libpng reports errors by longjmp, so the functions below
/// that call setjmp, and the functions called by them, have no local objects with destructors.
struct PngSession {
    png_structp png = nullptr;
    png_infop info = nullptr;
    const InputFile* input = nullptr;
    std::vector<ByteSpan> spans; ///< parts of the input, in the order in which libpng gets them
    std::vector<unsigned char> ahead; ///< bytes read from the input for libpng
    std::size_t taken = 0;            ///< number of bytes of `ahead` that libpng has received
    ByteSink* output = nullptr;
    std::exception_ptr failure; ///< exception thrown by the sink
    std::size_t row_bytes = 0;  ///< length of a row in the file, before it is expanded
    bool grey = false;          ///< the file has one channel, or one and alpha
    char message[160] = "";
    char warning[160] = ""; ///< the first warning about the colour profile
};

inline void on_png_error(png_structp png, png_const_charp message)
{
    auto* session = static_cast<PngSession*>(png_get_error_ptr(png));
    std::snprintf(session->message, sizeof session->message, "%s", message);
    png_longjmp(png, 1);
}

inline bool little_endian()
{
    const std::uint16_t one = 1;
    unsigned char first;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

inline std::size_t bytes_a_row(const Image& form)
{
    return std::size_t(form.width) * form.channels * (sample_bits(form) / 8);
}

} // namespace integral

#endif
