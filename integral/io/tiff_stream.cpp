// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/tiff_stream.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace integral {
namespace {

thread_local char last_error[160];

void on_error(const char*, const char* format, va_list arguments)
{
    if (last_error[0] == '\0') // keep the first message, which names the cause
        std::vsnprintf(last_error, sizeof last_error, format, arguments);
}

/// libtiff skips a tag that it cannot read, with a warning. If the tag holds the document, the file
/// counts as damaged.
void on_warning(const char*, const char* format, va_list arguments)
{
    char text[sizeof last_error];
    std::vsnprintf(text, sizeof text, format, arguments);
    if (std::strstr(text, "ImageDescription"))
        std::memcpy(last_error, text, sizeof text);
}

tmsize_t on_read(thandle_t handle, void* data, tmsize_t count)
{
    auto& stream = *static_cast<TiffStream*>(handle);
    if (count <= 0 || stream.position >= stream.size())
        return 0;
    auto n = std::size_t(std::min<std::uint64_t>(count, stream.size() - stream.position));
    try { // no exception may pass through libtiff
        if (stream.output)
            n = stream.output->read(stream.position, data, n);
        else
            stream.input->read(stream.position, data, n);
    } catch (const std::exception&) {
        return 0;
    }
    stream.position += n;
    return tmsize_t(n);
}

tmsize_t on_write(thandle_t handle, void* data, tmsize_t count)
{
    auto& stream = *static_cast<TiffStream*>(handle);
    try {
        stream.output->write(stream.position, data, std::size_t(count));
    } catch (...) {
        stream.failure = std::current_exception();
        return 0;
    }
    stream.position += std::uint64_t(count);
    return count;
}

toff_t on_seek(thandle_t handle, toff_t offset, int whence)
{
    auto& stream = *static_cast<TiffStream*>(handle);
    const toff_t base = whence == SEEK_CUR   ? stream.position
                        : whence == SEEK_END ? stream.size()
                                             : 0;
    stream.position = base + offset;
    return stream.position;
}

int on_close(thandle_t) { return 0; }
toff_t on_size(thandle_t handle) { return static_cast<TiffStream*>(handle)->size(); }

} // namespace

TiffHandle open_tiff(TiffStream& stream, const char* mode)
{
    clear_tiff_error();
    TIFFSetErrorHandler(on_error);
    TIFFSetWarningHandler(on_warning);
    TiffHandle tiff(TIFFClientOpen("image", mode, &stream, on_read, on_write, on_seek, on_close,
                                   on_size, nullptr, nullptr));
    if (!tiff || last_error[0])
        fail_tiff("it cannot be opened as a TIFF");
    return tiff;
}

void clear_tiff_error() { last_error[0] = '\0'; }

void fail_tiff(const char* otherwise)
{
    throw std::runtime_error(last_error[0] ? last_error : otherwise);
}

} // namespace integral
