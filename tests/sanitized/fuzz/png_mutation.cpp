// SPDX-License-Identifier: AGPL-3.0-or-later
// Mutates PNG files chunk by chunk, with right checksums, so that readers do not stop at those.
#include "tests/sanitized/fuzz/target.h"

#include <zlib.h>

#include <algorithm>
#include <random>

namespace fuzz {
namespace {

const Bytes signature = "\x89PNG\r\n\x1a\n";

Bytes four_bytes(std::uint32_t value)
{
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

std::uint32_t value_of(const Bytes& bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (int k = 0; k < 4; ++k)
        value = value << 8 | static_cast<unsigned char>(bytes[at + std::size_t(k)]);
    return value;
}

/// Splits a file into chunks. Lengths that go beyond the file's end are reduced.
std::vector<Chunk> chunks_of(const Bytes& png)
{
    std::vector<Chunk> chunks;
    for (std::size_t at = signature.size(); at + 12 <= png.size();) {
        const std::size_t length = std::min<std::size_t>(value_of(png, at), png.size() - at - 12);
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
        at += length + 12;
    }
    return chunks;
}

} // namespace

Bytes png_of(const std::vector<Chunk>& chunks)
{
    Bytes png = signature;
    for (const Chunk& chunk : chunks) {
        const Bytes body = chunk.type + chunk.data;
        png += four_bytes(std::uint32_t(chunk.data.size())) + body +
               four_bytes(std::uint32_t(
                   crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()))));
    }
    return png;
}

Bytes mutated_png(Bytes png, std::size_t most, unsigned seed)
{
    std::minstd_rand random(seed + 1);
    std::vector<Chunk> chunks = chunks_of(png);
    if (chunks.empty())
        chunks = {{"IHDR", Bytes(13, '\1')}, {"IEND", ""}};
    const std::size_t k = random() % chunks.size();
    switch (random() % 8) {
    case 0: chunks.erase(chunks.begin() + std::ptrdiff_t(k)); break;
    case 1:
        chunks.insert(chunks.begin() + std::ptrdiff_t(random() % chunks.size()), Chunk(chunks[k]));
        break;
    case 2: LLVMFuzzerMutate(reinterpret_cast<unsigned char*>(&chunks[k].type[0]), 4, 4); break;
    default: {
        Bytes& data = chunks[k].data;
        const std::size_t size = data.size(), room = size + 64;
        data.resize(room);
        data.resize(LLVMFuzzerMutate(reinterpret_cast<unsigned char*>(&data[0]), size, room));
    }
    }
    png = png_of(chunks);
    png.resize(std::min(png.size(), most));
    return png;
}

} // namespace fuzz
