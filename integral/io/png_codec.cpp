// SPDX-License-Identifier: AGPL-3.0-or-later
// PNG: the document in an iTXt chunk `integral`, the resolution in pHYs, the encoding in sRGB or gAMA.
#include "integral/io/codecs.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace integral {
namespace {

constexpr char keyword[] = "integral";
constexpr double mm_per_metre = 1000;
constexpr double greatest_deflate_ratio = 1100; // 1032 is deflate's

/// What libpng's callbacks need. libpng leaves by longjmp: the functions below that set its
/// target hold no object that would have to be destroyed.
struct Session {
    png_structp png = nullptr;
    png_infop info = nullptr;
    const std::string* input = nullptr;
    std::size_t position = 0;
    std::string* output = nullptr;
    std::size_t row_bytes = 0; ///< of the file's rows, before they are expanded
    char message[160] = "";
};

void on_error(png_structp png, png_const_charp message)
{
    auto* session = static_cast<Session*>(png_get_error_ptr(png));
    std::snprintf(session->message, sizeof session->message, "%s", message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep data, png_size_t count)
{
    auto* session = static_cast<Session*>(png_get_io_ptr(png));
    if (count > session->input->size() - session->position)
        png_error(png, "the file ends too early");
    std::memcpy(data, session->input->data() + session->position, count);
    session->position += count;
}

void on_write(png_structp png, png_bytep data, png_size_t count)
{
    auto* session = static_cast<Session*>(png_get_io_ptr(png));
    bool full = false; // no exception may pass through libpng
    try {
        session->output->append(reinterpret_cast<const char*>(data), count);
    } catch (const std::exception&) {
        full = true;
    }
    if (full)
        png_error(png, "not enough memory");
}

void on_flush(png_structp) {}

bool little_endian()
{
    const std::uint16_t one = 1;
    unsigned char first;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

/// libpng makes room for some chunks before it looks whether the file holds them: up to 2 GB.
void check_chunks(const std::string& bytes)
{
    constexpr std::size_t signature = 8, around = 12; // of a chunk: its length and type before its data, a checksum behind
    for (std::size_t at = signature; at + around <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k)
            length = length << 8 | static_cast<unsigned char>(bytes[at + k]);
        if (length > bytes.size() - at - around)
            throw std::runtime_error("it ends too early, or a chunk of it is not as long as it says");
        if (bytes.compare(at + 4, 4, "IEND") == 0)
            return;
        at += around + length;
    }
}

bool read_header(Session& s)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_set_read_fn(s.png, &s, on_read);
    png_set_user_limits(s.png, 1000000, 1000000);
    png_read_info(s.png, s.info);
    s.row_bytes = png_get_rowbytes(s.png, s.info);
    png_set_expand(s.png);      // palettes, few bits, tRNS
    png_set_gray_to_rgb(s.png);
    if (little_endian())
        png_set_swap(s.png);
    png_set_interlace_handling(s.png);
    png_read_update_info(s.png, s.info);
    return true;
}

bool read_rows(Session& s, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_read_image(s.png, rows);
    png_read_end(s.png, s.info);
    return true;
}

bool write_all(Session& s, const DecodedImage& picture, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    const Image& image = picture.image;
    png_set_write_fn(s.png, &s, on_write, on_flush);
    png_set_IHDR(s.png, s.info, png_uint_32(image.width), png_uint_32(image.height),
                 sample_bits(image), image.channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!picture.profile.empty())
        png_set_iCCP(s.png, s.info, "printer", PNG_COMPRESSION_TYPE_BASE, reinterpret_cast<png_const_bytep>(picture.profile.data()),
                     png_uint_32(picture.profile.size()));
    else if (image.encoding.kind == Encoding::Kind::srgb)
        png_set_sRGB_gAMA_and_cHRM(s.png, s.info, PNG_sRGB_INTENT_PERCEPTUAL);
    else
        png_set_gAMA(s.png, s.info,
                     image.encoding.kind == Encoding::Kind::linear ? 1 : 1 / image.encoding.gamma);
    if (picture.pixel_pitch)
        png_set_pHYs(s.png, s.info,
                     png_uint_32(std::lround(mm_per_metre / picture.pixel_pitch->x)),
                     png_uint_32(std::lround(mm_per_metre / picture.pixel_pitch->y)),
                     PNG_RESOLUTION_METER);
    if (!picture.document.empty()) {
        png_text text;
        std::memset(&text, 0, sizeof text);
        text.compression = PNG_ITXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(keyword);
        text.text = const_cast<char*>(picture.document.c_str());
        text.itxt_length = picture.document.size();
        text.lang = const_cast<char*>("");
        text.lang_key = const_cast<char*>("");
        png_set_text(s.png, s.info, &text, 1);
    }
    png_write_info(s.png, s.info);
    if (sample_bits(image) == 16 && little_endian())
        png_set_swap(s.png);
    png_write_image(s.png, rows);
    png_write_end(s.png, s.info);
    return true;
}

/// Owns a session's libpng objects.
struct ReadSession : Session {
    ReadSession()
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<Session*>(this), on_error,
                                     on_warning);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info)
            throw std::bad_alloc();
    }
    ~ReadSession() { png_destroy_read_struct(&png, &info, nullptr); }
};

