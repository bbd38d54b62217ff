// SPDX-License-Identifier: AGPL-3.0-or-later
// JSON that a person writes: every value with the line on which it stands.
#ifndef INTEGRAL_IO_LINED_JSON_H
#define INTEGRAL_IO_LINED_JSON_H

#include <nlohmann/json.hpp>

#include <map>
#include <stdexcept>
#include <string>

namespace integral {

struct LinedJson {
    nlohmann::ordered_json json;
    std::map<std::string, int> lines; ///< from 1, by the value's JSON pointer: "/scenes/0/file"

    int line_of(const std::string& pointer) const; ///< 1 for one that is not there
};

/// What is wrong with a text that is no JSON, that has a field twice in one object or is nested without end, and on which line.
struct LinedJsonError : std::runtime_error {
    LinedJsonError(int where, const std::string& what) : std::runtime_error(what), line(where) {}
    int line;
};

/// Reads a whole document. Throws LinedJsonError.
LinedJson parse_lined_json(const std::string& text);

/// A field's or a list's member's part of a JSON pointer: "/file"; a / or ~ in the name is escaped.
std::string pointer_part(const std::string& name);

} // namespace integral

#endif
