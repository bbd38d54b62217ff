// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads a CUPS raster with libcups' reader, for print_cups.test; shares nothing with libintegral.
//
//   raster FILE                     one line a page: pixels, dots an inch, medium and its printable mm by the header's points
//   raster FILE PAGE WIDTH HEIGHT   and compares each page with that of samples R, G, B: in the middle, white round it;
//                                   "N differ", of the raster's pixels; cut by as much where it is larger
#include <cups/raster.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <vector>

int main(int count, char** arguments)
{
    if (count != 2 && count != 5)
        return 2;
    const int file = open(arguments[1], O_RDONLY);
    cups_raster_t* raster = file < 0 ? nullptr : cupsRasterOpen(file, CUPS_RASTER_READ);
    if (!raster)
        return 3;
    std::vector<unsigned char> page;
    int width = 0, height = 0;
    if (count == 5) {
        std::ifstream stream(arguments[2], std::ios::binary);
        page.assign(std::istreambuf_iterator<char>(stream), {});
        width = std::atoi(arguments[3]);
        height = std::atoi(arguments[4]);
        if (page.size() != std::size_t(width) * height * 3)
            return 3;
    }
    cups_page_header2_t header;
    while (cupsRasterReadHeader2(raster, &header)) {
        std::printf("%ux%u pixels, %ux%u dpi, %s, %.2fx%.2f mm, %u bits", header.cupsWidth, header.cupsHeight, header.HWResolution[0], header.HWResolution[1],
                    header.cupsPageSizeName, (header.cupsImagingBBox[2] - header.cupsImagingBBox[0]) / 72 * 25.4,
                    (header.cupsImagingBBox[3] - header.cupsImagingBBox[1]) / 72 * 25.4, header.cupsBitsPerPixel);
        std::vector<unsigned char> row(header.cupsBytesPerLine);
        const int columns = int(header.cupsWidth), rows = int(header.cupsHeight);
        const int left = (columns - width) / 2, top = (rows - height) / 2;
        long differ = 0;
        for (int y = 0; y < rows; ++y) {
            if (cupsRasterReadPixels(raster, row.data(), header.cupsBytesPerLine) != header.cupsBytesPerLine)
                return 3;
            for (int x = 0; count == 5 && x < columns; ++x) {
                const unsigned char white[3] = {255, 255, 255};
                const bool inside = x >= left && x < left + width && y >= top && y < top + height;
                const unsigned char* wanted = inside ? &page[(std::size_t(y - top) * width + (x - left)) * 3] : white;
                differ += std::memcmp(&row[std::size_t(x) * 3], wanted, 3) != 0;
            }
        }
        if (count == 5)
            std::printf(", %ld differ", differ);
        std::puts("");
    }
    cupsRasterClose(raster);
}
