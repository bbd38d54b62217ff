// SPDX-License-Identifier: AGPL-3.0-or-later
// PNG: the document in an iTXt chunk `integral`, the resolution in pHYs, the encoding in sRGB or
// gAMA.
#include "integral/io/codecs.h"
#include "integral/io/png_spans.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace integral {
namespace {

constexpr char keyword[] = "integral";
constexpr double mm_per_metre = 1000;
constexpr double greatest_deflate_ratio = 1100; // deflate reaches 1032

/// The state that libpng's callbacks need. libpng reports errors by longjmp, so the functions below
/// that call setjmp, and what they call, have no local objects with destructors.
struct Session {
    png_structp png = nullptr;
    png_infop info = nullptr;
    const InputFile* input = nullptr;
    std::vector<ByteSpan> spans; ///< parts of the input, in the order in which libpng gets them
    std::vector<unsigned char> ahead; ///< bytes read from the input for libpng
    std::size_t taken = 0;            ///< number of bytes of `ahead` that libpng has got
    ByteSink* output = nullptr;
    std::exception_ptr failure; ///< exception thrown by the sink
    std::size_t row_bytes = 0;  ///< length of a row in the file, before it is expanded
    char message[160] = "";
};

void on_error(png_structp png, png_const_charp message)
{
    auto* session = static_cast<Session*>(png_get_error_ptr(png));
    std::snprintf(session->message, sizeof session->message, "%s", message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// Refills `ahead` from the input. Returns null, or a message if that fails.
const char* read_ahead(Session& s)
{
    constexpr std::uint64_t most = 1 << 16;
    while (!s.spans.empty() && s.spans.front().count == 0)
        s.spans.erase(s.spans.begin());
    if (s.spans.empty())
        return "the file ends too early";
    ByteSpan& span = s.spans.front();
    const std::uint64_t count = std::min(span.count, most);
    try { // no exception may pass through libpng
        s.ahead.resize(std::size_t(count));
        s.input->read(span.at, s.ahead.data(), s.ahead.size());
    } catch (const std::exception&) {
        return "the file cannot be read to its end";
    }
    span = {span.at + count, span.count - count};
    s.taken = 0;
    return nullptr;
}

void on_read(png_structp png, png_bytep data, png_size_t count)
{
    auto* session = static_cast<Session*>(png_get_io_ptr(png));
    while (count > 0) {
        if (session->taken == session->ahead.size())
            if (const char* why = read_ahead(*session))
                png_error(png, why);
        const std::size_t n = std::min(count, session->ahead.size() - session->taken);
        std::memcpy(data, session->ahead.data() + session->taken, n);
        session->taken += n;
        data += n;
        count -= n;
    }
}

void on_write(png_structp png, png_bytep data, png_size_t count)
{
    auto* session = static_cast<Session*>(png_get_io_ptr(png));
    try { // no exception may pass through libpng
        session->output->write(session->output->size(), data, count);
    } catch (...) {
        session->failure = std::current_exception();
    }
    if (session->failure)
        png_error(png, "it cannot be written");
}

void on_flush(png_structp) {}

bool little_endian()
{
    const std::uint16_t one = 1;
    unsigned char first;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

bool read_header(Session& s)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_set_read_fn(s.png, &s, on_read);
    png_set_user_limits(s.png, 1000000, 1000000);
    png_read_info(s.png, s.info);
    s.row_bytes = png_get_rowbytes(s.png, s.info);
    png_set_expand(s.png); // palettes, few bits, tRNS
    png_set_gray_to_rgb(s.png);
    if (little_endian())
        png_set_swap(s.png);
    png_set_interlace_handling(s.png);
    png_read_update_info(s.png, s.info);
    return true;
}

/// Reads `rows` rows, to `first` and every `step` bytes after it. If `last`, they are the file's
/// last rows, and the rest of the file is read as well. Returns whether that succeeded.
bool read_rows(Session& s, png_bytep first, std::size_t step, int rows, bool last)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    for (int y = 0; y < rows; ++y)
        png_read_row(s.png, first + std::size_t(y) * step, nullptr);
    if (last)
        png_read_end(s.png, s.info);
    return true;
}

bool read_interlaced(Session& s, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_read_image(s.png, rows);
    png_read_end(s.png, s.info);
    return true;
}

/// How the samples' values are to be understood: a printer's profile, sRGB or a power.
void set_colours(Session& s, const DecodedImage& picture)
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

void set_document(Session& s, const std::string& document)
{
    png_text text;
    std::memset(&text, 0, sizeof text);
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(keyword);
    text.text = const_cast<char*>(document.c_str());
    text.itxt_length = document.size();
    text.lang = const_cast<char*>("");
    text.lang_key = const_cast<char*>("");
    png_set_text(s.png, s.info, &text, 1);
}

bool write_header(Session& s, const DecodedImage& picture)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    const Image& image = picture.image;
    png_set_write_fn(s.png, &s, on_write, on_flush);
    png_set_IHDR(s.png, s.info, png_uint_32(image.width), png_uint_32(image.height),
                 sample_bits(image),
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

bool write_rows(Session& s, png_const_bytep first, std::size_t step, int rows)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    for (int y = 0; y < rows; ++y)
        png_write_row(s.png, first + std::size_t(y) * step);
    return true;
}

bool write_end(Session& s)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_write_end(s.png, s.info);
    return true;
}

/// A session that owns libpng's objects for reading.
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

std::optional<Vec2> pixel_pitch_of(const Session& s)
{
    png_uint_32 x = 0, y = 0;
    int unit = 0;
    if (png_get_pHYs(s.png, s.info, &x, &y, &unit) && unit == PNG_RESOLUTION_METER && x && y)
        return Vec2{mm_per_metre / x, mm_per_metre / y};
    return std::nullopt;
}

std::size_t bytes_a_row(const Image& form)
{
    return std::size_t(form.width) * form.channels * (sample_bits(form) / 8);
}

class PngReader : public RowReader {
public:
    PngReader(const InputFile& file, bool whole)
    {
        s_.input = &file;
        s_.spans = png_spans(file, whole);
        if (!read_header(s_))
            throw std::runtime_error(s_.message);
        const int channels = png_get_channels(s_.png, s_.info);
        const int bits = png_get_bit_depth(s_.png, s_.info);
        if ((channels != 3 && channels != 4) || (bits != 8 && bits != 16))
            throw std::runtime_error("it is a kind of PNG that cannot be read");
        head_.image = form_of(bits, int(png_get_image_width(s_.png, s_.info)),
                              int(png_get_image_height(s_.png, s_.info)), channels,
                              encoding_of(s_));
        head_.document = document_of(s_);
        head_.pixel_pitch = pixel_pitch_of(s_);
        interlaced_ = png_get_interlace_type(s_.png, s_.info) != PNG_INTERLACE_NONE;
        if (whole)
            check_plausible_size(double(s_.row_bytes) * head_.image.height, double(file.size()),
                                 greatest_deflate_ratio);
    }

