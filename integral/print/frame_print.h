// SPDX-License-Identifier: AGPL-3.0-or-later
// Prints a frame pixel for pixel: its pages as files, or as pictures for a printer.
#ifndef INTEGRAL_PRINT_FRAME_PRINT_H
#define INTEGRAL_PRINT_FRAME_PRINT_H

#include "integral/base/parallel.h"
#include "integral/io/image_file.h"
#include "integral/print/colour_profile.h"
#include "integral/print/lens_halftone.h"
#include "integral/print/page_raster.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace integral {

enum class PageFormat { pdf, tiff, png };

/// The format of a page's file by its name; "-" is PNG. Throws OutputError for other names.
PageFormat page_format(const std::string& path);

/// Describes a print's frame in one line: scene, sheet, film, date and error figure. `path`: of the
/// frame, used if its metadata name no scene. The date is today's or, for reproducible builds, that
/// of SOURCE_DATE_EPOCH. Throws std::invalid_argument if this variable gives no date.
std::string print_title(const std::string& path, const FrameMetadata& metadata);

/// Nominal pixel pitch of a printer, mm. `feed`: printed length divided by nominal length, across
/// and down. `dpi`: the printer's nominal resolution, if known. Throws std::invalid_argument if the
/// film's pixel pitch, divided by `feed`, is not that of `dpi`.
Vec2 printer_pitch(const Film& film, Vec2 feed, const std::optional<Vec2>& dpi);

/// Composites a picture over white paper: three channels, 8 or 16 bits, sRGB. A picture of that
/// form is returned unchanged; grey becomes three equal channels.
Image over_white(Image picture, int bits);

struct PrintSettings {
    Vec2 pixel_pitch;                   ///< nominal, of the printer, mm
    PageRequest page;                   ///< layout of the pages
    std::string title;                  ///< of the document
    int bits = 0;                       ///< for each colour, 8 or 16; 0: as many as the frame has
    std::optional<std::string> profile; ///< path of the printer's ICC profile, RGB or CMYK;
                                        ///< by default sRGB
    Intent intent = Intent::relative;
    std::optional<HalftoneSettings> halftone; ///< pages of 8 bits; works without a profile only
};

/// The pages of a frame, ready to be written. Only some rows of the frame are in memory at a time.
class FramePrint {
public:
    /// `frame` must have metadata, must not have been read yet, and must outlive the print. Throws
    /// std::invalid_argument if the paper is too small, InputError for the profile, also if white
    /// ink is requested and the profile is not CMYK.
    FramePrint(FrameReader& frame, const PrintSettings& settings);

    /// Prints frames as one picture, whose geometry is `geometry`: frames[k] stands at the place
    /// settings.page.frames[k]. Otherwise as the other constructor.
    FramePrint(const std::vector<FrameReader*>& frames, const FrameMetadata& geometry,
               const PrintSettings& settings);

    int page_count() const { return int(pages_.size()); }

    /// Names of the pages' inks; empty for R, G and B, and for grey.
    std::vector<std::string> inks() const;

    /// Writes the pages to one .pdf, or as pictures, with numbers if there are several, and with
    /// their geometry if they can be replayed. A .pdf of inks is a PDF/X-4. `progress` counts
    /// pages; it is not called for a .pdf. Throws std::invalid_argument if a page cannot be drawn,
    /// InputError, OutputError, Interrupted.
    void write(const std::string& path, const Progress& progress = {});

    /// The pages as pictures in memory, in R, G and B or in inks. Throws as `write` does.
    std::vector<Image> pictures();

private:
    /// A frame whose rows are read from the top. Copies side by side share it.
    struct FrameRows {
        FrameReader* reader = nullptr;
        int next = 0; ///< the reader's current row
        std::optional<LensHalftone> halftone;
        Image block;       ///< the last halftoned rows: those before row `next`
        int band_row = -1; ///< the first row of `band`
        Image band;        ///< the last rows, as on the page

        Image read(int rows);
    };
    /// A frame, and its place in the picture.
    struct Source {
        std::shared_ptr<FrameRows> frame;
        PixelRectangle place;
    };

    const Image& rows_of_frame(FrameRows& frame, int first, int count);
    Image new_rows_of_frame(FrameRows& frame, int first, int count);
    Image halftoned_rows(FrameRows& frame, int first, int count);
    Image rows(int first, int count);
    bool is_two_tone() const;
    PictureRows row_source();
    PictureWriter page_writer(const Page& page, const std::string& path) const;
    void write_pdf_file(const std::string& path);
    void write_pictures(const std::string& path, const Progress& progress);

    std::vector<Source> sources_;
    FrameMetadata geometry_; ///< of the picture
    std::vector<Page> pages_;
    Image form_; ///< of the picture on the pages; it has no samples
    Vec2 pixel_pitch_;
    std::string profile_, title_; ///< the profile's bytes
    std::optional<ProfileTransform> transform_;
    int levels_ = 0; ///< of the halftone, if there is one
};

} // namespace integral

#endif
