// SPDX-License-Identifier: AGPL-3.0-or-later
// The header is three lines: "Pf" (grey) or "PF" (three channels), width and height, and a
// scale that is less than 0 if the floats' bytes begin with the lowest. The bottom row comes first.
#include "integral/io/pfm_file.h"

#include "integral/base/file_bytes.h"

#include <charconv>
#include <cstdint>
#include <cstring>

namespace integral {
namespace {

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// The next word of a header, of at most 20 characters; skips the one space after it.
std::string word(const std::string& bytes, std::size_t& at)
{
    std::string text;
    while (at < bytes.size() && is_space(bytes[at]))
        ++at;
    while (at < bytes.size() && !is_space(bytes[at]) && text.size() < 20)
        text += bytes[at++];
    ++at;
    return text;
}

[[noreturn]] void fail(const std::string& path, const std::string& what)
{
    throw InputError(display_name(path, "standard input") + ": " + what);
}

int side(const std::string& path, const std::string& text)
{
    constexpr int most = 1000000;
    int number = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data(), end, number).ptr != end || number < 1 || number > most)
        fail(path, "it is no PFM: its width or height is \"" + text + "\"");
    return number;
}

float float_at(const std::string& bytes, std::size_t at, bool lowest_first)
{
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k)
        bits |= std::uint32_t(static_cast<unsigned char>(bytes[at + k]))
                << (8 * (lowest_first ? k : 3 - k));
    float value;
    std::memcpy(&value, &bits, 4);
    return value;
}

} // namespace

FloatMap read_pfm(const std::string& path)
{
    const std::string bytes = read_file(path);
    std::size_t at = 0;
    const std::string kind = word(bytes, at);
    if (kind != "Pf" && kind != "PF")
        fail(path, "it is no PFM: it does not begin with Pf");
    const std::size_t channels = kind == "Pf" ? 1 : 3;
    FloatMap map;
    map.width = side(path, word(bytes, at));
    map.height = side(path, word(bytes, at));
    const std::string scale = word(bytes, at);
    const bool lowest_first = !scale.empty() && scale[0] == '-';
    const std::size_t width = std::size_t(map.width), height = std::size_t(map.height),
                      pixel = 4 * channels;
    if (at > bytes.size() || (bytes.size() - at) / pixel / width < height)
        fail(path, "it ends before its " + std::to_string(map.width) + "x" +
                       std::to_string(map.height) + " pixels do");
    map.values.resize(width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            map.values[(height - 1 - y) * width + x] = float_at(bytes, at + pixel * (y * width + x),
                                                                lowest_first);
    return map;
}

void write_pfm(const std::string& path, const FloatMap& map)
{
    std::string bytes = "Pf\n" + std::to_string(map.width) + " " + std::to_string(map.height) +
                        "\n-1.0\n";
    for (int y = map.height; y-- > 0;)
        for (int x = 0; x < map.width; ++x) {
            std::uint32_t bits;
            std::memcpy(&bits, &map.values[std::size_t(y) * map.width + x], 4);
            for (int k = 0; k < 4; ++k)
                bytes += char(bits >> (8 * k) & 255);
        }
    write_file(path, bytes);
}

} // namespace integral
