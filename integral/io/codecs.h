// SPDX-License-Identifier: AGPL-3.0-or-later
// Readers and writers of the image formats PNG, OpenEXR, TIFF and JPEG, row by row or as whole
// files in memory. To be included only by the readers and writers themselves, image_file.cpp,
// image_writer.cpp, printed pages, the strips of a frame, the replay's page, depth maps and the
// tests; all other files include image_file.h.
#ifndef INTEGRAL_IO_CODECS_H
#define INTEGRAL_IO_CODECS_H

#include "integral/base/file_bytes.h"
#include "integral/frame/image.h"
#include "integral/io/input_file.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral {

/// A picture as its file stores it, with the file's metadata.
struct DecodedImage {
    Image image;
    std::string document;            ///< the JSON document, unparsed; empty if there is none
    std::optional<Vec2> pixel_pitch; ///< mm, from the file's resolution
    std::string profile = "";        ///< bytes of an ICC profile of R, G and B, empty if none
    int orientation = 1;             ///< 1 to 8, as in Exif and TIFF; 1 is upright. Never written
    bool grey = false;               ///< the file has one channel, read as three equal ones
    bool colours_converted = false;  ///< from a profile, so that a document's encoding no longer
                                     ///< applies
    std::vector<std::string> inks{}; ///< names of the channels if they are inks: cyan, magenta,
                                     ///< yellow, black, and spot inks. Only for writing TIFF
    bool two_tone = false; ///< to write: all samples, 8 bits of one channel, are 0 or 255,
                           ///< and PNG and TIFF store them in one bit
};

/// Reads a picture row by row, from the top.
class RowReader {
public:
    virtual ~RowReader() = default;

    /// The file's metadata, from before and after its pixels. The image has size, form and
    /// encoding, but no samples.
    const DecodedImage& head() const { return head_; }

    /// Reads the next band.height rows into `band`, which has the picture's form and width. The
    /// call that reads the last rows also checks the rest of the file. Interlaced and turned
    /// pictures are read into memory whole. Throws std::runtime_error or std::bad_alloc.
    virtual void read(Image& band) = 0;

    /// Returns messages for the user about the file as far as it is read, such as a decoder's
    /// warnings; each message only once.
    virtual std::vector<std::string> take_notices() { return std::exchange(notices_, {}); }
    void add_notice(const std::string& sentence) { notices_.push_back(sentence); }

protected:
    DecodedImage head_;

private:
    std::vector<std::string> notices_;
};

/// A part of a file: `count` bytes from `at`, or all up to the file's end if there are fewer.
struct ByteRange {
    std::uint64_t at = 0, count = UINT64_MAX;
};

/// Each function opens a picture and reads its metadata, but no pixels. Throws std::runtime_error
/// with the reason (without the file's name) if the file is not valid. The file must outlive the
/// reader. Grey pictures are read as three equal channels, CMYK as RGB. `view`: the number of a
/// view, from the left; without it the leftmost of several views is read, with a notice.
/// `directory`: of a TIFF's picture; without it the first of several pictures is read, with a
/// notice. The rows are as stored: neither turned
/// upright nor converted from a profile of R, G and B.
std::unique_ptr<RowReader> read_png(const InputFile& file);
std::unique_ptr<RowReader> read_exr(const InputFile& file, std::optional<int> view = {});
std::unique_ptr<RowReader> read_tiff(const InputFile& file, std::optional<int> directory = {});
std::unique_ptr<RowReader> read_jpeg(const InputFile& file, ByteRange range = {});

/// Number of views in an OpenEXR file: 1 unless it is a stereo or multi-view picture. Throws as
/// read_exr does.
int views_in_exr(const InputFile& file);

/// The directories of a TIFF's pictures, in the file's order, without small copies and masks of
/// other pictures. Throws as read_tiff does.
std::vector<int> picture_directories_of_tiff(const InputFile& file);

/// Opens a picture of any of these formats, by the file's first bytes, and shows it as viewers do:
/// upright, and in the working space. `path`: the file's name; if the format is not recognised, its
/// extension selects the error: a broken picture, or a file of another format.
std::unique_ptr<RowReader> read_any(const InputFile& file, const std::string& path = "");

