// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads what Gutenprint's driver of DNP printers sends to the printer, for print_cups.test; shares
// nothing with libintegral.
//
//   dyesub FILE PAGE WIDTH HEIGHT
//                "N samples differ": the three planes (yellow, magenta, cyan, each a BMP of 8 bits,
//                255: no dye; its rows are the page's columns from the left) against a page of
//                samples R, G, B in the middle of the sheet, without dye round it
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

std::string file_bytes(const char* path)
{
    std::ifstream stream(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

long number(const std::string& bytes, std::size_t at)
{
    long value = 0;
    for (int i = 3; i >= 0; --i)
        value = value * 256 + static_cast<unsigned char>(bytes.at(at + std::size_t(i)));
    return value;
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 5)
        return 2;
    const std::string sent = file_bytes(arguments[1]), page = file_bytes(arguments[2]);
    const long width = std::atol(arguments[3]), height = std::atol(arguments[4]);
    if (long(page.size()) != width * height * 3)
        return 3;
    long differ = 0;
    const char* const names[] = {"YPLANE", "MPLANE", "CPLANE"}; // of blue, green, red
    for (int plane = 0; plane < 3; ++plane) {
        const std::size_t command = sent.find(names[plane]);
        const std::size_t bmp = command == std::string::npos ? command : sent.find("BM", command);
        if (bmp == std::string::npos)
            return 3;
        const std::size_t pixels = bmp + std::size_t(number(sent, bmp + 10));
        const long rows = number(sent, bmp + 18),
                   columns = number(sent, bmp + 22); // of the page: the plane is turned
        const long left = (columns - width) / 2, top = (rows - height) / 2;
        for (long x = 0; x < columns; ++x)
            for (long y = 0; y < rows; ++y) {
                const bool inside = x >= left && x < left + width && y >= top && y < top + height;
                const char wanted = inside ? page[std::size_t((y - top) * width + x - left) * 3 +
                                                  std::size_t(2 - plane)]
                                           : char(255);
                differ += sent.at(pixels + std::size_t(x * rows + y)) != wanted;
            }
    }
    std::printf("%ld samples differ\n", differ);
}
