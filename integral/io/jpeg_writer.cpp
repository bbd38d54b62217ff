// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes JPEG, for the pictures of MPO pairs: 8 bits of sRGB, with losses and without a document.
#include "integral/io/codecs.h"
#include "integral/io/jpeg_errors.h"

#include <cstdlib>
#include <stdexcept>

namespace integral {
namespace {

/// The memory that libjpeg fills with a file.
struct Written {
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    ~Written() { std::free(bytes); }
};

bool encode(const Image& picture, int quality, JpegFailure& failure, Written& written)
{
    jpeg_compress_struct codec;
    catch_jpeg_errors(failure, codec.err, [](j_common_ptr, int) {});
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
    codec.comp_info[0].h_samp_factor = codec.comp_info[0].v_samp_factor = 1; // no chroma
                                                                             // subsampling
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

std::string encode_jpeg(const Image& picture, int quality)
{
    const Image plain = converted(picture, 8, Encoding(), false);
    JpegFailure failure;
    Written written;
    if (!encode(plain, quality, failure, written))
        throw std::runtime_error(failure.message);
    return std::string(reinterpret_cast<const char*>(written.bytes), written.size);
}

} // namespace integral
