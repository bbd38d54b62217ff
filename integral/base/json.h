// SPDX-License-Identifier: AGPL-3.0-or-later
// The one reader of JSON documents. It takes time and memory in proportion to a document's bytes,
// and refuses what exceeds the limits below.
#ifndef INTEGRAL_BASE_JSON_H
#define INTEGRAL_BASE_JSON_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace integral {

using Json = nlohmann::ordered_json;

constexpr std::size_t deepest_json = 64; ///< objects and lists within one another
constexpr std::size_t most_json_megabytes = 16;
constexpr std::size_t most_json_values = 1000000; ///< objects and lists count, too
constexpr std::size_t most_json_fields = 100000;  ///< of one object
constexpr std::size_t longest_json_name = 4096;   ///< bytes of a field's name, which may be a path

/// Says that a text is no JSON, exceeds a limit or has a field twice in one object. The message is
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

/// A document that knows on which line each of its values begins.
class LinedJson {
public:
    /// Reads a whole document. Throws JsonError.
    explicit LinedJson(const std::string& text);
    LinedJson(const LinedJson&) = delete; // lines_ holds addresses of values
    LinedJson& operator=(const LinedJson&) = delete;

    const Json& root() const { return root_; }
    /// The line, from 1, of root() or of a value within it.
    int line_of(const Json& value) const { return lines_.at(&value); }

private:
    Json root_;
    std::unordered_map<const Json*, int> lines_;
};

} // namespace integral

#endif
