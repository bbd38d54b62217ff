// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes HTML report pages of tables and small pictures. Each page is one file without links to
// other hosts, and without scripts unless one is given; only moving pictures may be separate files.
// Escape plain text with markup_text (integral/io/markup.h).
#ifndef INTEGRAL_IO_HTML_PAGE_H
#define INTEGRAL_IO_HTML_PAGE_H

#include "integral/frame/image.h"

#include <string>

namespace integral {

/// Reduction of several pixels to one: their mean in linear light, or the greatest value of each
/// channel, which keeps single pixels of a difference picture visible.
enum class Scaling { average, greatest };

/// The picture over black, as 8-bit sRGB with three channels, reduced so that its longer side has
/// at most `longest` >= 1 pixels. Smaller pictures keep their size.
Image scaled_down(const Image& picture, int longest, Scaling scaling = Scaling::average);

/// An 8-bit picture as a data URI of a PNG, for the src of an <img>.
std::string picture_uri(const Image& picture);

/// An <img> element of the picture scaled down, with width, height and `text` (plain text) as its
/// alternative text.
std::string picture_element(const Image& picture, int longest, const std::string& text,
                            Scaling scaling = Scaling::average);

/// A path relative to the page, percent-encoded for the href of an <a>.
std::string link_to(const std::string& path);

/// A script at the end of a page.
struct PageScript {
    std::string text;  ///< empty: the page has no script, and its policy forbids scripts
    std::string nonce; ///< of style and script, if a server's policy requires one
};

/// A whole page. `title` is plain text, `body` is HTML, and `style` is CSS that follows the page's
/// own. The page's own CSS formats text and tables and defines the colours --ground, --panel,
/// --line, --text, --quiet, --good, --bad and --mark for the reader's light or dark preference. In
/// narrow windows the rows of a table of class "cards" are shown as cards, with each <td
/// data-label="..."> on its own line after its label.
std::string html_page(const std::string& title, const std::string& style, const std::string& body,
                      const PageScript& script = {});

} // namespace integral

#endif
