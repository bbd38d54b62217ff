// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes an interactive replay of a frame, or of two frames to be compared, as one HTML page for any
// browser with WebGL 2.
#ifndef INTEGRAL_REPLAY_REPLAY_PAGE_H
#define INTEGRAL_REPLAY_REPLAY_PAGE_H

#include "integral/compare/compare.h"
#include "integral/io/markup.h"
#include "integral/replay/replay.h"

#include <optional>
#include <string>

namespace integral {

/// The page for a frame that has metadata. It shows the same as replay(), over black, for the frame
/// converted to 8-bit sRGB (values above full scale are clamped). `start` is the first view; if its
/// size is 0 by 0, the page uses the size of the window. The model must be pinhole or
/// extended_pinhole. Throws std::invalid_argument if the page cannot show the frame: see
/// page_obstacle.
std::string replay_page(const Frame& frame, const View& start);

/// The reason why the page cannot show a frame through its sheet: it has no geometry, is for a
/// projection lens, or its film has subpixels other than upright stripes, rgb or bgr. Empty if the
/// page can show it.
std::string page_obstacle(const Frame& frame);

/// Two pictures to be compared on a page, or only one of them.
struct ComparedPictures {
    const Frame *reference = nullptr, *result = nullptr; ///< at least one
    std::string title;                                   ///< empty: the scene's name
    /// The greatest difference: a button moves the eye to `eye` and marks `place` on the sheet.
    struct Worst {
        Eye eye;
        Vec2 place;
        std::string words; ///< a sentence on it
    };
    std::optional<Worst> worst;
};

/// Both frames of a comparison, with the eye of the greatest difference if eyes' views were
/// compared.
ComparedPictures compared_pictures(const Frame& reference, const Frame& result,
                                   const Comparison& comparison);

/// Additions of a server to a page.
struct PageAdditions {
    std::string head, end;       ///< HTML before and after the page's own
    std::string nonce;           ///< of styles and scripts
    bool keys_for_pages = false; ///< arrow keys move the eye only while the picture has the focus
};

/// The page of a comparison: the eye's views of reference and result on either side of a line, side
/// by side, in turn, or their difference. Each frame is replayed by its own geometry; a note
/// appears if the geometries differ. Pictures with a page_obstacle are shown as they are, without
/// lenses, in pixels of one size, and the page gives the reason.
std::string comparison_page(const ComparedPictures& pictures, const PageAdditions& additions = {});

/// The same in two pieces, so that one page can hold many comparisons: the text that all
/// comparisons share, in which each mark "@NAME@" stands for a piece of a comparison, and the
/// pieces in the order of the marks.
std::string comparison_shell(const PageAdditions& additions = {});
TemplatePieces comparison_pieces(const ComparedPictures& pictures, bool keys_for_pages = false);

} // namespace integral

#endif