    void read(Image& band) override
    {
        const int end = next_ + band.height;
        if (interlaced_) {
            read_all();
            for (int y = 0; y < band.height; ++y)
                std::memcpy(row_bytes(band, y), row_bytes(all_, next_ + y), bytes_a_row(band));
        } else if (!read_rows(s_, row_bytes(band, 0), bytes_a_row(band), band.height,
                              end == head_.image.height)) {
            throw std::runtime_error(s_.message);
        }
        next_ = end;
    }

private:
    void read_all()
    {
        if (all_.height > 0)
            return;
        Image all = whole_blank(head_.image);
        std::vector<png_bytep> rows;
        for (int y = 0; y < all.height; ++y)
            rows.push_back(row_bytes(all, y));
        if (!read_interlaced(s_, rows.data()))
            throw std::runtime_error(s_.message);
        all_ = std::move(all);
    }

    ReadSession s_;
    bool interlaced_ = false;
    Image all_; ///< the whole picture, if it is interlaced
    int next_ = 0;
};

class PngWriter : public RowWriter {
public:
    PngWriter(ByteSink& sink, const DecodedImage& head)
    {
        s_.output = &sink;
        check(write_header(s_, head));
    }
    void write(const Image& band) override
    {
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
};

} // namespace

PictureHeader decode_png_header(const std::string& bytes)
{
    const InputFile file = InputFile::of_bytes(bytes);
    const PngReader reader(file, false);
    const Image& form = reader.head().image;
    return {form.width, form.height, sample_bits(form), reader.head().document};
}

std::unique_ptr<RowReader> read_png(const InputFile& file)
{
    return std::make_unique<PngReader>(file, true);
}

std::unique_ptr<RowWriter> write_png(ByteSink& sink, const DecodedImage& head)
{
    return std::make_unique<PngWriter>(sink, head);
}

} // namespace integral
