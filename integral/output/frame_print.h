// SPDX-License-Identifier: AGPL-3.0-or-later
// A frame printed pixel for pixel: its pages as files, or as pictures for a printer.
#ifndef INTEGRAL_OUTPUT_FRAME_PRINT_H
#define INTEGRAL_OUTPUT_FRAME_PRINT_H

#include "integral/base/parallel.h"
#include "integral/io/image_file.h"
#include "integral/output/colour_profile.h"
#include "integral/output/page_raster.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

enum class PageFormat { pdf, tiff, png };

/// The format of a page's file by its name; "-" is PNG. Throws OutputError for other names.
PageFormat page_format(const std::string& path);

/// What a print says of its frame in one line: scene, sheet, film, date and error figure. `path` is
/// the frame's, for frames that name no scene. The date is today's, or SOURCE_DATE_EPOCH's, by
/// which builds are made repeatable. Throws std::invalid_argument where that has no date.
std::string print_title(const std::string& path, const FrameMetadata& metadata);

/// The pixel pitch of a printer by its own count, mm. `feed`: how many times as long as it says it
/// prints, across and down. `dpi`: its resolution, if it is known. Throws std::invalid_argument
/// where the printer's pixels are not the film's.
Vec2 printer_pitch(const Film& film, Vec2 feed, const std::optional<Vec2>& dpi);

/// A picture over white paper: three channels, 8 or 16 bits, sRGB. One of that form comes back as
/// it is.
Image over_white(Image picture, int bits);

struct PrintSettings {
    Vec2 pixel_pitch;                   ///< of the printer, by its own count, mm
    PageRequest page;                   ///< what is laid out
    std::string title;                  ///< of the document
    int bits = 0;                       ///< for each colour, 8 or 16; 0: as many as the frame has
    std::optional<std::string> profile; ///< path of the printer's ICC profile; by default sRGB
    Intent intent = Intent::relative;
};

/// The pages of a frame, ready to be written. Only some rows of the frame are in memory at a time.
class FramePrint {
public:
    /// `frame`: it has metadata, and no row of it has been read; it has to outlive the print.
    /// Throws std::invalid_argument where the paper is too small, InputError for the profile.
    FramePrint(FrameReader& frame, const PrintSettings& settings);

    int page_count() const { return int(pages_.size()); }

    /// Writes the pages: to one .pdf, or as pictures, which get numbers where they are several,
    /// with the geometry of those that can be replayed. `progress` counts pages of pictures. Throws
    /// std::invalid_argument where a page cannot be drawn, InputError, OutputError, Interrupted.
    void write(const std::string& path, const Progress& progress = {});

    /// The pages as pictures in memory. Throws as `write` does.
    std::vector<Image> pictures();

private:
    Image rows(int first, int count);
    PictureRows row_source();
    PictureWriter page_writer(const Page& page, const std::string& path) const;
    void write_pdf_file(const std::string& path);
    void write_pictures(const std::string& path, const Progress& progress);

    FrameReader& reader_;
    int next_ = 0; ///< the row that the reader is at
    std::vector<Page> pages_;
    Image form_; ///< of the picture on the pages; it has no samples
    Vec2 pixel_pitch_;
    std::string profile_, title_; ///< the profile's bytes
    std::optional<ProfileTransform> transform_;
};

} // namespace integral

#endif