struct WriteSession : Session {
    WriteSession()
    {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<Session*>(this), on_error,
                                      on_warning);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info)
            throw std::bad_alloc();
    }
    ~WriteSession() { png_destroy_write_struct(&png, &info); }
};

Encoding encoding_of(const Session& s)
{
    int intent;
    double gamma;
    if (png_get_sRGB(s.png, s.info, &intent) || !png_get_gAMA(s.png, s.info, &gamma))
        return {};
    if (std::fabs(gamma - 1) < 1e-4)
        return {Encoding::Kind::linear, 1};
    return gamma > 0.01 && gamma < 100 ? Encoding{Encoding::Kind::power, 1 / gamma} : Encoding{};
}

std::string document_of(const Session& s)
{
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(s.png, s.info, &texts, &count);
    for (int i = 0; i < count; ++i)
        if (std::strcmp(texts[i].key, keyword) == 0 && texts[i].text)
            return texts[i].text;
    return "";
}

std::vector<png_bytep> row_pointers(Image& image)
{
    std::vector<png_bytep> rows;
    std::visit(
        [&](auto& samples) {
            for (int y = 0; y < image.height; ++y)
                rows.push_back(reinterpret_cast<png_bytep>(
                    samples.data() + std::size_t(y) * image.width * image.channels));
        },
        image.samples);
    return rows;
}

} // namespace

PictureHeader decode_png_header(const std::string& bytes)
{
    ReadSession s;
    s.input = &bytes;
    if (!read_header(s))
        throw std::runtime_error(s.message);
    return {int(png_get_image_width(s.png, s.info)), int(png_get_image_height(s.png, s.info)), int(png_get_bit_depth(s.png, s.info)), document_of(s)};
}

DecodedImage decode_png(const std::string& bytes)
{
    check_chunks(bytes);
    ReadSession s;
    s.input = &bytes;
    if (!read_header(s))
        throw std::runtime_error(s.message);

    const auto width = png_get_image_width(s.png, s.info);
    const auto height = png_get_image_height(s.png, s.info);
    const int channels = png_get_channels(s.png, s.info), bits = png_get_bit_depth(s.png, s.info);
    check_plausible_size(double(s.row_bytes) * height, double(bytes.size()), greatest_deflate_ratio);
    check_memory(double(width) * height * channels * (bits / 8));
    if ((channels != 3 && channels != 4) || (bits != 8 && bits != 16))
        throw std::runtime_error("it is a kind of PNG that cannot be read");

    DecodedImage picture;
    picture.image =
        bits == 16 ? make_image<std::uint16_t>(int(width), int(height), channels, encoding_of(s))
                   : make_image<std::uint8_t>(int(width), int(height), channels, encoding_of(s));
    auto rows = row_pointers(picture.image);
    if (!read_rows(s, rows.data()))
        throw std::runtime_error(s.message);
    picture.document = document_of(s);

    png_uint_32 x = 0, y = 0;
    int unit = 0;
    if (png_get_pHYs(s.png, s.info, &x, &y, &unit) && unit == PNG_RESOLUTION_METER && x && y)
        picture.pixel_pitch = Vec2{mm_per_metre / x, mm_per_metre / y};
    return picture;
}

std::string encode_png(const DecodedImage& picture)
{
    WriteSession s;
    std::string output;
    s.output = &output;
    auto rows = row_pointers(const_cast<Image&>(picture.image)); // libpng only reads them
    if (!write_all(s, picture, rows.data()))
        throw std::runtime_error(s.message);
    return output;
}

} // namespace integral
