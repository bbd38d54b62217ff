// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/tiff_layout.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

constexpr int largest_side = 1000000;

void read_tags(TIFF* tiff, TiffLayout& l)
{
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &l.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &l.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &l.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &l.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &l.format);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &l.planar);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &l.orientation);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &l.photometric);
    l.tiled = TIFFIsTiled(tiff);
    if (l.orientation < ORIENTATION_TOPLEFT || l.orientation > ORIENTATION_LEFTBOT)
        l.orientation = ORIENTATION_TOPLEFT; // 0 is written by some scanners
    if (l.format == SAMPLEFORMAT_VOID)
        l.format = SAMPLEFORMAT_UINT;
    if (l.width < 1 || l.height < 1 || l.width > largest_side || l.height > largest_side)
        throw std::runtime_error("its size makes no sense");
}

/// Makes libtiff give the colours of JPEG compressions as RGB, and rejects unknown compressions.
void decode_jpeg_colours(TIFF* tiff, TiffLayout& l)
{
    std::uint16_t compression = COMPRESSION_NONE;
    TIFFGetField(tiff, TIFFTAG_COMPRESSION, &compression);
    if (!TIFFIsCODECConfigured(compression))
        throw std::runtime_error("its compression, number " + std::to_string(compression) +
                                 ", cannot be read; save it with another");
    if (compression == COMPRESSION_OJPEG) {
        l.by_libtiff = true;
    } else if (compression == COMPRESSION_JPEG && l.photometric == PHOTOMETRIC_YCBCR &&
               l.planar == PLANARCONFIG_CONTIG) {
        TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
        l.photometric = PHOTOMETRIC_RGB;
    }
}

void read_palette(TIFF* tiff, TiffLayout& l)
{
    std::uint16_t* channels[3] = {};
    if (l.bits > 8)
        throw std::runtime_error("its palette has more than 256 colours");
    if (!TIFFGetField(tiff, TIFFTAG_COLORMAP, &channels[0], &channels[1], &channels[2]))
        throw std::runtime_error("it has no palette of its colours");
    const std::size_t size = std::size_t(1) << l.bits;
    for (const std::uint16_t* channel : channels)
        l.palette.insert(l.palette.end(), channel, channel + size);
    // Old writers stored 8-bit values in the palette's 16-bit fields.
    if (std::all_of(l.palette.begin(), l.palette.end(), [](auto v) { return v < 256; }))
        for (std::uint16_t& value : l.palette)
            value = std::uint16_t(value * 257);
}

void read_colours(TIFF* tiff, TiffLayout& l)
{
    const bool integers = l.format == SAMPLEFORMAT_UINT;
    switch (l.photometric) {
    case PHOTOMETRIC_MINISWHITE:
    case PHOTOMETRIC_MINISBLACK: l.inks = 1; break;
    case PHOTOMETRIC_PALETTE:
        l.inks = 1;
        read_palette(tiff, l);
        break;
    case PHOTOMETRIC_RGB: l.inks = 3; break;
    case PHOTOMETRIC_SEPARATED: l.inks = 4; break;
    case PHOTOMETRIC_YCBCR: l.by_libtiff = true; break;
    default:
        throw std::runtime_error("its colours (PhotometricInterpretation " +
                                 std::to_string(l.photometric) +
                                 ") cannot be read; save it as RGB");
    }
    if (!integers && (l.photometric == PHOTOMETRIC_MINISWHITE || !l.palette.empty() || l.inks == 4))
        throw std::runtime_error("its samples are floats, but its colours are no grey or RGB");
    std::uint16_t inkset = INKSET_CMYK;
    if (l.inks == 4 && TIFFGetFieldDefaulted(tiff, TIFFTAG_INKSET, &inkset) &&
        inkset != INKSET_CMYK)
        throw std::runtime_error("its inks are not cyan, magenta, yellow and black");
    if (l.samples < l.inks)
        throw std::runtime_error("it has " + std::to_string(l.samples) +
                                 " samples a pixel; its colours need " + std::to_string(l.inks));
}

void check_samples(const TiffLayout& l)
{
    const bool integers = l.format == SAMPLEFORMAT_UINT && (l.bits <= 16 || l.bits == 32);
    const bool floats = l.format == SAMPLEFORMAT_IEEEFP &&
                        (l.bits == 16 || l.bits == 32 || l.bits == 64);
    if (l.bits < 1 || (!integers && !floats))
        throw std::runtime_error("its samples are of a kind that cannot be read; save it with 8 or "
                                 "16 bit integers or 32 bit floats");
}

void read_alpha(TIFF* tiff, TiffLayout& l)
{
    std::uint16_t extras = 0;
    const std::uint16_t* kinds = nullptr;
    if (l.samples > l.inks && TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &extras, &kinds) &&
        extras > 0) {
        l.premultiplied = kinds[0] == EXTRASAMPLE_ASSOCALPHA;
        l.alpha = l.premultiplied || kinds[0] == EXTRASAMPLE_UNASSALPHA;
    }
}

} // namespace

int TiffLayout::read_bits() const
{
    if (by_libtiff)
        return 8;
    if (format == SAMPLEFORMAT_IEEEFP)
        return 32;
    if (palette.empty())
        return bits <= 8 ? 8 : 16;
    const bool narrow = std::all_of(palette.begin(), palette.end(),
                                    [](auto v) { return v % 257 == 0 || (v & 255) == 0; });
    return narrow ? 8 : 16;
}

TiffLayout tiff_layout(TIFF* tiff)
{
    TiffLayout l;
    read_tags(tiff, l);
    decode_jpeg_colours(tiff, l);
    read_colours(tiff, l);
    if (l.by_libtiff) {
        char why[1024] = "";
        if (!TIFFRGBAImageOK(tiff, why))
            throw std::runtime_error(why);
        TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT); // the caller turns it
        return l;
    }
    check_samples(l);
    read_alpha(tiff, l);
    return l;
}

} // namespace integral
