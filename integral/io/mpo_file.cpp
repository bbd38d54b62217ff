// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/mpo_file.h"

#include "integral/base/file_bytes.h"
#include "integral/base/message_text.h"
#include "integral/io/codecs.h"
#include "integral/io/exif.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace integral {
namespace {

using namespace std::string_literals;

constexpr std::size_t most_pictures = 256;
constexpr int entry_size = 16; // bytes of a picture's entry in the index

/// Big-endian numbers, as in a TIFF that begins with MM.
std::string u16(std::uint32_t v) { return {char(v >> 8), char(v)}; }
std::string u32(std::uint32_t v) { return u16(v >> 16) + u16(v & 0xffff); }

enum FieldType {
    ascii = 2,
    u16_type = 3,
    u32_type = 4,
    rational = 5,
    undefined = 7,
    srational = 10
};

/// A field of a TIFF directory.
struct Field {
    int tag;
    FieldType type;
    std::uint32_t count;
    std::string bytes;
};

std::string header() { return "MM\0\x2a"s + u32(8); }

/// A directory at offset `at` from the header; `next`: offset of the next directory, 0 for none.
std::string directory(const std::vector<Field>& fields, std::size_t at, std::uint32_t next = 0)
{
    std::string text = u16(std::uint32_t(fields.size())), behind;
    const std::size_t end = at + 2 + 12 * fields.size() + 4;
    for (const Field& field : fields) {
        text += u16(std::uint32_t(field.tag)) + u16(field.type) + u32(field.count);
        if (field.bytes.size() <= 4) {
            text += field.bytes + std::string(4 - field.bytes.size(), '\0');
        } else {
            text += u32(std::uint32_t(end + behind.size()));
            behind += field.bytes;
        }
    }
    return text + u32(next) + behind;
}

/// A JPEG segment of an application's data.
std::string segment(char marker, const std::string& content)
{
    return "\xff"s + marker + u16(std::uint32_t(content.size() + 2)) + content;
}

/// The Exif that DC-007 requires of every picture, as short as possible.
std::string exif(const Image& picture)
{
    const std::vector<Field> of_pixels = {
        {0x9000, undefined, 4, "0230"},      // version of Exif
        {0x9101, undefined, 4, "\1\2\3\0"s}, // Y, Cb, Cr
        {0xa000, undefined, 4, "0100"},      // version of FlashPix
        {0xa001, u16_type, 1, u16(1)},       // sRGB
        {0xa002, u32_type, 1, u32(std::uint32_t(picture.width))},
        {0xa003, u32_type, 1, u32(std::uint32_t(picture.height))}};
    const auto whole = [&](std::uint32_t place) {
        return directory({{0x011a, rational, 1, u32(72) + u32(1)}, // pixels to the inch
                          {0x011b, rational, 1, u32(72) + u32(1)},
                          {0x0128, u16_type, 1, u16(2)},
                          {0x0213, u16_type, 1, u16(1)}, // chroma is centred
                          {0x8769, u32_type, 1, u32(place)}},
                         8);
    };
    const std::size_t place = 8 + whole(0).size();
    return segment('\xe1', "Exif\0\0"s + header() + whole(std::uint32_t(place)) +
                               directory(of_pixels, place));
}

/// The fields for a picture's place among the views, which are numbered from 1 at the left.
std::vector<Field> attributes(std::size_t view, double baseline, bool with_version)
{
    std::vector<Field> fields;
    if (with_version)
        fields.push_back({0xb000, undefined, 4, "0100"});
    fields.push_back({0xb101, u32_type, 1, u32(std::uint32_t(view + 1))});
    fields.push_back({0xb204, u32_type, 1, u32(1)});           // the base view is the first
    fields.push_back({0xb205, srational, 1, u32(0) + u32(1)}); // the eyes look straight ahead
    const auto micrometres = std::uint32_t(
        std::lround(std::fmin(1000 * baseline * double(view), 4e9)));
    fields.push_back({0xb206, rational, 1, u32(micrometres) + u32(1000000)}); // m from the base
    return fields;
}

/// The first picture's index and attributes; `sizes`: the pictures' sizes, bytes; `header_at`:
/// offset of the index's header in the file.
std::string first_index(const std::vector<std::size_t>& sizes, std::size_t header_at,
                        double baseline)
{
    std::string entries;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        constexpr std::uint32_t disparity = 0x020002, representative = 0x20000000;
        entries += u32(disparity | (k == 0 ? representative : 0)) + u32(std::uint32_t(sizes[k])) +
                   u32(std::uint32_t(k == 0 ? 0 : begin - header_at)) + u32(0);
        begin += sizes[k];
    }
    const std::vector<Field> index = {{0xb000, undefined, 4, "0100"},
                                      {0xb001, u32_type, 1, u32(std::uint32_t(sizes.size()))},
                                      {0xb002, undefined, std::uint32_t(entries.size()), entries}};
    const std::size_t second = 8 + directory(index, 8).size();
    return segment('\xe2', "MPF\0"s + header() + directory(index, 8, std::uint32_t(second)) +
                               directory(attributes(0, baseline, false), second));
}

