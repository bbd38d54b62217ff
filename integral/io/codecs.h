// SPDX-License-Identifier: AGPL-3.0-or-later
// The image formats, from bytes and to bytes. For image_file.cpp, printed pages, the strips of a frame, the replay's page and the tests alone.
#ifndef INTEGRAL_IO_CODECS_H
#define INTEGRAL_IO_CODECS_H

#include "integral/lightfield/image.h"

#include <optional>
#include <string>

namespace integral {

/// A picture as a file holds it, with what the file says of the frame.
struct DecodedImage {
    Image image;
    std::string document;           ///< the JSON document, unparsed; empty if there is none
    std::optional<Vec2> pixel_pitch; ///< mm, from the file's resolution
    std::string profile = "";        ///< an ICC file's bytes; only written, by PNG and TIFF; empty: none
};

/// Each throws std::runtime_error with the reason (no file name) if the bytes make no sense.
/// Greys become three equal channels.
DecodedImage decode_png(const std::string& bytes);
DecodedImage decode_exr(const std::string& bytes);
DecodedImage decode_tiff(const std::string& bytes);

/// What a file says before its pixels: size, bits a sample, and the JSON document, empty if there is none.
struct PictureHeader {
    int width = 0, height = 0, bits = 0;
    std::string document;
};

/// Each takes a file's first bytes, which hold all that comes before the pixels. Throws as decode_png does.
PictureHeader decode_png_header(const std::string& bytes);
PictureHeader decode_exr_header(const std::string& bytes);

/// Whether an OpenEXR file can be read to its end. Keeps a few rows of it in memory.
bool is_whole_exr(const std::string& path);

/// The channels Z and A of a depth frame, its size and its document.
struct DecodedDepths {
    int width = 0, height = 0;
    std::vector<float> depth, imaged;
    std::string document;
};

/// Throws as decode_exr does.
DecodedDepths decode_depths(const std::string& bytes);

/// Each takes the forms that its format can hold: PNG 8 or 16 bits, not premultiplied; EXR
/// 32 bits, linear, premultiplied; TIFF any. An empty document is left out.
std::string encode_png(const DecodedImage& picture);
std::string encode_exr(const DecodedImage& picture);
std::string encode_tiff(const DecodedImage& picture);

/// Throws unless a picture of this many bytes can come of a file this long: `ratio` is the
/// greatest that its compression reaches. What a malformed header cannot make us allocate.
void check_plausible_size(double raw_bytes, double file_bytes, double ratio);

/// Throws if this machine has not so much memory.
void check_memory(double bytes);

} // namespace integral

#endif
