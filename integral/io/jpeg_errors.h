// SPDX-License-Identifier: AGPL-3.0-or-later
// Errors of libjpeg. To be included only by the JPEG reader and writer.
#ifndef INTEGRAL_IO_JPEG_ERRORS_H
#define INTEGRAL_IO_JPEG_ERRORS_H

#include <csetjmp>
#include <cstddef>
#include <cstdio>

#include <jpeglib.h> // needs <cstdio> before it

namespace integral {

/// libjpeg reports errors by a function that must not return. Functions that call setjmp must have
/// no local objects with destructors.
struct JpegFailure {
    jpeg_error_mgr manager; // the first member, because libjpeg passes on its address
    std::jmp_buf place;
    char message[JMSG_LENGTH_MAX] = "";
};

inline void on_jpeg_error(j_common_ptr codec)
{
    auto* failure = reinterpret_cast<JpegFailure*>(codec->err);
    codec->err->format_message(codec, failure->message);
    std::longjmp(failure->place, 1);
}

/// `on_message`: gets warnings (level -1) and traces.
inline void catch_jpeg_errors(JpegFailure& failure, jpeg_error_mgr*& of_codec,
                              void (*on_message)(j_common_ptr, int level))
{
    of_codec = jpeg_std_error(&failure.manager);
    failure.manager.error_exit = on_jpeg_error;
    failure.manager.emit_message = on_message;
}

} // namespace integral

#endif
