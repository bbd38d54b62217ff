// SPDX-License-Identifier: AGPL-3.0-or-later
// Escapes text for HTML, XML, SVG and shells, and encodes bytes.
#ifndef INTEGRAL_IO_MARKUP_H
#define INTEGRAL_IO_MARKUP_H

#include <string>
#include <utility>
#include <vector>

namespace integral {

/// Names and texts of the marks in a template.
using TemplatePieces = std::vector<std::pair<std::string, std::string>>;

/// The template with each mark "@NAME@" replaced by its piece. The marks must occur in the order of
/// `pieces`. Throws std::logic_error if one is missing.
std::string filled_template(const std::string& page, const TemplatePieces& pieces);

/// A text escaped for HTML and XML, between tags or in a quoted attribute: & < > " ', tabs and line
/// ends become character references. Bytes that are not UTF-8 and characters that XML 1.0 forbids
/// become U+FFFD.
std::string markup_text(const std::string& text);

/// JSON for use inside HTML: `<`, which occurs only in strings, is escaped, so that an HTML parser
/// finds no markup.
std::string json_within_html(const std::string& json);

/// A text as one word for a shell: in quotation marks unless all its characters are plain.
std::string for_shell(const std::string& text);

/// Bytes in base64 (RFC 4648), without line ends.
std::string base64(const std::string& bytes);

} // namespace integral

#endif
