// SPDX-License-Identifier: AGPL-3.0-or-later
// TIFF: the document in ImageDescription, the resolution in the resolution tags. 8 or 16 bit
// integers or 32 bit floats; grey or RGB, with or without alpha; in strips.
#include "integral/io/codecs.h"

#include "integral/optics/film.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>

namespace integral {
namespace {

constexpr double greatest_ratio = 10000; // of LZMA and Zstandard for long runs
constexpr int largest_side = 1000000;

thread_local char last_error[160];

void on_error(const char*, const char* format, va_list arguments)
{
    if (last_error[0] == '\0') // keep the first message, which names the cause
        std::vsnprintf(last_error, sizeof last_error, format, arguments);
}

/// libtiff skips a tag that it cannot read and warns. If it is the tag of the document, the file
/// counts as damaged.
void on_warning(const char*, const char* format, va_list arguments)
{
    char text[sizeof last_error];
    std::vsnprintf(text, sizeof text, format, arguments);
    if (std::strstr(text, "ImageDescription"))
        std::memcpy(last_error, text, sizeof text);
}

[[noreturn]] void fail(const char* otherwise)
{
    throw std::runtime_error(last_error[0] ? last_error : otherwise);
}

/// The file that libtiff's callbacks read, or write if `output` is set.
struct Stream {
    const InputFile* input = nullptr;
    ByteSink* output = nullptr;
    std::uint64_t position = 0;
    std::exception_ptr failure = nullptr; ///< exception thrown by the output
    std::uint64_t size() const { return output ? output->size() : input->size(); }
};

tmsize_t on_read(thandle_t handle, void* data, tmsize_t count)
{
    auto& stream = *static_cast<Stream*>(handle);
    if (count <= 0 || stream.position >= stream.size())
        return 0;
    auto n = std::size_t(std::min<std::uint64_t>(count, stream.size() - stream.position));
    try { // no exception may pass through libtiff
        if (stream.output)
            n = stream.output->read(stream.position, data, n);
        else
            stream.input->read(stream.position, data, n);
    } catch (const std::exception&) {
        return 0;
    }
    stream.position += n;
    return tmsize_t(n);
}

tmsize_t on_write(thandle_t handle, void* data, tmsize_t count)
{
    auto& stream = *static_cast<Stream*>(handle);
    try {
        stream.output->write(stream.position, data, std::size_t(count));
    } catch (...) {
        stream.failure = std::current_exception();
        return 0;
    }
    stream.position += std::uint64_t(count);
    return count;
}

toff_t on_seek(thandle_t handle, toff_t offset, int whence)
{
    auto& stream = *static_cast<Stream*>(handle);
    const toff_t base = whence == SEEK_CUR   ? stream.position
                        : whence == SEEK_END ? stream.size()
                                             : 0;
    stream.position = base + offset;
    return stream.position;
}

int on_close(thandle_t) { return 0; }
toff_t on_size(thandle_t handle) { return static_cast<Stream*>(handle)->size(); }

struct Closer {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffHandle = std::unique_ptr<TIFF, Closer>;

TiffHandle open_tiff(Stream& stream, const char* mode)
{
    last_error[0] = '\0';
    TIFFSetErrorHandler(on_error);
    TIFFSetWarningHandler(on_warning);
    TiffHandle tiff(TIFFClientOpen("image", mode, &stream, on_read, on_write, on_seek, on_close,
                                   on_size, nullptr, nullptr));
    if (!tiff || last_error[0])
        fail("it cannot be opened as a TIFF");
    return tiff;
}

/// The values of a TIFF's tags that decoding needs.
struct Layout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, planar = PLANARCONFIG_CONTIG,
                  photometric = PHOTOMETRIC_MINISBLACK;
    int colours = 3; ///< 1 for greys
    bool alpha = false, premultiplied = false;
};

Layout layout_of(TIFF* tiff)
{
    Layout l;
    std::uint16_t orientation = ORIENTATION_TOPLEFT, compression = COMPRESSION_NONE;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &l.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &l.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &l.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &l.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &l.format);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &l.planar);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &orientation);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &l.photometric);
    TIFFGetField(tiff, TIFFTAG_COMPRESSION, &compression);

    if (l.width < 1 || l.height < 1 || l.width > largest_side || l.height > largest_side)
        throw std::runtime_error("its size makes no sense");
    if (TIFFIsTiled(tiff) || orientation != ORIENTATION_TOPLEFT ||
        !TIFFIsCODECConfigured(compression))
        throw std::runtime_error(
            "it is tiled, turned or of an unknown compression; save it in strips, upright");
    const bool integers = l.format == SAMPLEFORMAT_UINT && (l.bits == 8 || l.bits == 16);
    if (!integers && !(l.format == SAMPLEFORMAT_IEEEFP && l.bits == 32))
        throw std::runtime_error("its samples are neither 8 or 16 bit integers nor 32 bit floats");
    const bool grey = l.photometric == PHOTOMETRIC_MINISBLACK ||
                      (l.photometric == PHOTOMETRIC_MINISWHITE && integers);
    if (!grey && l.photometric != PHOTOMETRIC_RGB)
        throw std::runtime_error("its colours are neither grey nor RGB; save it as RGB");
    l.colours = grey ? 1 : 3;
    if (l.samples < l.colours)
        throw std::runtime_error("it has fewer than three samples a pixel");

    std::uint16_t extras = 0;
    const std::uint16_t* kinds = nullptr;
    if (l.samples > l.colours && TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &extras, &kinds) &&
        extras > 0) {
        l.premultiplied = kinds[0] == EXTRASAMPLE_ASSOCALPHA;
        l.alpha = l.premultiplied || kinds[0] == EXTRASAMPLE_UNASSALPHA;
    }
    return l;
}

