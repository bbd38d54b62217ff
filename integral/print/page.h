// SPDX-License-Identifier: AGPL-3.0-or-later
// Lays a frame out on pages of paper, in whole pixels of the printer: nothing is resampled.
#ifndef INTEGRAL_PRINT_PAGE_H
#define INTEGRAL_PRINT_PAGE_H

#include "integral/frame/frame_metadata.h"
#include "integral/print/paper.h"

#include <string>
#include <vector>

namespace integral {

/// A rectangle in printer pixels, from the top left.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

/// One of several frames in a picture that holds them side by side.
struct PlacedFrame {
    PixelRectangle place; ///< in the picture
    double trim = 0;      ///< mm that are cut off its edges after printing
};

/// Where white ink goes, a fifth ink for clear or dark material: nowhere, on the whole page, or
/// under the picture as far as that is opaque.
enum class WhiteInk { none, full, picture };

/// Options of a page layout. Lengths in mm.
struct PageRequest {
    /// The paper as it is fed: its width and height are not exchanged. Without it, the page is as
    /// large as the picture and its marks.
    std::optional<Paper> paper;
    /// Whether the pole of a lens (the axis of a lenticular one) comes to the page's middle; else
    /// the picture's middle does.
    bool centre_on_lens = true;
    double trim = 0; ///< width of the edge that is cut off all around after printing (bleed), >= 0
    bool crop_marks = false, registration_marks = false, axis_marks = false;
    bool tiles = false;              ///< several pages, if one is too small
    double overlap = 10;             ///< shared by neighbouring tiles, >= 0
    bool mirrored = false;           ///< for printing on the back of the lens sheet
    std::string strip;               ///< a line of text below the picture; empty: none
    WhiteInk white = WhiteInk::none; ///< only for a picture in inks
    std::vector<PlacedFrame> frames; ///< to be cut apart, instead of `trim`; empty: the picture is
                                     ///< one frame. Not with `tiles`
};

/// A straight line on a page, mm from its top left corner (y downwards). Lines are one printer
/// pixel wide.
struct PageLine {
    Vec2 from, to;
};

/// A frame on a page, or the part of it that a tile shows.
struct FrameOnPage {
    PixelRectangle picture, trimmed; ///< all of it, and what remains after cutting
};

struct Page {
    int width = 0, height = 0; ///< printer pixels
    Vec2 pixel_pitch;          ///< nominal, of the printer, mm
    PixelRectangle part;       ///< the part of the picture that is on the page
    int x = 0, y = 0;          ///< place of the part's top left pixel on the page
    PixelRectangle trimmed;    ///< the part that remains after cutting, or a box around all such
    std::vector<FrameOnPage> frames; ///< at least one
    bool mirrored = false;           ///< whether the whole page is mirrored left to right
    WhiteInk white = WhiteInk::none;
    std::vector<PageLine> lines;
    std::string strip;                              ///< the strip's text
    Vec2 strip_place;                               ///< start of the strip's baseline, mm
    double strip_size = 0;                          ///< the em of its letters, mm
    int column = 0, row = 0, columns = 1, rows = 1; ///< the tile's place, and number of tiles
};

/// Room for the picture on request.paper, which must be set, in pixels; along a roll, as much as a
/// page may have. Throws std::invalid_argument if the paper has more.
PixelSize room_on_paper(Vec2 printer_pitch, const PageRequest& request);

/// Lays the frame out on one page, or on as many tiles as necessary, row by row. `printer_pitch` is
/// the nominal size of a printer pixel, mm; the film's pixel pitch may differ from it by the
/// printer's feed error. Throws std::invalid_argument, with a sentence for the user, if the paper
/// is too small for the request.
std::vector<Page> lay_out(const FrameMetadata& metadata, Vec2 printer_pitch,
                          const PageRequest& request);

/// The geometry of a page as a frame of its own, whose film is the page, so that it can be
/// replayed.
struct PageGeometry {
    FrameMetadata metadata;
    Vec2 shift; ///< from the page's middle to the frame's, mm; an eye must move by as much to see
                ///< the page as it saw the frame
};

/// The geometry of a frame's page. Empty if the page is mirrored.
std::optional<PageGeometry> geometry_of(const Page& page, const FrameMetadata& frame);

} // namespace integral

#endif
