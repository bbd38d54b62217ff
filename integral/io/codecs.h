// SPDX-License-Identifier: AGPL-3.0-or-later
// The image formats, row by row, and from bytes and to bytes. For image_file.cpp, printed pages,
// the strips of a frame, the replay's page and the tests alone.
#ifndef INTEGRAL_IO_CODECS_H
#define INTEGRAL_IO_CODECS_H

#include "integral/base/file_bytes.h"
#include "integral/io/input_file.h"
#include "integral/lightfield/image.h"

#include <memory>
#include <optional>
#include <string>

namespace integral {

/// A picture as a file holds it, with what the file says of the frame.
struct DecodedImage {
    Image image;
    std::string document;            ///< the JSON document, unparsed; empty if there is none
    std::optional<Vec2> pixel_pitch; ///< mm, from the file's resolution
    std::string profile = ""; ///< an ICC file's bytes; only written, by PNG and TIFF; empty: none
};

/// A picture that is read row by row, from the top.
class RowReader {
public:
    virtual ~RowReader() = default;

    /// What the file says of the picture, which stands in it before or behind the pixels: the image
    /// is a form without samples.
    const DecodedImage& head() const { return head_; }

    /// Reads the next rows, as many as `band` has, which is of the picture's form and width. The
    /// last ones with what stands behind them in the file. Interlaced pictures, and TIFFs whose
    /// channels stand apart, come into memory whole. Throws std::runtime_error or std::bad_alloc.
    virtual void read(Image& band) = 0;

protected:
    DecodedImage head_;
};

/// Each reads what a file says of its picture, and no pixel. Throws std::runtime_error with the
/// reason (no file name) if that makes no sense. The file has to outlive the reader. Greys become
/// three equal channels.
std::unique_ptr<RowReader> read_png(const InputFile& file);
std::unique_ptr<RowReader> read_exr(const InputFile& file);
std::unique_ptr<RowReader> read_tiff(const InputFile& file);

/// As these do, of the format that the first bytes tell.
std::unique_ptr<RowReader> read_any(const InputFile& file);

/// All of a picture of which no row has been read yet. Throws std::runtime_error, too where it
/// needs more memory than is free.
DecodedImage whole_picture(RowReader& reader);

/// A picture of zeros of that form, for all of it. Throws as whole_picture does.
Image whole_blank(const Image& form);

/// The same of a file's bytes.
DecodedImage decode_png(const std::string& bytes);
DecodedImage decode_exr(const std::string& bytes);
DecodedImage decode_tiff(const std::string& bytes);

/// What a file says before its pixels: size, bits a sample, and the JSON document, empty if there
/// is none.
struct PictureHeader {
    int width = 0, height = 0, bits = 0;
    std::string document;
};

/// Each takes a file's first bytes, which hold all that comes before the pixels. Throws as
/// decode_png does.
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

/// Throws as read_exr does.
DecodedDepths decode_depths(const std::string& bytes);

/// A picture that is written row by row, from the top.
class RowWriter {
public:
    virtual ~RowWriter() = default;
    /// Writes the next rows: all of `band`, which is of the picture's form and width.
    virtual void write(const Image& band) = 0;
    /// Completes the file, all of whose rows have been written.
    virtual void finish() = 0;
};

/// Each takes the forms that its format can hold: PNG 8 or 16 bits, not premultiplied; EXR
/// 32 bits, linear, premultiplied; TIFF any. An empty document is left out. The image of `head`
/// says the form; its samples are not looked at. The sink has to outlive the writer. All throw
/// std::runtime_error with the reason, and what the sink throws.
std::unique_ptr<RowWriter> write_png(ByteSink& sink, const DecodedImage& head);
std::unique_ptr<RowWriter> write_exr(ByteSink& sink, const DecodedImage& head);
std::unique_ptr<RowWriter> write_tiff(ByteSink& sink, const DecodedImage& head);

/// The same of a whole picture, as bytes.
std::string encode_png(const DecodedImage& picture);
std::string encode_exr(const DecodedImage& picture);
std::string encode_tiff(const DecodedImage& picture);

/// Throws unless a picture of this many bytes can come of a file this long: `ratio` is the
/// greatest that its compression reaches. What a malformed header cannot make us allocate.
void check_plausible_size(double raw_bytes, double file_bytes, double ratio);

} // namespace integral

#endif
