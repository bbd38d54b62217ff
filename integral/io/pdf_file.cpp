// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/pdf_file.h"

#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace integral {
namespace {

/// Compresses bytes (deflate) and passes the result on.
class Deflater {
public:
    explicit Deflater(PdfFile::TakeBytes take) : take_(std::move(take))
    {
        if (deflateInit(&stream_, Z_DEFAULT_COMPRESSION) != Z_OK)
            throw std::bad_alloc();
    }
    ~Deflater() { deflateEnd(&stream_); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void write(const void* bytes, std::size_t count)
    {
        constexpr std::size_t most = std::size_t(1) << 30; // zlib counts in 32 bits
        const auto* from = static_cast<const unsigned char*>(bytes);
        while (count > 0) {
            const std::size_t part = std::min(count, most);
            run(from, part, Z_NO_FLUSH);
            from += part;
            count -= part;
        }
    }

    void finish() { run(nullptr, 0, Z_FINISH); }

private:
    void run(const unsigned char* bytes, std::size_t count, int flush)
    {
        stream_.next_in = const_cast<unsigned char*>(bytes); // zlib does not change it
        stream_.avail_in = static_cast<unsigned>(count);
        do {
            stream_.next_out = packed_;
            stream_.avail_out = sizeof packed_;
            deflate(&stream_, flush);
            take_(packed_, sizeof packed_ - stream_.avail_out);
        } while (stream_.avail_out == 0);
    }

    PdfFile::TakeBytes take_;
    z_stream stream_ = {};
    unsigned char packed_[1 << 16];
};

/// Returns the character at offset `at` and moves `at` past it; U+FFFD for invalid UTF-8.
char32_t next_letter(const std::string& text, std::size_t& at)
{
    constexpr char32_t unknown = 0xfffd;
    const auto first = static_cast<unsigned char>(text[at++]);
    if (first < 0x80)
        return first;
    const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
    constexpr char32_t least[] = {0, 0x80, 0x800, 0x10000};
    char32_t letter = first & (0x3f >> more);
    for (int k = 0; k < more; ++k) {
        if (at >= text.size() || (text[at] & 0xc0) != 0x80)
            return unknown;
        letter = letter << 6 | (text[at++] & 0x3f);
    }
    const bool surrogate = letter >= 0xd800 && letter < 0xe000;
    const bool good = first >= 0xc2 && first <= 0xf4 && letter >= least[more] &&
                      letter <= 0x10ffff && !surrogate;
    return good ? letter : unknown;
}

/// Bytes as a PDF string.
std::string literal(const std::string& bytes)
{
    std::string string = "(";
    for (const char c : bytes) {
        if (c == '(' || c == ')' || c == '\\')
            string += '\\';
        string += c;
    }
    return string + ")";
}

std::string formatted(const char* form, unsigned long long value, unsigned long long other = 0)
{
    char text[64];
    std::snprintf(text, sizeof text, form, value, other);
    return text;
}

} // namespace

PdfFile::PdfFile(ByteSink& sink)
    : sink_(sink), crc_(crc32(0, nullptr, 0)), adler_(adler32(0, nullptr, 0))
{
    put("%PDF-1.6\n%\xbf\xf7\xa2\xfe\n"); // the second line marks the file as binary
}

void PdfFile::put(const void* bytes, std::size_t count)
{
    sink_.write(sink_.size(), bytes, count);
    const auto* from = static_cast<const unsigned char*>(bytes);
    crc_ = crc32_z(crc_, from, count);
    adler_ = adler32_z(adler_, from, count);
}

int PdfFile::reserve()
{
    places_.push_back(0);
    return int(places_.size());
}

void PdfFile::write(int number, const std::string& text)
{
    places_.at(std::size_t(number) - 1) = sink_.size();
    put(std::to_string(number) + " 0 obj\n" + text + "\nendobj\n");
}

int PdfFile::add(const std::string& text)
{
    const int number = reserve();
    write(number, text);
    return number;
}

int PdfFile::add_stream(const std::string& entries,
                        const std::function<void(const TakeBytes&)>& provide)
{
    const int number = reserve(), length = reserve();
    places_[std::size_t(number) - 1] = sink_.size();
    put(std::to_string(number) + " 0 obj\n<< " + entries + " /Filter /FlateDecode /Length " +
        reference(length) + " >>\nstream\n");
    const std::uint64_t start = sink_.size();
    Deflater packed([this](const void* bytes, std::size_t count) { put(bytes, count); });
    provide([&](const void* bytes, std::size_t count) { packed.write(bytes, count); });
    packed.finish();
    const std::uint64_t end = sink_.size();
    put("\nendstream\nendobj\n");
    write(length, std::to_string(end - start));
    return number;
}

int PdfFile::add_stream(const std::string& entries, const std::string& bytes)
{
    return add_stream(entries, [&](const TakeBytes& take) { take(bytes.data(), bytes.size()); });
}

int PdfFile::add_plain_stream(const std::string& entries, const std::string& bytes)
{
    return add("<< " + entries + " /Length " + std::to_string(bytes.size()) + " >>\nstream\n" +
               bytes + "\nendstream");
}

std::string PdfFile::digest() const
{
    return formatted("%08llx%08llx", crc_, adler_) + formatted("%016llx", sink_.size());
}

void PdfFile::finish(int catalog, int about)
{
    const std::string size = std::to_string(places_.size() + 1);
    const std::uint64_t table = sink_.size();
    put("xref\n0 " + size + "\n0000000000 65535 f \n");
    for (const std::uint64_t place : places_) {
        if (place == 0)
            throw std::logic_error("an object of a PDF was not written");
        put(formatted("%010llu 00000 n \n", place));
    }
    const std::string identifier = "<" + digest() + ">";
    put("trailer\n<< /Size " + size + " /Root " + reference(catalog) + " /Info " +
        reference(about) + " /ID [ " + identifier + " " + identifier + " ] >>\nstartxref\n" +
        std::to_string(table) + "\n%%EOF\n");
}

std::string reference(int number) { return std::to_string(number) + " 0 R"; }

std::string pdf_text(const std::string& text)
{
    const bool plain = std::all_of(text.begin(), text.end(),
                                   [](char c) { return c >= ' ' && c <= '~'; });
    if (plain)
        return literal(text);
    std::string string;
    for (std::size_t at = 0; at < text.size();) {
        const char32_t letter = next_letter(text, at);
        if (letter < 0x10000)
            string += formatted("%04llx", letter);
        else
            string += formatted("%04llx%04llx", 0xd800 + ((letter - 0x10000) >> 10),
                                0xdc00 + ((letter - 0x10000) & 0x3ff));
    }
    return "<feff" + string + ">";
}

std::string pdf_latin_text(const std::string& text)
{
    std::string bytes;
    for (std::size_t at = 0; at < text.size();) {
        const char32_t letter = next_letter(text, at);
        const bool latin = (letter >= ' ' && letter <= '~') || (letter >= 0xa0 && letter <= 0xff);
        bytes += latin ? char(letter) : '?';
    }
    return literal(bytes);
}

} // namespace integral