/// Reads rows `first` to first + band.height - 1 into `band`, whose samples have the type Sample.
template <class Sample> void read_rows(TIFF* tiff, const Layout& l, int first, Image& band)
{
    auto& samples = std::get<std::vector<Sample>>(band.samples);
    const int planes = l.planar == PLANARCONFIG_SEPARATE ? l.samples : 1;
    const std::size_t per_pixel = l.planar == PLANARCONFIG_SEPARATE ? 1 : l.samples;
    std::vector<Sample> row(per_pixel * l.width);
    for (int plane = 0; plane < planes; ++plane)
        for (int y = 0; y < band.height; ++y) {
            if (TIFFReadScanline(tiff, row.data(), std::uint32_t(first + y), std::uint16_t(plane)) <
                0)
                fail("it ends too early");
            Sample* out = samples.data() + std::size_t(y) * l.width * band.channels;
            for (std::uint32_t x = 0; x < l.width; ++x, out += band.channels)
                for (std::size_t s = 0; s < per_pixel; ++s) {
                    const int from = int(s) + plane;
                    const Sample value = row[x * per_pixel + s];
                    if (from < l.colours)
                        out[from] = value;
                    else if (from == l.colours && l.alpha)
                        out[3] = value;
                }
        }
    if (l.colours == 3)
        return;
    for (std::size_t i = 0; i < samples.size(); i += std::size_t(band.channels)) {
        if (l.photometric == PHOTOMETRIC_MINISWHITE)
            samples[i] = Sample(std::numeric_limits<Sample>::max() - samples[i]);
        samples[i + 1] = samples[i + 2] = samples[i];
    }
}

std::optional<Vec2> pixel_pitch_of(TIFF* tiff)
{
    float x = 0, y = 0;
    std::uint16_t unit = RESUNIT_INCH;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
    if (!TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &x) ||
        !TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &y) || !(x > 0) || !(y > 0) ||
        unit == RESUNIT_NONE)
        return std::nullopt;
    const double mm = unit == RESUNIT_CENTIMETER ? 10 : mm_per_inch;
    return Vec2{mm / x, mm / y};
}

