// SPDX-License-Identifier: AGPL-3.0-or-later
// Frames and pictures as files: PNG (8 or 16 bit), OpenEXR and TIFF, with their metadata.
#ifndef INTEGRAL_IO_IMAGE_FILE_H
#define INTEGRAL_IO_IMAGE_FILE_H

#include "integral/base/file_bytes.h"
#include "integral/lightfield/depth_range.h"
#include "integral/lightfield/frame.h"

#include <memory>
#include <string>
#include <utility>

namespace integral {

enum class ImageFormat { png, exr, tiff };

/// Format by a file name's extension (png, exr, tif, tiff; any case); "-" is PNG.
/// Throws OutputError naming the legal ones.
ImageFormat format_for(const std::string& path);

/// Reads a picture, its format told by its first bytes; "-" is standard input. Geometry:
/// `sheet_file` if it is not empty (a JSON document in a file), else the picture's own, else the
/// document beside it (FRAME.json or FRAME.EXTENSION.json for FRAME.EXTENSION), else none.
/// Views of a frame have no geometry of their own.
/// The encoding is the document's, else what the format says of it, else sRGB.
/// Throws InputError.
Frame read_frame(const std::string& path, const std::string& sheet_file = "");

/// A frame that is read row by row, from the top.
class FrameReader {
public:
    /// Opens a picture as read_frame does, and reads what its file says of it, but no pixel. Throws
    /// InputError.
    explicit FrameReader(const std::string& path, const std::string& sheet_file = "");
    ~FrameReader();

    /// Its geometry, and the form of its image, which has no samples.
    const Frame& frame() const;

    /// Throws InputError where it has no geometry.
    void require_metadata() const;

    /// Reads the next rows, as many as `band` has, which is of the frame's form and width. Throws
    /// InputError.
    void read(Image& band);

    /// The frame with all its pixels, of which none has been read. Throws InputError, too where it
    /// needs more memory than is free.
    Frame whole();

    /// Begins again at the top.
    void restart();

private:
    struct Source;
    std::unique_ptr<Source> source_;
};

/// Views of a frame, and the geometry of that frame, where the picture says it.
struct Views {
    Image image;
    std::optional<FrameMetadata> metadata; ///< with its quilt record
};

/// Reads a quilt or one view of it. Throws InputError; for a geometry that cannot be used only if
/// it is needed.
Views read_views(const std::string& path, bool needs_geometry);

/// Width and height of a picture, of which no pixel is read. Throws InputError.
std::pair<int, int> picture_size(const std::string& path);

/// A scan: a picture, and its pixels' width and height (mm) where the file says its resolution.
struct Scan {
    Image image;
    std::optional<Vec2> pixel_pitch;
};

/// Reads a picture as a scan; a geometry that it may carry is none of a scan's. Throws InputError.
Scan read_scan(const std::string& path);

/// As read_frame, of a picture that must have geometry.
Frame read_frame_with_metadata(const std::string& path, const std::string& sheet_file = "");

/// Reads a geometry document: a JSON file, or a picture's own (of views: their frame's). Throws
/// InputError.
FrameMetadata read_metadata(const std::string& path);

/// Reads a depth frame, which has its geometry in it. Throws InputError.
DepthFrame read_depths(const std::string& path);

/// A picture that is written row by row, from the top, and appears whole or not at all.
class PictureWriter {
public:
    /// A frame, views of one or a picture as write_frame writes them. `form`: its size and form
    /// (samples are not looked at). Throws OutputError.
    static PictureWriter of_frame(const std::string& path, const Image& form,
                                  const std::optional<FrameMetadata>& metadata);

    /// A page as write_page writes it.
    static PictureWriter of_page(const std::string& path, const Image& form, Vec2 pixel_pitch,
                                 const std::string& profile,
                                 const std::optional<FrameMetadata>& geometry);

    PictureWriter(PictureWriter&&) noexcept;
    ~PictureWriter(); ///< leaves what was at the path, unless finish() was called

    /// Writes the next rows: all of `band`. Throws OutputError.
    void write(const Image& band);

    /// Gives the file its name, once all rows are written. Throws OutputError.
    void finish();

private:
    struct Target;
    explicit PictureWriter(std::unique_ptr<Target> target);
    std::unique_ptr<Target> target_;
};

/// Writes a frame, views of one or a picture, its format by its name, with the document and the
/// physical resolution if it has metadata. Converts to what the format holds: EXR linear light,
/// premultiplied; PNG 16 bits and sRGB for floats. Throws OutputError; what was at `path` is then
/// unharmed.
void write_frame(const std::string& path, const Frame& frame);

/// Writes a page for a printer, PNG or TIFF, as it is (8 or 16 bits, three channels): its own
/// resolution, its colours' ICC profile, and the geometry that it has as a frame, if any. Throws as
/// write_frame.
void write_page(const std::string& path, const Image& page, Vec2 pixel_pitch,
                const std::string& profile, const std::optional<FrameMetadata>& geometry);

} // namespace integral

#endif