/// Reads all views of an MPO or a multi-view OpenEXR, the leftmost first, or all pictures of a
/// TIFF, or all layers of an OpenRaster file, the lowest first, but at most `most` of them; any
/// other file gives one picture. `take_notices` gets the readers' notices. Throws
/// std::runtime_error if a picture cannot be read, or, before any pixel is read, if all pictures
/// together need more memory than is free.
std::vector<Image> read_list_of_views(const InputFile& file,
                                      const std::function<void(RowReader&)>& take_notices,
                                      std::size_t most = SIZE_MAX);

/// Reads a whole picture; no row may have been read before. Throws std::runtime_error if the
/// picture cannot be read or needs more memory than is free.
DecodedImage whole_picture(RowReader& reader);

/// A picture of zeros of the size and form of `form`. Throws std::runtime_error if it needs more
/// memory than is free.
Image whole_blank(const Image& form);

/// Each reads a whole picture from the bytes of a file. Throws as whole_picture does.
DecodedImage decode_png(const std::string& bytes);
DecodedImage decode_exr(const std::string& bytes);
DecodedImage decode_tiff(const std::string& bytes);

/// The part of a file before its pixels: size, bits per sample, and the JSON document (empty if
/// there is none).
struct PictureHeader {
    int width = 0, height = 0, bits = 0;
    std::string document;
};

/// Each takes the first bytes of a file, which must contain everything before the pixels. Throws as
/// decode_png does.
PictureHeader decode_png_header(const std::string& bytes);
PictureHeader decode_exr_header(const std::string& bytes);

/// Whether an OpenEXR file can be read to its end. Holds only a few rows in memory at a time.
bool is_whole_exr(const std::string& path);

/// A depth frame as its file stores it: channels Z (`depth`) and A (`imaged`), size and document.
struct DecodedDepths {
    int width = 0, height = 0;
    std::vector<float> depth, imaged;
    std::string document;
    std::vector<float> eye_distances;
};

/// Reads a depth frame from the bytes of an OpenEXR file. Throws as read_exr does.
DecodedDepths decode_depths(const std::string& bytes);

/// A channel of floats, row by row from the top left, and its name in an OpenEXR file.
struct NamedFloats {
    const char* name;
    const std::vector<float>* values;
};

/// Encodes `channels` of depths, each of width x height values, as an OpenEXR file. `unit`: of
/// channel Y (depth_attribute.h). An empty document is not written. Throws std::runtime_error.
std::string encode_depths(int width, int height, const std::vector<NamedFloats>& channels,
                          const char* unit, const std::string& document);

/// Writes a picture row by row, from the top.
class RowWriter {
public:
    virtual ~RowWriter() = default;
    /// Writes all rows of `band`, which has the picture's form and width, as the next rows.
    virtual void write(const Image& band) = 0;
    /// Completes the file. All rows must have been written.
    virtual void finish() = 0;
};

/// Each accepts the forms that its format can store: PNG 8 or 16 bits, not premultiplied; EXR 32
/// bits, linear, premultiplied; TIFF any, and inks. An empty document is not written. Only size and
/// form of `head.image` are used, not its samples. The sink must outlive the writer. All throw
/// std::runtime_error with the reason, and whatever the sink throws.
std::unique_ptr<RowWriter> write_png(ByteSink& sink, const DecodedImage& head);
std::unique_ptr<RowWriter> write_exr(ByteSink& sink, const DecodedImage& head);
std::unique_ptr<RowWriter> write_tiff(ByteSink& sink, const DecodedImage& head);

/// Each returns a whole picture as the bytes of a file.
std::string encode_png(const DecodedImage& picture);
std::string encode_exr(const DecodedImage& picture);
std::string encode_tiff(const DecodedImage& picture);

/// A picture as the bytes of a JPEG without JFIF or Exif: 8 bits of sRGB. `quality`: 0 to 100.
/// Throws std::runtime_error.
std::string encode_jpeg(const Image& picture, int quality);

/// Throws std::runtime_error if `raw_bytes` of pixels cannot be stored in a file of `file_bytes`,
/// where `ratio` is the highest compression ratio of the format. This check prevents huge
/// allocations for a malformed header.
void check_plausible_size(double raw_bytes, double file_bytes, double ratio);

} // namespace integral

#endif
