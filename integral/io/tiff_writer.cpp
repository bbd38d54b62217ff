// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes TIFF: the document in ImageDescription, the resolution in the resolution tags. 8 or 16 bit
// integers or 32 bit floats, or two tones in 1 bit; grey or RGB, with or without alpha, or inks; in
// strips.
#include "integral/io/codecs.h"
#include "integral/io/packed_bits.h"
#include "integral/io/tiff_stream.h"

#include "integral/optics/film.h"

#include <cstring>

namespace integral {
namespace {

class TiffWriter : public RowWriter {
public:
    TiffWriter(ByteSink& sink, const DecodedImage& head) : two_tone_(head.two_tone)
    {
        stream_.output = &sink;
        tiff_ = open_tiff(stream_, "w");
        TIFF* tiff = tiff_.get();
        const Image& image = head.image;
        const int bits = two_tone_ ? 1 : sample_bits(image);
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.width);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.height);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, image.channels);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
                     bits == 32 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
        TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
                     !head.inks.empty()    ? PHOTOMETRIC_SEPARATED
                     : image.channels == 1 ? PHOTOMETRIC_MINISBLACK
                                           : PHOTOMETRIC_RGB);
        TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
        if (!two_tone_)
            TIFFSetField(tiff, TIFFTAG_PREDICTOR,
                         bits == 32 ? PREDICTOR_FLOATINGPOINT : PREDICTOR_HORIZONTAL);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
        if (!head.inks.empty()) {
            set_inks(head.inks);
        } else if (image.channels == 4) {
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
            if (two_tone_)
                row_ = packed_bits(row_bytes(band, y), length);
            else
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
    /// The first four inks are cyan, magenta, yellow and black; spot inks are extra samples, so
    /// that readers of CMYK find their colours.
    void set_inks(const std::vector<std::string>& inks)
    {
        TIFF* tiff = tiff_.get();
        TIFFSetField(tiff, TIFFTAG_INKSET, INKSET_CMYK);
        const std::vector<std::uint16_t> spots(inks.size() - 4, EXTRASAMPLE_UNSPECIFIED);
        if (spots.empty())
            return;
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, std::uint16_t(spots.size()), spots.data());
        std::string names; // each ends in a zero byte
        for (const std::string& ink : inks)
            names += ink + '\0';
        TIFFSetField(tiff, TIFFTAG_INKNAMES, std::uint16_t(names.size()), names.data());
    }

    void check(bool done) const
    {
        if (stream_.failure)
            std::rethrow_exception(stream_.failure);
        if (!done)
            fail_tiff("it cannot be encoded");
    }

    TiffStream stream_;
    TiffHandle tiff_;
    std::vector<unsigned char> row_;
    std::uint32_t next_ = 0;
    bool two_tone_;
};

} // namespace

std::unique_ptr<RowWriter> write_tiff(ByteSink& sink, const DecodedImage& head)
{
    return std::make_unique<TiffWriter>(sink, head);
}

} // namespace integral
