// SPDX-License-Identifier: AGPL-3.0-or-later
// JPEG, for quilts and views of other programs and for the pictures of MPO pairs: 8 bits of sRGB,
// with losses and without a document.
#include "integral/io/codecs.h"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <jpeglib.h> // needs <cstdio> before it

namespace integral {
namespace {

/// libjpeg reports errors by a function that must not return. The functions below that call setjmp
/// have no local objects with destructors.
struct Failure {
    jpeg_error_mgr manager; // first, as libjpeg hands on its address
    std::jmp_buf place;
    char message[JMSG_LENGTH_MAX] = "";
};

void on_error(j_common_ptr codec)
{
    auto* failure = reinterpret_cast<Failure*>(codec->err);
    codec->err->format_message(codec, failure->message);
    std::longjmp(failure->place, 1);
}

void on_warning(j_common_ptr codec, int level)
{
    if (level < 0) // the data are broken: what follows would be made up
        on_error(codec);
}

void catch_errors(Failure& failure, jpeg_error_mgr*& of_codec)
{
    of_codec = jpeg_std_error(&failure.manager);
    failure.manager.error_exit = on_error;
    failure.manager.emit_message = on_warning;
}

class JpegReader : public RowReader {
public:
    explicit JpegReader(const InputFile& file) : bytes_(file.beginning(file.size()))
    {
        catch_errors(failure_, codec_.err);
        if (!begin()) {
            jpeg_destroy_decompress(&codec_);
            throw std::runtime_error(failure_.message);
        }
        head_.image = form_of(8, int(codec_.image_width), int(codec_.image_height), 3, Encoding());
        constexpr double greatest_ratio = 2000; // 64 pixels of a colour in a few bits
        try {
            check_plausible_size(size_in_bytes(head_.image), double(bytes_.size()), greatest_ratio);
        } catch (const std::runtime_error&) {
            jpeg_destroy_decompress(&codec_);
            throw;
        }
    }

    ~JpegReader() override { jpeg_destroy_decompress(&codec_); }

    void read(Image& band) override
    {
        if (!read_rows(band))
            throw std::runtime_error(failure_.message);
    }

private:
    bool begin()
    {
        if (setjmp(failure_.place))
            return false;
        jpeg_create_decompress(&codec_);
        jpeg_mem_src(&codec_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
        jpeg_read_header(&codec_, TRUE);
        codec_.out_color_space = JCS_RGB;
        return true;
    }

    bool read_rows(Image& band)
    {
        if (setjmp(failure_.place))
            return false;
        if (!started_)
            started_ = jpeg_start_decompress(&codec_) != 0;
        for (int y = 0; y < band.height; ++y) {
            unsigned char* row = row_bytes(band, y);
            jpeg_read_scanlines(&codec_, &row, 1);
        }
        if (codec_.output_scanline == codec_.output_height)
            jpeg_finish_decompress(&codec_);
        return true;
    }

    std::string bytes_;
    Failure failure_;
    jpeg_decompress_struct codec_ = {};
    bool started_ = false;
};

/// The memory that libjpeg fills with a file.
struct Written {
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    ~Written() { std::free(bytes); }
};

bool encode(const Image& picture, int quality, Failure& failure, Written& written)
{
    jpeg_compress_struct codec;
    catch_errors(failure, codec.err);
    if (setjmp(failure.place)) {
        jpeg_destroy_compress(&codec);
        return false;
    }
    jpeg_create_compress(&codec);
    jpeg_mem_dest(&codec, &written.bytes, &written.size);
    codec.image_width = JDIMENSION(picture.width);
    codec.image_height = JDIMENSION(picture.height);
    codec.input_components = 3;
    codec.in_color_space = JCS_RGB;
    jpeg_set_defaults(&codec);
    jpeg_set_quality(&codec, quality, TRUE);
    codec.write_JFIF_header = FALSE; // an MPO's pictures begin with Exif
    codec.comp_info[0].h_samp_factor = codec.comp_info[0].v_samp_factor = 1; // whole colours
    jpeg_start_compress(&codec, TRUE);
    for (int y = 0; y < picture.height; ++y) {
        auto* row = const_cast<unsigned char*>(row_bytes(picture, y));
        jpeg_write_scanlines(&codec, &row, 1);
    }
    jpeg_finish_compress(&codec);
    jpeg_destroy_compress(&codec);
    return true;
}

} // namespace

std::unique_ptr<RowReader> read_jpeg(const InputFile& file)
{
    return std::make_unique<JpegReader>(file);
}

std::string encode_jpeg(const Image& picture, int quality)
{
    const Image plain = converted(picture, 8, Encoding(), false);
    Failure failure;
    Written written;
    if (!encode(plain, quality, failure, written))
        throw std::runtime_error(failure.message);
    return std::string(reinterpret_cast<const char*>(written.bytes), written.size);
}

} // namespace integral
