// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes PNG: the document in an iTXt chunk `integral`, the resolution in pHYs, the encoding in
// sRGB or gAMA.
#include "integral/io/codecs.h"
#include "integral/io/packed_bits.h"
#include "integral/io/png_session.h"

#include <cmath>
#include <new>

namespace integral {
namespace {

void on_write(png_structp png, png_bytep data, png_size_t count)
{
    auto* session = static_cast<PngSession*>(png_get_io_ptr(png));
    try { // no exception may pass through libpng
        session->output->write(session->output->size(), data, count);
    } catch (...) {
        session->failure = std::current_exception();
    }
    if (session->failure)
        png_error(png, "it cannot be written");
}

void on_flush(png_structp) {}
void on_warning(png_structp, png_const_charp) {}

/// Sets how the samples' values are interpreted: a printer's profile, sRGB or a power.
void set_colours(PngSession& s, const DecodedImage& picture)
{
    const Encoding& encoding = picture.image.encoding;
    if (!picture.profile.empty())
        png_set_iCCP(s.png, s.info, "printer", PNG_COMPRESSION_TYPE_BASE,
                     reinterpret_cast<png_const_bytep>(picture.profile.data()),
                     png_uint_32(picture.profile.size()));
    else if (encoding.kind == Encoding::Kind::srgb)
        png_set_sRGB_gAMA_and_cHRM(s.png, s.info, PNG_sRGB_INTENT_PERCEPTUAL);
    else
        png_set_gAMA(s.png, s.info,
                     encoding.kind == Encoding::Kind::linear ? 1 : 1 / encoding.gamma);
}

void set_document(PngSession& s, const std::string& document)
{
    png_text text;
    std::memset(&text, 0, sizeof text);
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(png_keyword);
    text.text = const_cast<char*>(document.c_str());
    text.itxt_length = document.size();
    text.lang = const_cast<char*>("");
    text.lang_key = const_cast<char*>("");
    png_set_text(s.png, s.info, &text, 1);
}

bool write_header(PngSession& s, const DecodedImage& picture)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    const Image& image = picture.image;
    png_set_write_fn(s.png, &s, on_write, on_flush);
    png_set_IHDR(s.png, s.info, png_uint_32(image.width), png_uint_32(image.height),
                 picture.two_tone ? 1 : sample_bits(image),
                 image.channels == 1   ? PNG_COLOR_TYPE_GRAY
                 : image.channels == 4 ? PNG_COLOR_TYPE_RGBA
                                       : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    set_colours(s, picture);
    if (picture.pixel_pitch)
        png_set_pHYs(s.png, s.info, png_uint_32(std::lround(mm_per_metre / picture.pixel_pitch->x)),
                     png_uint_32(std::lround(mm_per_metre / picture.pixel_pitch->y)),
                     PNG_RESOLUTION_METER);
    if (!picture.document.empty())
        set_document(s, picture.document);
    png_write_info(s.png, s.info);
    if (sample_bits(image) == 16 && little_endian())
        png_set_swap(s.png);
    return true;
}

bool write_rows(PngSession& s, png_const_bytep first, std::size_t step, int rows)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    for (int y = 0; y < rows; ++y)
        png_write_row(s.png, first + std::size_t(y) * step);
    return true;
}

bool write_end(PngSession& s)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_write_end(s.png, s.info);
    return true;
}

struct WriteSession : PngSession {
    WriteSession()
    {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<PngSession*>(this),
                                      on_png_error, on_warning);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info)
            throw std::bad_alloc();
    }
    ~WriteSession() { png_destroy_write_struct(&png, &info); }
};

class PngWriter : public RowWriter {
public:
    PngWriter(ByteSink& sink, const DecodedImage& head) : two_tone_(head.two_tone)
    {
        s_.output = &sink;
        check(write_header(s_, head));
    }
    void write(const Image& band) override
    {
        if (two_tone_) {
            for (int y = 0; y < band.height; ++y)
                check(write_rows(s_, packed_bits(row_bytes(band, y), band.width).data(), 0, 1));
            return;
        }
        check(write_rows(s_, row_bytes(band, 0), bytes_a_row(band), band.height));
    }
    void finish() override { check(write_end(s_)); }

private:
    void check(bool done)
    {
        if (s_.failure)
            std::rethrow_exception(s_.failure);
        if (!done)
            throw std::runtime_error(s_.message);
    }

    WriteSession s_;
    bool two_tone_;
};

} // namespace

std::unique_ptr<RowWriter> write_png(ByteSink& sink, const DecodedImage& head)
{
    return std::make_unique<PngWriter>(sink, head);
}

} // namespace integral
