// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a page as a picture, pixel by pixel.
#ifndef INTEGRAL_PRINT_PAGE_RASTER_H
#define INTEGRAL_PRINT_PAGE_RASTER_H

#include "integral/frame/image.h"
#include "integral/print/page.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace integral {

/// Returns rows [first, first + count) of a picture, in its whole width.
using PictureRows = std::function<Image(int first, int count)>;

/// Makes an image of paper: white or, of inks, without ink; with WhiteInk::full, all over white
/// ink.
void fill_with_paper(Image& image, WhiteInk white);

/// The rows of a picture in memory, which must outlive the function.
PictureRows rows_in(const Image& picture);

/// Takes the next rows of page number `page`, from the top.
using TakeRows = std::function<void(std::size_t page, const Image& rows)>;

/// Draws one page, or all pages of a row of tiles together, some rows at a time: white paper, the
/// picture's own pixels, and marks and strip in black, one pixel wide and not smoothed. Marks do
/// not touch the picture. `form` is the picture's: 8 or 16 bits; three channels, or four or more
/// inks (cyan, magenta, yellow, black and, if the pages have white ink, white; 0: no ink). Of inks,
/// marks are in all of them and the strip in black. Calls `picture` for each row once, from the
/// top. Throws std::runtime_error if cairo cannot draw, and what `picture` and `take` throw.
void draw_pages(const std::vector<Page>& pages, const Image& form, const PictureRows& picture,
                const TakeRows& take);

/// Draws a page into one image. Throws as draw_pages does, and if the image needs more memory than
/// is free.
Image rasterized(const Page& page, const Image& form, const PictureRows& picture);

/// Passes the page's part of the picture to `take`, some rows at a time, from the top; mirrored if
/// the page is. Throws what `picture` and `take` throw.
void draw_part(const Page& page, const Image& form, const PictureRows& picture,
               const std::function<void(const Image& rows)>& take);

} // namespace integral

#endif
