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
#include <limits>
#include <memory>
#include <stdexcept>

namespace integral {
namespace {

constexpr double greatest_ratio = 10000; // LZMA's and Zstandard's long runs
constexpr int largest_side = 1000000;

thread_local char last_error[160];

void on_error(const char*, const char* format, va_list arguments)
{
    if (last_error[0] == '\0') // the first is the cause
        std::vsnprintf(last_error, sizeof last_error, format, arguments);
}

/// libtiff drops a tag that it cannot read with a warning; if it is the document's, the file is broken.
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

/// A file in memory, as libtiff's callbacks see it: `output` if it is being written.
struct Memory {
    const std::string* input = nullptr;
    std::string* output = nullptr;
    std::size_t position = 0;
    std::size_t size() const { return output ? output->size() : input->size(); }
};

tmsize_t on_read(thandle_t handle, void* data, tmsize_t count)
{
    auto& memory = *static_cast<Memory*>(handle);
    const char* bytes = memory.output ? memory.output->data() : memory.input->data();
    if (count <= 0 || memory.position >= memory.size())
        return 0;
    const auto n = std::min(std::size_t(count), memory.size() - memory.position);
    std::memcpy(data, bytes + memory.position, n);
    memory.position += n;
    return tmsize_t(n);
}

tmsize_t on_write(thandle_t handle, void* data, tmsize_t count)
{
    auto& memory = *static_cast<Memory*>(handle);
    try {
        if (memory.position + std::size_t(count) > memory.output->size())
            memory.output->resize(memory.position + std::size_t(count));
    } catch (const std::exception&) { // must not pass through libtiff
        return 0;
    }
    std::memcpy(&(*memory.output)[memory.position], data, std::size_t(count));
    memory.position += std::size_t(count);
    return count;
}

toff_t on_seek(thandle_t handle, toff_t offset, int whence)
{
    auto& memory = *static_cast<Memory*>(handle);
    const toff_t base = whence == SEEK_CUR ? memory.position : whence == SEEK_END ? memory.size() : 0;
    memory.position = std::size_t(base + offset);
    return memory.position;
}

int on_close(thandle_t) { return 0; }
toff_t on_size(thandle_t handle) { return static_cast<Memory*>(handle)->size(); }

struct Closer {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffHandle = std::unique_ptr<TIFF, Closer>;

TiffHandle open_tiff(Memory& memory, const char* mode)
{
    last_error[0] = '\0';
    TIFFSetErrorHandler(on_error);
    TIFFSetWarningHandler(on_warning);
    TiffHandle tiff(TIFFClientOpen("image", mode, &memory, on_read, on_write, on_seek, on_close,
                                   on_size, nullptr, nullptr));
    if (!tiff || last_error[0])
        fail("it cannot be opened as a TIFF");
    return tiff;
}

/// What of a TIFF's tags the decoding needs.
struct Layout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, planar = PLANARCONFIG_CONTIG,
                  photometric = PHOTOMETRIC_MINISBLACK;
    int colours = 3;     ///< 1 for greys
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

/// Reads all rows into `image`, whose samples are of type Sample.
template <class Sample> void read_rows(TIFF* tiff, const Layout& l, Image& image)
{
    auto& samples = std::get<std::vector<Sample>>(image.samples);
    const int planes = l.planar == PLANARCONFIG_SEPARATE ? l.samples : 1;
    const std::size_t per_pixel = l.planar == PLANARCONFIG_SEPARATE ? 1 : l.samples;
    const std::size_t row_bytes = per_pixel * l.width * sizeof(Sample);
    if (TIFFScanlineSize64(tiff) != row_bytes)
        throw std::runtime_error("its rows are not as long as its size says");
    std::vector<Sample> row(per_pixel * l.width);
    for (int plane = 0; plane < planes; ++plane)
        for (std::uint32_t y = 0; y < l.height; ++y) {
            if (TIFFReadScanline(tiff, row.data(), y, std::uint16_t(plane)) < 0)
                fail("it ends too early");
            Sample* out = samples.data() + std::size_t(y) * l.width * image.channels;
            for (std::uint32_t x = 0; x < l.width; ++x, out += image.channels)
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
    for (std::size_t i = 0; i < samples.size(); i += std::size_t(image.channels)) {
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

} // namespace

DecodedImage decode_tiff(const std::string& bytes)
{
    Memory memory;
    memory.input = &bytes;
    const TiffHandle tiff = open_tiff(memory, "rm"); // m: do not map
    const Layout l = layout_of(tiff.get());
    check_plausible_size(double(l.width) * l.height * l.samples * (l.bits / 8),
                         double(bytes.size()), greatest_ratio);

    DecodedImage picture;
    const int channels = l.alpha ? 4 : 3, width = int(l.width), height = int(l.height);
    if (l.bits == 8) {
        picture.image = make_image<std::uint8_t>(width, height, channels, {});
        read_rows<std::uint8_t>(tiff.get(), l, picture.image);
    } else if (l.bits == 16) {
        picture.image = make_image<std::uint16_t>(width, height, channels, {});
        read_rows<std::uint16_t>(tiff.get(), l, picture.image);
    } else {
        picture.image = make_image<float>(width, height, channels, {Encoding::Kind::linear, 1});
        read_rows<float>(tiff.get(), l, picture.image);
    }
    picture.image.premultiplied = l.premultiplied;
    const char* text = nullptr;
    if (TIFFGetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, &text) && text && text[0] == '{')
        picture.document = text; // other programs' descriptions are not JSON
    picture.pixel_pitch = pixel_pitch_of(tiff.get());
    return picture;
}

std::string encode_tiff(const DecodedImage& picture)
{
    const Image& image = picture.image;
    const int bits = sample_bits(image);
    std::string output;
    Memory memory;
    memory.output = &output;
    {
        const TiffHandle handle = open_tiff(memory, "w");
        TIFF* tiff = handle.get();
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.width);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.height);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, image.channels);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
                     bits == 32 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
        TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
        TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
        TIFFSetField(tiff, TIFFTAG_PREDICTOR,
                     bits == 32 ? PREDICTOR_FLOATINGPOINT : PREDICTOR_HORIZONTAL);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
        if (image.channels == 4) {
            const std::uint16_t kind =
                image.premultiplied ? EXTRASAMPLE_ASSOCALPHA : EXTRASAMPLE_UNASSALPHA;
            TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &kind);
        }
        if (picture.pixel_pitch) {
            TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
            TIFFSetField(tiff, TIFFTAG_XRESOLUTION, mm_per_inch / picture.pixel_pitch->x);
            TIFFSetField(tiff, TIFFTAG_YRESOLUTION, mm_per_inch / picture.pixel_pitch->y);
        }
        if (!picture.profile.empty())
            TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(picture.profile.size()), picture.profile.data());
        if (!picture.document.empty())
            TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, picture.document.c_str());

        std::visit(
            [&](const auto& samples) {
                using Sample = typename std::decay_t<decltype(samples)>::value_type;
                const std::size_t length = std::size_t(image.width) * image.channels;
                std::vector<Sample> row(length); // libtiff's predictor works in place
                for (int y = 0; y < image.height; ++y) {
                    const Sample* from = samples.data() + std::size_t(y) * length;
                    std::copy(from, from + length, row.begin());
                    if (TIFFWriteScanline(tiff, row.data(), std::uint32_t(y)) < 0)
                        fail("it cannot be encoded");
                }
            },
            image.samples);
        if (!TIFFFlush(tiff))
            fail("it cannot be encoded");
    }
    return output;
}

} // namespace integral
