// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads frames and pictures (PNG, OpenEXR, TIFF, JPEG, OpenRaster) and writes them, with their
// metadata, as PNG (8 or 16 bit), OpenEXR or TIFF.
#ifndef INTEGRAL_IO_IMAGE_FILE_H
#define INTEGRAL_IO_IMAGE_FILE_H

#include "integral/base/file_bytes.h"
#include "integral/frame/depth_range.h"
#include "integral/frame/frame.h"

#include <memory>
#include <string>
#include <utility>

namespace integral {

enum class ImageFormat { png, exr, tiff };

/// The format for a file name's extension (png, exr, tif or tiff, in any case); PNG for "-". Throws
/// OutputError, with the legal extensions, for any other.
ImageFormat format_for(const std::string& path);

/// Reads a picture as viewers show it, upright and in the working space; "-" is standard input. The
/// first bytes indicate the format. Messages for the user about it go to give_notice. The geometry
/// comes from the first of these that exists: `sheet_file` (a JSON file; "" for none), the
/// picture's own document, a document in the same folder (FRAME.EXTENSION.json, then FRAME.json,
/// for FRAME.EXTENSION). A picture that holds views of a frame gets no geometry. The encoding is
/// the document's, else the format's own, else sRGB. Throws InputError.
Frame read_frame(const std::string& path, const std::string& sheet_file = "");

/// Reads a frame row by row, from the top.
class FrameReader {
public:
    /// Opens a picture as read_frame does and reads its metadata, but no pixel. Throws InputError.
    explicit FrameReader(const std::string& path, const std::string& sheet_file = "");
    ~FrameReader();

    /// The geometry, and the image's size and form without samples.
    const Frame& frame() const;

    /// Throws InputError if the frame has no geometry.
    void require_metadata() const;
    /// Throws InputError if the frame is for replay through a projection lens.
    void refuse_projection() const;

    /// Reads the next band.height rows into `band`, which has the frame's form and width. Throws
    /// InputError.
    void read(Image& band);

    /// Reads the whole frame; no row may have been read before. Throws InputError if it cannot be
    /// read or needs more memory than is free.
    Frame whole();

    /// Starts again at the top row.
    void restart();

private:
    struct Source;
    std::unique_ptr<Source> source_;
};

/// A picture of views of a frame, and that frame's geometry if the picture carries it.
struct Views {
    Image image;
    std::optional<FrameMetadata> metadata; ///< with the quilt record
};

/// Reads a quilt, or a single view of a quilt, row by row, from the top.
class ViewsReader {
public:
    /// Opens the picture and reads its geometry, but no pixels. Throws InputError if the picture
    /// cannot be read, or if `needs_geometry` and its geometry is not valid.
    ViewsReader(const std::string& path, bool needs_geometry);
    ~ViewsReader();

    /// The geometry, and the picture's size and form without samples.
    const Views& head() const;

    /// Throws InputError if the whole picture needs more memory than is free.
    void check_memory() const;

    /// Reads the next band.height rows into `band`, which has the picture's form and width. Throws
    /// InputError.
    void read(Image& band);

