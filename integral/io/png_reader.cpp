// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads PNG: the document in an iTXt chunk `integral`, the resolution in pHYs, the encoding in sRGB
// or gAMA.
#include "integral/io/codecs.h"
#include "integral/io/exif.h"
#include "integral/io/png_session.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace integral {
namespace {

constexpr double greatest_deflate_ratio = 1100; // deflate reaches 1032

/// Records only warnings about a colour profile that cannot be read; no others affect the picture.
void on_warning(png_structp png, png_const_charp message)
{
    auto* session = static_cast<PngSession*>(png_get_error_ptr(png));
    if (session->warning[0] == '\0' && std::strncmp(message, "iCCP", 4) == 0 &&
        !std::strstr(message, "known incorrect"))
        std::snprintf(session->warning, sizeof session->warning, "%s", message);
}

/// Refills `ahead` from the input. Returns null, or a message if that fails.
const char* read_ahead(PngSession& s)
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
    auto* session = static_cast<PngSession*>(png_get_io_ptr(png));
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

bool read_header(PngSession& s)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_set_read_fn(s.png, &s, on_read);
    png_set_user_limits(s.png, 1000000, 1000000);
    png_read_info(s.png, s.info);
    s.row_bytes = png_get_rowbytes(s.png, s.info);
    s.grey = (png_get_color_type(s.png, s.info) & PNG_COLOR_MASK_COLOR) == 0;
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
bool read_rows(PngSession& s, png_bytep first, std::size_t step, int rows, bool last)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    for (int y = 0; y < rows; ++y)
        png_read_row(s.png, first + std::size_t(y) * step, nullptr);
    if (last)
        png_read_end(s.png, s.info);
    return true;
}

bool read_interlaced(PngSession& s, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(s.png)))
        return false;
    png_read_image(s.png, rows);
    png_read_end(s.png, s.info);
    return true;
}

/// A session that owns libpng's objects for reading.
struct ReadSession : PngSession {
    ReadSession()
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<PngSession*>(this),
                                     on_png_error, on_warning);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info)
            throw std::bad_alloc();
    }
    ~ReadSession() { png_destroy_read_struct(&png, &info, nullptr); }
};

Encoding encoding_of(const PngSession& s)
{
    int intent;
    double gamma;
    if (png_get_valid(s.png, s.info, PNG_INFO_iCCP)) // which takes precedence over gAMA
        return {};
    if (png_get_sRGB(s.png, s.info, &intent) || !png_get_gAMA(s.png, s.info, &gamma))
        return {};
    if (std::fabs(gamma - 1) < 1e-4)
        return {Encoding::Kind::linear, 1};
    return gamma > 0.01 && gamma < 100 ? Encoding{Encoding::Kind::power, 1 / gamma} : Encoding{};
}

std::string document_of(const PngSession& s)
{
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(s.png, s.info, &texts, &count);
    for (int i = 0; i < count; ++i)
        if (std::strcmp(texts[i].key, png_keyword) == 0 && texts[i].text)
            return texts[i].text;
    return "";
}

std::optional<Vec2> pixel_pitch_of(const PngSession& s)
{
    png_uint_32 x = 0, y = 0;
    int unit = 0;
    if (png_get_pHYs(s.png, s.info, &x, &y, &unit) && unit == PNG_RESOLUTION_METER && x && y)
        return Vec2{mm_per_metre / x, mm_per_metre / y};
    return std::nullopt;
}

std::string profile_of(const PngSession& s)
{
    png_charp name = nullptr;
    int compression = 0;
    png_bytep profile = nullptr;
    png_uint_32 size = 0;
    if (!png_get_iCCP(s.png, s.info, &name, &compression, &profile, &size))
        return "";
    return {reinterpret_cast<const char*>(profile), size};
}

int orientation_of(const PngSession& s)
{
#ifdef PNG_eXIf_SUPPORTED
    png_uint_32 size = 0;
    png_bytep block = nullptr;
    if (png_get_eXIf_1(s.png, s.info, &size, &block))
        return exif_facts({reinterpret_cast<const char*>(block), size}).orientation;
#endif
    return 1;
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
        head_.profile = profile_of(s_);
        head_.orientation = orientation_of(s_);
        head_.grey = s_.grey;
        if (s_.warning[0])
            add_notice(std::string("its colour profile is not used: ") + s_.warning);
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

} // namespace integral
