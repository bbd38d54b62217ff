// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/exr_header.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

/// Lengths in bytes of the attribute types of fixed length.
constexpr struct {
    const char* type;
    std::size_t size;
} sizes[] = {{"box2f", 16},
             {"box2i", 16},
             {"chromaticities", 32},
             {"compression", 1},
             {"deepImageState", 1},
             {"double", 8},
             {"envmap", 1},
             {"float", 4},
             {"int", 4},
             {"keycode", 28},
             {"lineOrder", 1},
             {"m33d", 72},
             {"m33f", 36},
             {"m44d", 128},
             {"m44f", 64},
             {"rational", 8},
             {"tiledesc", 9},
             {"timecode", 8},
             {"v2d", 16},
             {"v2f", 8},
             {"v2i", 8},
             {"v3d", 24},
             {"v3f", 12},
             {"v3i", 12}};

[[noreturn]] void fail(const char* what) { throw std::runtime_error(what); }

/// Reads bytes [at, end) of a file.
struct Reader {
    const InputFile& file;
    std::uint64_t at, end;

    bool has(std::uint64_t count) const { return count <= end - at; }
    void skip(std::uint64_t count)
    {
        if (!has(count))
            fail("the file ends too early");
        at += count;
    }
    std::uint32_t number() // little-endian
    {
        const std::uint64_t begin = at;
        skip(4);
        unsigned char bytes[4];
        file.read(begin, bytes, sizeof bytes);
        return std::uint32_t(bytes[3]) << 24 | bytes[2] << 16 | bytes[1] << 8 | bytes[0];
    }
    std::string text() // up to a zero byte
    {
        std::string all;
        for (char piece[64];;) {
            const std::size_t count = std::size_t(std::min<std::uint64_t>(sizeof piece, end - at));
            if (count == 0)
                fail("the file ends too early");
            file.read(at, piece, count);
            const std::size_t length = std::size_t(std::find(piece, piece + count, '\0') - piece);
            all.append(piece, length);
            at += length;
            if (length < count) {
                ++at;
                return all;
            }
        }
    }
};

/// Whether the value of an attribute has the length of its type.
bool is_whole(const std::string& type, Reader value)
{
    if (type == "chlist") {
        constexpr std::size_t of_a_channel = 16;
        while (!value.text().empty())
            value.skip(of_a_channel);
        return !value.has(1);
    }
    if (type == "preview") {
        const std::uint64_t width = value.number(), height = value.number();
        return width < 65536 && height < 65536 && value.end - value.at == 4 * width * height;
    }
    if (type == "stringvector") {
        while (value.has(1))
            value.skip(value.number());
        return true;
    }
    for (const auto& known : sizes)
        if (type == known.type)
            return value.end - value.at == known.size;
    return true;
}

/// Limits the size of a tile: OpenEXR allocates a whole tile even for a small picture.
void check_tiles(Reader description)
{
    constexpr std::uint64_t most_pixels = 1 << 24;
    const std::uint64_t width = description.number(), height = description.number();
    if (width * height > most_pixels)
        fail("its tiles have more pixels than 4096 x 4096");
}

} // namespace

void check_exr_header(const InputFile& file)
{
    constexpr std::size_t magic_and_version = 8;
    Reader header{file, 0, file.size()};
    header.skip(magic_and_version);
    char version[2];
    file.read(4, version, sizeof version);
    const bool has_parts = version[1] &
                           0x10; // multi-part: an empty header ends the list of headers
    for (;;) {
        int attributes = 0;
        for (std::string name = header.text(); !name.empty(); name = header.text(), ++attributes) {
            const std::string type = header.text();
            const std::uint64_t size = header.number(), begin = header.at;
            if (!header.has(size))
                fail("an attribute of its header is longer than the file");
            header.skip(size);
            if (!is_whole(type, {file, begin, begin + size}))
                fail("an attribute of its header is not as long as its type");
            if (type == "tiledesc")
                check_tiles({file, begin, begin + size});
        }
        if (!has_parts || attributes == 0)
            return;
    }
}

} // namespace integral
