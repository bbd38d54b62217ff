// SPDX-License-Identifier: AGPL-3.0-or-later
// Aligns texts in the columns of a table.
#ifndef INTEGRAL_BASE_TEXT_COLUMNS_H
#define INTEGRAL_BASE_TEXT_COLUMNS_H

#include <string>

namespace integral {

/// A text with blanks before it, as many bytes long as `width`; a longer text is unchanged.
inline std::string right_aligned(const std::string& text, std::size_t width)
{
    return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

} // namespace integral

#endif
