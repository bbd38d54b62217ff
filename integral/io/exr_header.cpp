// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/exr_header.h"

#include <cstdint>
#include <stdexcept>

namespace integral {
namespace {

/// Bytes of the types that are always as long.
constexpr struct { const char* type; std::size_t size; } sizes[] = {
    {"box2f", 16}, {"box2i", 16}, {"chromaticities", 32}, {"compression", 1}, {"deepImageState", 1}, {"double", 8}, {"envmap", 1},
    {"float", 4}, {"int", 4}, {"keycode", 28}, {"lineOrder", 1}, {"m33d", 72}, {"m33f", 36}, {"m44d", 128}, {"m44f", 64},
    {"rational", 8}, {"tiledesc", 9}, {"timecode", 8}, {"v2d", 16}, {"v2f", 8}, {"v2i", 8}, {"v3d", 24}, {"v3f", 12}, {"v3i", 12}};

[[noreturn]] void fail(const char* what) { throw std::runtime_error(what); }

/// Reads bytes [at, end).
struct Reader {
    const std::string& bytes;
    std::size_t at, end;

    bool has(std::size_t count) const { return count <= end - at; }
    void skip(std::size_t count)
    {
        if (!has(count))
            fail("the file ends too early");
        at += count;
    }
    std::uint32_t number() // little-endian
    {
        skip(4);
        std::uint32_t value = 0;
        for (std::size_t k = 1; k <= 4; ++k)
            value = value << 8 | static_cast<unsigned char>(bytes[at - k]);
        return value;
    }
    std::string text() // up to a zero byte
    {
        const std::size_t begin = at, zero = bytes.find('\0', at);
        if (zero >= end) // npos, too
            fail("the file ends too early");
        at = zero + 1;
        return bytes.substr(begin, zero - begin);
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

/// OpenEXR makes room for a tile, whatever the picture's size.
void check_tiles(Reader description)
{
    constexpr std::uint64_t most_pixels = 1 << 24;
    const std::uint64_t width = description.number(), height = description.number();
    if (width * height > most_pixels)
        fail("its tiles have more pixels than 4096 x 4096");
}

} // namespace

void check_exr_header(const std::string& bytes)
{
    constexpr std::size_t magic_and_version = 8;
    Reader header{bytes, 0, bytes.size()};
    header.skip(magic_and_version);
    const bool has_parts = bytes[5] & 0x10; // an empty header then follows the last one
    for (;;) {
        int attributes = 0;
        for (std::string name = header.text(); !name.empty(); name = header.text(), ++attributes) {
            const std::string type = header.text();
            const std::size_t size = header.number(), begin = header.at;
            if (!header.has(size))
                fail("an attribute of its header is longer than the file");
            header.skip(size);
            if (!is_whole(type, {bytes, begin, begin + size}))
                fail("an attribute of its header is not as long as its type");
            if (type == "tiledesc")
                check_tiles({bytes, begin, begin + size});
        }
        if (!has_parts || attributes == 0)
            return;
    }
}

} // namespace integral
