// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads a CUPS raster with libcups' reader, for print_cups.test; shares nothing with libintegral.
//
//   raster FILE  prints one line a page: pixels, dots an inch, medium and its printable mm by the
//                header's points
//   raster FILE PAGES WIDTH HEIGHT [turned]
//                and compares each with the next page of samples R, G, B (the same pages again at
//                their end): in the middle, white round it; "N differ", of the raster's pixels.
//                turned: by a quarter clockwise
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
    if (count != 2 && count != 5 && count != 6)
        return 2;
    const int file = open(arguments[1], O_RDONLY);
    cups_raster_t* raster = file < 0 ? nullptr : cupsRasterOpen(file, CUPS_RASTER_READ);
    if (!raster)
        return 3;
    std::vector<unsigned char> page;
    int width = 0, height = 0;
    const bool turned = count == 6, compares = count >= 5;
    if (compares) {
        std::ifstream stream(arguments[2], std::ios::binary);
        page.assign(std::istreambuf_iterator<char>(stream), {});
        width = std::atoi(arguments[3]);
        height = std::atoi(arguments[4]);
        if (page.empty() || page.size() % (std::size_t(width) * height * 3))
            return 3;
    }
    cups_page_header2_t header;
    for (std::size_t first = 0; cupsRasterReadHeader2(raster, &header);
         first += std::size_t(width) * height * 3) {
        first = first < page.size() ? first : 0;
        std::printf("%ux%u pixels, %ux%u dpi, %s, %.2fx%.2f mm, %u bits", header.cupsWidth,
                    header.cupsHeight, header.HWResolution[0], header.HWResolution[1],
                    header.cupsPageSizeName,
                    (header.cupsImagingBBox[2] - header.cupsImagingBBox[0]) / 72 * 25.4,
                    (header.cupsImagingBBox[3] - header.cupsImagingBBox[1]) / 72 * 25.4,
                    header.cupsBitsPerPixel);
        std::vector<unsigned char> row(header.cupsBytesPerLine);
        const int columns = int(header.cupsWidth), rows = int(header.cupsHeight);
        const int across = turned ? height : width, down = turned ? width : height;
        const int left = (columns - across) / 2, top = (rows - down) / 2;
        long differ = 0;
        for (int y = 0; y < rows; ++y) {
            if (cupsRasterReadPixels(raster, row.data(), header.cupsBytesPerLine) !=
                header.cupsBytesPerLine)
                return 3;
            for (int x = 0; compares && x < columns; ++x) {
                const unsigned char white[3] = {255, 255, 255};
                const bool inside = x >= left && x < left + across && y >= top && y < top + down;
                const int page_x = turned ? y - top : x - left,
                          page_y = turned ? height - 1 - (x - left) : y - top;
                const unsigned char*
                    wanted = inside ? &page[first + (std::size_t(page_y) * width + page_x) * 3]
                                    : white;
                differ += std::memcmp(&row[std::size_t(x) * 3], wanted, 3) != 0;
            }
        }
        if (compares)
            std::printf(", %ld differ", differ);
        std::puts("");
    }
    cupsRasterClose(raster);
}
