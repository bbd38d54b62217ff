// SPDX-License-Identifier: AGPL-3.0-or-later
#ifdef HAVE_CUPS
#include "integral/print/cups_raster.h"

#include <memory>
#include <stdexcept>

namespace integral {

namespace {

/// Destination of libcups' bytes.
struct Stream {
    const TakeBytes& take;
    bool goes_on = true;
};

ssize_t pass_on(void* stream, unsigned char* bytes, std::size_t count)
{
    Stream& to = *static_cast<Stream*>(stream);
    to.goes_on = to.goes_on && to.take(reinterpret_cast<const char*>(bytes), count);
    return to.goes_on ? ssize_t(count) : -1;
}

[[noreturn]] void fail()
{
    const char* reason = cupsRasterErrorString();
    const std::string more = reason && *reason ? std::string(": ") + reason : "";
    throw std::runtime_error("libcups could not write the raster" + more);
}

cups_page_header2_t page_header(const cups_page_header2_t& like, const Image& page)
{
    cups_page_header2_t header = like;
    header.NumCopies = 1;
    header.cupsWidth = unsigned(page.width);
    header.cupsHeight = unsigned(page.height);
    header.cupsBitsPerColor = 8;
    header.cupsBitsPerPixel = 24;
    header.cupsBytesPerLine = unsigned(page.width) * 3;
    header.cupsNumColors = 3;
    return header;
}

} // namespace

bool write_cups_raster(const std::vector<Image>& pages, int copies, const cups_page_header2_t& like,
                       const TakeBytes& take)
{
    Stream stream = {take};
    using Raster = std::unique_ptr<cups_raster_t, void (*)(cups_raster_t*)>;
    const Raster raster(cupsRasterOpenIO(pass_on, &stream, CUPS_RASTER_WRITE), cupsRasterClose);
    const auto check = [&](bool is_written) {
        if (!is_written && stream.goes_on)
            fail();
        return is_written;
    };
    if (!check(raster != nullptr))
        return false;
    std::vector<std::uint8_t> row; // libcups takes no const
    for (int copy = 0; copy < copies; ++copy)
        for (const Image& page : pages) {
            cups_page_header2_t header = page_header(like, page);
            if (!check(cupsRasterWriteHeader2(raster.get(), &header)))
                return false;
            const unsigned count = header.cupsBytesPerLine;
            for (int y = 0; y < page.height; ++y) {
                row.assign(row_bytes(page, y), row_bytes(page, y) + count);
                if (!check(cupsRasterWritePixels(raster.get(), row.data(), count) == count))
                    return false;
            }
        }
    return true;
}

} // namespace integral
#endif
