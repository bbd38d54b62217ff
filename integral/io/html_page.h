// SPDX-License-Identifier: AGPL-3.0-or-later
// Pages of tables and small pictures: one HTML file each, without scripts and without anything from
// elsewhere. Text goes into them through markup_text (integral/io/markup.h).
#ifndef INTEGRAL_IO_HTML_PAGE_H
#define INTEGRAL_IO_HTML_PAGE_H

#include "integral/lightfield/image.h"

#include <string>

namespace integral {

/// What becomes of the pixels that fall into one: their mean, in linear light, or of each channel
/// the greatest value, which lets no single pixel of a difference picture get lost.
enum class Scaling { average, greatest };

/// A picture over black at 8 bits and sRGB, three channels, its longer side `longest` pixels at
/// most (>= 1): smaller pictures keep their size; of larger ones each pixel goes into one of the
/// result.
Image scaled_down(const Image& picture, int longest, Scaling scaling = Scaling::average);

/// A picture of 8 bits as the value of an <img>'s src: a PNG in a data URI.
std::string picture_uri(const Image& picture);

/// <img> of a picture scaled down, with its width and height and a text (plain) that says what it
/// shows.
std::string picture_element(const Image& picture, int longest, const std::string& text,
                            Scaling scaling = Scaling::average);

/// A path relative to the page as the value of an <a>'s href: its bytes percent-encoded but for the
/// plain ones.
std::string link_to(const std::string& path);

/// A whole page. `title` is plain text; `style` is CSS after the page's own; `body` is HTML. The
/// page's own CSS lays out text in light and dark as the reader prefers (--ground, --panel, --line,
/// --text, --quiet, --good, --bad, --mark) and tables; a table of class "cards" becomes cards on
/// narrow windows: each <td data-label="..."> on a line of its own, after its label.
std::string html_page(const std::string& title, const std::string& style, const std::string& body);

} // namespace integral

#endif
