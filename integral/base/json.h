// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads JSON documents. Time and memory are proportional to a document's size; documents that
// exceed the limits below are refused.
#ifndef INTEGRAL_BASE_JSON_H
#define INTEGRAL_BASE_JSON_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_map>

// Compiled once, in json.cpp, for programs that are not optimized: half of what a file with JSON
// takes to compile.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace integral {

using Json = nlohmann::ordered_json;

constexpr std::size_t deepest_json = 64; ///< nesting of objects and lists
constexpr std::size_t most_json_megabytes = 16;
constexpr std::size_t most_json_values = 1000000; ///< including objects and lists
constexpr std::size_t most_json_fields = 100000;  ///< in one object
constexpr std::size_t longest_json_name = 4096;   ///< bytes in a field's name, which may be a path

/// Thrown if a text is not JSON, exceeds a limit or has a field twice in one object. The message is
/// "line LINE: REASON".
struct JsonError : std::invalid_argument {
    JsonError(int where, const std::string& why)
        : std::invalid_argument("line " + std::to_string(where) + ": " + why),
          line(where),
          reason(why)
    {
    }
    int line; ///< from 1
    std::string reason;
};

/// Reads a whole document. Throws JsonError.
Json parse_json(const std::string& text);

/// A parsed document together with the line number of each value, for error messages.
class LinedJson {
public:
    /// Reads a whole document. Throws JsonError.
    explicit LinedJson(const std::string& text);
    LinedJson(const LinedJson&) = delete; // lines_ holds addresses of values
    LinedJson& operator=(const LinedJson&) = delete;

    const Json& root() const { return root_; }
    /// The line number, from 1, of root() or of a value inside it.
    int line_of(const Json& value) const { return lines_.at(&value); }

private:
    Json root_;
    std::unordered_map<const Json*, int> lines_;
};

} // namespace integral

#endif
