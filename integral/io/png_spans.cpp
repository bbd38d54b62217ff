// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/png_spans.h"

#include <cstring>
#include <stdexcept>

namespace integral {
namespace {

constexpr std::uint64_t signature = 8; // bytes before the first chunk
constexpr std::uint64_t around = 12;   // a chunk's length and type before its data, checksum after

/// The first bytes of a chunk.
struct ChunkHead {
    unsigned char bytes[8];

    std::uint64_t length() const // of its data
    {
        return std::uint64_t(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
    }
    bool is(const char* type) const { return std::memcmp(bytes + 4, type, 4) == 0; }
    bool is_metadata() const { return is("iTXt") || is("tEXt") || is("zTXt") || is("eXIf"); }
};

ChunkHead head_at(const InputFile& file, std::uint64_t at)
{
    ChunkHead head;
    file.read(at, head.bytes, sizeof head.bytes);
    return head;
}

/// The file's bytes, with the metadata chunks moved to the offset `first_pixels`. All of them must
/// lie after that offset.
std::vector<ByteSpan> with_metadata_first(const InputFile& file, std::uint64_t first_pixels,
                                          const std::vector<ByteSpan>& metadata)
{
    std::vector<ByteSpan> spans;
    std::uint64_t at = 0;
    if (!metadata.empty()) {
        spans.push_back({0, first_pixels});
        spans.insert(spans.end(), metadata.begin(), metadata.end());
        at = first_pixels;
        for (const ByteSpan& chunk : metadata) {
            spans.push_back({at, chunk.at - at});
            at = chunk.at + chunk.count;
        }
    }
    spans.push_back({at, file.size() - at});
    return spans;
}

} // namespace

std::vector<ByteSpan> png_spans(const InputFile& file, bool whole)
{
    std::uint64_t first_pixels = 0;
    std::vector<ByteSpan> behind; // chunks of metadata after the pixels
    for (std::uint64_t at = signature; at + around <= file.size();) {
        const ChunkHead head = head_at(file, at);
        const std::uint64_t length = head.length();
        if (length > file.size() - at - around) {
            if (!whole)
                break;
            throw std::runtime_error(
                "it ends too early, or a chunk of it is not as long as it says");
        }
        if (head.is("IEND"))
            break;
        if (head.is("IDAT")) {
            if (!whole)
                break;
            behind.clear(); // chunks between pixel chunks stay there, and libpng rejects them
            first_pixels = first_pixels ? first_pixels : at;
        } else if (first_pixels && head.is_metadata()) {
            behind.push_back({at, around + length});
        }
        at += around + length;
    }
    return with_metadata_first(file, first_pixels, behind);
}

} // namespace integral