std::string other_index(std::size_t view, double baseline)
{
    return segment('\xe2', "MPF\0"s + header() + directory(attributes(view, baseline, true), 8));
}

/// Offset of the index's header; nothing if a file has none.
std::optional<std::size_t> index_header(const std::string& bytes)
{
    if (bytes.compare(0, 2, "\xff\xd8") != 0)
        return std::nullopt;
    const TiffNumbers file(bytes, 0); // reads big-endian, as no JPEG begins with II
    for (std::size_t at = 2; at + 8 <= bytes.size() && bytes[at] == '\xff';) {
        const auto marker = std::uint8_t(bytes[at + 1]);
        if (marker == 0xda || marker == 0xd9) // pixels follow, or nothing
            return std::nullopt;
        if (marker == 0xe2 && bytes.compare(at + 4, 4, "MPF\0"s) == 0)
            return at + 8;
        at += 2 + file.at(at + 2, 2);
    }
    return std::nullopt;
}

} // namespace

std::string mpo_of_views(const std::vector<Image>& views, int quality, double baseline)
{
    std::vector<std::string> heads, bodies;
    std::vector<std::size_t> sizes;
    for (std::size_t k = 0; k < views.size(); ++k) {
        heads.push_back("\xff\xd8" + exif(views[k]));
        bodies.push_back(encode_jpeg(views[k], quality).substr(2)); // without the start marker
        sizes.push_back(heads[k].size() + bodies[k].size() +
                        (k == 0 ? 0 : other_index(k, baseline).size()));
    }
    sizes[0] += first_index(sizes, 0, baseline).size(); // the size is independent of the numbers
    const std::size_t header_at = heads[0].size() + 8;
    std::string file;
    for (std::size_t k = 0; k < views.size(); ++k)
        file += heads[k] +
                (k == 0 ? first_index(sizes, header_at, baseline) : other_index(k, baseline)) +
                bodies[k];
    return file;
}

void write_mpo(const std::string& path, const Image& pair, int quality, double baseline)
{
    const int width = pair.width / 2;
    const std::vector<Image> views = {part_of(pair, 0, 0, width, pair.height),
                                      part_of(pair, width, 0, width, pair.height)};
    try {
        write_file(path, mpo_of_views(views, quality, baseline));
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        throw OutputError(path + ": " + reason_of(error));
    }
}

std::vector<std::size_t> pictures_in_mpo(const std::string& bytes)
{
    const auto begin = index_header(bytes);
    if (!begin)
        return {};
    const TiffNumbers index(bytes, *begin);
    const std::size_t first = index.at(4, 4), fields = index.at(first, 2);
    std::vector<std::size_t> pictures;
    for (std::size_t k = 0; k < fields; ++k) {
        const std::size_t field = first + 2 + 12 * k;
        if (index.at(field, 2) != 0xb002)
            continue;
        const std::size_t count = index.at(field + 4, 4) / entry_size,
                          list = index.at(field + 8, 4);
        if (pictures.size() + count > most_pictures)
            throw std::runtime_error("its index is of more than " + std::to_string(most_pictures) +
                                     " pictures");
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t entry = list + entry_size * i;
            constexpr std::uint32_t of_thumbnails = 1; // type of a picture's small copies
            if ((index.at(entry, 4) >> 16 & 0xff) == of_thumbnails)
                continue;
            const std::uint32_t offset = index.at(entry + 8, 4);
            const std::size_t place = offset == 0 ? 0 : *begin + offset;
            if (place + 2 > bytes.size())
                throw std::runtime_error("its index says that a picture is beyond its end");
            if (std::find(pictures.begin(), pictures.end(), place) != pictures.end())
                throw std::runtime_error("its index has a picture twice");
            pictures.push_back(place);
        }
    }
    return pictures;
}

} // namespace integral
