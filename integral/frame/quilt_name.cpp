// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/quilt_name.h"

#include <charconv>
#include <cstdio>
#include <regex>

namespace integral {
namespace {

/// The parts of a quilt's path: everything before the end; columns, rows and aspect; the addition
/// to a copy's name; and the extension.
std::optional<std::smatch> parts_of(const std::string& path)
{
    static const std::regex form("(.*)_[qQ][sS]([0-9]{1,4})[xX]([0-9]{1,4})[aA]"
                                 "([0-9]*\\.?[0-9]+|[0-9]+\\.)([ (][^/]*)?(\\.[^./]*)");
    std::smatch parts;
    if (!std::regex_match(path, parts, form))
        return std::nullopt;
    return parts;
}

/// Parses a text that matched a number's pattern.
template <class Number> Number number_of(const std::ssub_match& text)
{
    const std::string digits = text.str();
    Number value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

} // namespace

std::optional<QuiltName> quilt_in_name(const std::string& path)
{
    const auto parts = parts_of(path);
    if (!parts)
        return std::nullopt;
    const QuiltName name{{number_of<int>((*parts)[2]), number_of<int>((*parts)[3])},
                         number_of<double>((*parts)[4])};
    return name.aspect > 0 ? std::optional(name) : std::nullopt;
}

std::string quilt_name(const std::string& path, ViewGrid grid, double aspect)
{
    if (quilt_in_name(path))
        return path;
    char end[64];
    std::snprintf(end, sizeof end, "_qs%dx%da%.4g", grid.columns, grid.rows, aspect);
    const std::size_t dot = path.find_last_of('.');
    return path.substr(0, dot) + end + path.substr(dot);
}

std::string without_grid(const std::string& path)
{
    if (!quilt_in_name(path))
        return path;
    const auto parts = *parts_of(path);
    return parts.str(1) + parts.str(5) + parts.str(6);
}

} // namespace integral
