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
    throw std::runtime_error(std::string("libcups could not write the raster") + (reason && *reason ? std::string(": ") + reason : ""));
}

} // namespace

std::string cups_raster(const std::vector<Image>& pages, int copies, const cups_page_header2_t& like)
{
    std::string stream;
    const std::unique_ptr<cups_raster_t, void (*)(cups_raster_t*)> raster(cupsRasterOpenIO(append, &stream, CUPS_RASTER_WRITE), cupsRasterClose);
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
            std::vector<std::uint8_t> samples = std::get<std::vector<std::uint8_t>>(page.samples); // libcups takes no const
            for (int y = 0; y < page.height; ++y)
                if (cupsRasterWritePixels(raster.get(), samples.data() + std::size_t(y) * header.cupsBytesPerLine, header.cupsBytesPerLine) != header.cupsBytesPerLine)
                    fail();
        }
    return stream;
}

} // namespace integral
#endif
