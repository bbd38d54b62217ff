// SPDX-License-Identifier: AGPL-3.0-or-later
// A frame laid out on pages of paper, in whole pixels of the printer: nothing is resampled.
#ifndef INTEGRAL_OUTPUT_PAGE_H
#define INTEGRAL_OUTPUT_PAGE_H

#include "integral/lightfield/frame_metadata.h"
#include "integral/output/paper.h"

#include <string>
#include <vector>

namespace integral {

/// What a user asks for. mm.
struct PageRequest {
    std::optional<Paper> paper; ///< as it is fed: width and height are not exchanged. Nothing: as
                                ///< large as picture and marks
    bool centre_on_lens = true; ///< a lens's pole (lenticular: axis) at the page's middle, else the
                                ///< picture's middle
    double trim = 0; ///< of the picture's edge, all around, that is cut off afterwards (bleed); >=
                     ///< 0
    bool crop_marks = false, registration_marks = false, axis_marks = false;
    bool tiles = false;    ///< on several pages, where one is too small
    double overlap = 10;   ///< of neighbouring tiles; >= 0
    bool mirrored = false; ///< for printing on the back of the lens sheet
    std::string strip;     ///< a line of text below the picture; empty: none
};

/// A straight line on a page, mm from its top left corner (y downwards). Lines are one printer
/// pixel wide.
struct PageLine {
    Vec2 from, to;
};

/// A rectangle in printer pixels, from the top left.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

struct Page {
    int width = 0, height = 0; ///< printer pixels
    Vec2 pixel_pitch;          ///< of the printer, as it counts: mm
    PixelRectangle part;       ///< of the picture
    int x = 0, y = 0;          ///< where its top left pixel comes
    PixelRectangle trimmed;    ///< what is left after cutting
    bool mirrored = false;     ///< the whole page is turned left to right, the picture included
    std::vector<PageLine> lines;
    std::string strip;                              ///< its text
    Vec2 strip_place;                               ///< where its baseline begins, mm
    double strip_size = 0;                          ///< of its letters' em, mm
    int column = 0, row = 0, columns = 1, rows = 1; ///< of tiles
};

/// `printer_pitch`: mm a pixel by the printer's own count. The film's real pixel pitch may differ
/// from it by the paper's feed. Throws std::invalid_argument, a sentence for the user, where the
/// paper is too small for what is asked.
std::vector<Page> lay_out(const FrameMetadata& metadata, Vec2 printer_pitch,
                          const PageRequest& request);

/// The geometry of a page as a frame of its own, for replaying it: its film is the page. The eye
/// that saw the frame from a place sees the page from `shift` mm beside it, which is where the
/// frame's middle is on the page. Nothing: the page is mirrored.
struct PageGeometry {
    FrameMetadata metadata;
    Vec2 shift;
};
std::optional<PageGeometry> geometry_of(const Page& page, const FrameMetadata& frame);

} // namespace integral

#endif