class TiffReader : public RowReader {
public:
    explicit TiffReader(const InputFile& file)
    {
        stream_.input = &file;
        tiff_ = open_tiff(stream_, "rm"); // m: no memory mapping
        TIFF* tiff = tiff_.get();
        layout_ = layout_of(tiff);
        const Layout& l = layout_;
        check_plausible_size(double(l.width) * l.height * l.samples * (l.bits / 8),
                             double(file.size()), greatest_ratio);
        const std::size_t per_pixel = l.planar == PLANARCONFIG_SEPARATE ? 1 : l.samples;
        if (TIFFScanlineSize64(tiff) != per_pixel * l.width * (l.bits / 8))
            throw std::runtime_error("its rows are not as long as its size says");
        head_.image = form_of(l.bits, int(l.width), int(l.height), l.alpha ? 4 : 3,
                              l.bits == 32 ? Encoding{Encoding::Kind::linear, 1} : Encoding{});
        head_.image.premultiplied = l.premultiplied;
        const char* text = nullptr;
        if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) && text && text[0] == '{')
            head_.document = text; // ignore other programs' descriptions, which are not JSON
        head_.pixel_pitch = pixel_pitch_of(tiff);
    }

    void read(Image& band) override
    {
        last_error[0] = '\0';
        if (layout_.planar == PLANARCONFIG_SEPARATE && band.height < head_.image.height) {
            if (all_.height == 0) { // each channel is a plane of its own
                Image all = whole_blank(head_.image);
                read_from(0, all);
                all_ = std::move(all);
            }
            const std::size_t row = std::size_t(band.width) * band.channels * (layout_.bits / 8);
            for (int y = 0; y < band.height; ++y)
                std::memcpy(row_bytes(band, y), row_bytes(all_, next_ + y), row);
        } else {
            read_from(next_, band);
        }
        next_ += band.height;
    }

private:
    void read_from(int first, Image& band)
    {
        std::visit(
            [&](const auto& samples) {
                using Sample = typename std::decay_t<decltype(samples)>::value_type;
                read_rows<Sample>(tiff_.get(), layout_, first, band);
            },
            head_.image.samples);
    }

    Stream stream_;
    TiffHandle tiff_;
    Layout layout_;
    Image all_; ///< the whole picture, if its channels are separate planes
    int next_ = 0;
};

class TiffWriter : public RowWriter {
public:
    TiffWriter(ByteSink& sink, const DecodedImage& head)
    {
        stream_.output = &sink;
        tiff_ = open_tiff(stream_, "w");
        TIFF* tiff = tiff_.get();
        const Image& image = head.image;
        const int bits = sample_bits(image);
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.width);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.height);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, image.channels);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
                     bits == 32 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
        TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
                     image.channels == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
        TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
        TIFFSetField(tiff, TIFFTAG_PREDICTOR,
                     bits == 32 ? PREDICTOR_FLOATINGPOINT : PREDICTOR_HORIZONTAL);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
        if (image.channels == 4) {
            const std::uint16_t kind = image.premultiplied ? EXTRASAMPLE_ASSOCALPHA
                                                           : EXTRASAMPLE_UNASSALPHA;
            TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &kind);
        }
        if (head.pixel_pitch) {
            TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
            TIFFSetField(tiff, TIFFTAG_XRESOLUTION, mm_per_inch / head.pixel_pitch->x);
            TIFFSetField(tiff, TIFFTAG_YRESOLUTION, mm_per_inch / head.pixel_pitch->y);
        }
        if (!head.profile.empty())
            TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(head.profile.size()),
                         head.profile.data());
        if (!head.document.empty())
            TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, head.document.c_str());
    }

    void write(const Image& band) override
    {
        const std::size_t length = std::size_t(band.width) * band.channels *
                                   (sample_bits(band) / 8);
        row_.resize(length); // libtiff's predictor works in place
        for (int y = 0; y < band.height; ++y, ++next_) {
            std::memcpy(row_.data(), row_bytes(band, y), length);
            check(TIFFWriteScanline(tiff_.get(), row_.data(), next_) >= 0);
        }
    }

    void finish() override
    {
        check(TIFFFlush(tiff_.get()));
        tiff_.reset();
        check(true);
    }

private:
    void check(bool done) const
    {
        if (stream_.failure)
            std::rethrow_exception(stream_.failure);
        if (!done)
            fail("it cannot be encoded");
    }

    Stream stream_;
    TiffHandle tiff_;
    std::vector<unsigned char> row_;
    std::uint32_t next_ = 0;
};

} // namespace

std::unique_ptr<RowReader> read_tiff(const InputFile& file)
{
    return std::make_unique<TiffReader>(file);
}

std::unique_ptr<RowWriter> write_tiff(ByteSink& sink, const DecodedImage& head)
{
    return std::make_unique<TiffWriter>(sink, head);
}

} // namespace integral
