// SPDX-License-Identifier: AGPL-3.0-or-later
#ifdef HAVE_CUPS
#include "integral/output/cups_raster.h"

#include <memory>
#include <stdexcept>

namespace integral {

namespace {

ssize_t append(void* stream, unsigned char* bytes, std::size_t count)
{
    static_cast<std::string*>(stream)->append(reinterpret_cast<const char*>(bytes), count);
    return ssize_t(count);
}

[[noreturn]] void fail()
{
    const char* reason = cupsRasterErrorString();
    const std::string more = reason && *reason ? std::string(": ") + reason : "";
    throw std::runtime_error("libcups could not write the raster" + more);
}

} // namespace

std::string cups_raster(const std::vector<Image>& pages, int copies,
                        const cups_page_header2_t& like)
{
    std::string stream;
    using Raster = std::unique_ptr<cups_raster_t, void (*)(cups_raster_t*)>;
    const Raster raster(cupsRasterOpenIO(append, &stream, CUPS_RASTER_WRITE), cupsRasterClose);
    if (!raster)
        fail();
    for (int copy = 0; copy < copies; ++copy)
        for (const Image& page : pages) {
            cups_page_header2_t header = like;
            header.NumCopies = 1;
            header.cupsWidth = unsigned(page.width);
            header.cupsHeight = unsigned(page.height);
            header.cupsBitsPerColor = 8;
            header.cupsBitsPerPixel = 24;
            header.cupsBytesPerLine = unsigned(page.width) * 3;
            header.cupsNumColors = 3;
            if (!cupsRasterWriteHeader2(raster.get(), &header))
                fail();
            std::vector<std::uint8_t> samples = std::get<std::vector<std::uint8_t>>(
                page.samples); // libcups takes no const
            const unsigned row_bytes = header.cupsBytesPerLine;
            for (int y = 0; y < page.height; ++y)
                if (cupsRasterWritePixels(raster.get(), samples.data() + std::size_t(y) * row_bytes,
                                          row_bytes) != row_bytes)
                    fail();
        }
    return stream;
}

} // namespace integral
#endif