    /// Reads the whole picture; no row may have been read before. Throws InputError.
    Views whole();

private:
    struct Source;
    std::unique_ptr<Source> source_;
};

/// Reads a quilt, or a single view of a quilt, at once. Throws as ViewsReader does.
Views read_views(const std::string& path, bool needs_geometry);

/// Whether a path names a file for two or more views: it ends in .mpo, in any case.
bool is_mpo(const std::string& path);

/// Whether a file holds several views of a scene: its name ends in .mpo, in any case, or it is a
/// stereo or multi-view OpenEXR. Throws InputError if an OpenEXR cannot be read.
bool is_list_of_views(const std::string& path);

/// Reads all views of a file, the leftmost first, or all pictures of a TIFF, or all layers of an
/// OpenRaster file, the lowest first, but at most `most`; other files give one picture. Throws
/// InputError.
std::vector<Image> read_list_of_views(const std::string& path, std::size_t most = SIZE_MAX);

/// Names of the visible layers of an OpenRaster file (.ora), the lowest first; at least one. Throws
/// InputError.
std::vector<std::string> names_of_layers(const std::string& path);

/// Width and height of a picture, without reading its pixels. Throws InputError.
std::pair<int, int> picture_size(const std::string& path);

/// A scanned picture, and the width and height of a pixel (mm) if the file has a resolution.
struct Scan {
    Image image;
    std::optional<Vec2> pixel_pitch;
};

/// Reads a picture as a scan and ignores any geometry in it. Throws InputError.
Scan read_scan(const std::string& path);

/// Reads a frame like read_frame, but throws InputError if there is no geometry.
Frame read_frame_with_metadata(const std::string& path, const std::string& sheet_file = "");
/// Reads a frame for commands without projection lenses; throws InputError also if the frame is for
/// a projection lens.
Frame read_sheet_frame(const std::string& path, const std::string& sheet_file = "");

/// Reads a geometry document from a JSON file, a frame, or a picture of views (their frame's
/// geometry). Throws InputError.
FrameMetadata read_metadata(const std::string& path);

/// Reads a depth frame with the geometry that it carries. Throws InputError.
DepthFrame read_depths(const std::string& path);

/// Writes a depth frame as an OpenEXR file with its geometry, without its eye_distances. Throws
/// OutputError; an old file at `path` is then unchanged.
void write_depths(const std::string& path, const DepthFrame& frame);

/// Writes a picture row by row, from the top. The file appears at its path only when it is
/// complete.
class PictureWriter {
public:
    /// Writes the same file as write_frame. Only size and form of `form` are used, not its samples.
    /// Throws OutputError.
    static PictureWriter of_frame(const std::string& path, const Image& form,
                                  const std::optional<FrameMetadata>& metadata);

    /// Writes the same file as write_page. `inks`: names of the channels if they are inks, which
    /// only TIFF can hold.
    static PictureWriter of_page(const std::string& path, const Image& form, Vec2 pixel_pitch,
                                 const std::string& profile,
                                 const std::optional<FrameMetadata>& geometry,
                                 const std::vector<std::string>& inks = {});

    /// Writes a page of one channel of 8 bits, sRGB, without a profile. If `two_tone`, all samples
    /// are 0 or 255, and the file stores them in one bit.
    static PictureWriter of_grey_page(const std::string& path, const Image& form, Vec2 pixel_pitch,
                                      bool two_tone, const std::optional<FrameMetadata>& geometry);

    PictureWriter(PictureWriter&&) noexcept;
    ~PictureWriter(); ///< keeps an old file at the path unless finish() was called

    /// Writes all rows of `band` as the next rows. Throws OutputError.
    void write(const Image& band);

    /// Completes the file and renames it to its path. All rows must have been written. Throws
    /// OutputError.
    void finish();

private:
    struct Target;
    explicit PictureWriter(std::unique_ptr<Target> target);
    std::unique_ptr<Target> target_;
};

/// Writes a frame, a picture of views or any other picture in the format of its file name. If the
/// frame has metadata, the file gets the document and, except for a picture of views, the physical
/// resolution. Samples are converted to the format's form: EXR linear light, premultiplied; floats
/// in a PNG 16 bits, linear light as sRGB. Throws OutputError; an old file at `path` is then
/// unchanged.
void write_frame(const std::string& path, const Frame& frame);

/// Writes a page for a printer as PNG or TIFF without converting its samples (8 or 16 bits, three
/// channels), with its resolution from `pixel_pitch` (mm), the ICC profile of its colours, and its
/// geometry as a frame, if any. Throws as write_frame does.
void write_page(const std::string& path, const Image& page, Vec2 pixel_pitch,
                const std::string& profile, const std::optional<FrameMetadata>& geometry);

} // namespace integral

#endif
