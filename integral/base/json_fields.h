// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads fields of JSON documents, with error messages that name the field. To be included only by
// files that read or write JSON.
//
// On failure, every function here throws std::invalid_argument with the message "FIELD what is
// wrong with it", where FIELD is the field's path from the document's root.
#ifndef INTEGRAL_BASE_JSON_FIELDS_H
#define INTEGRAL_BASE_JSON_FIELDS_H

#include "integral/base/json.h"

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace integral {

/// Limit for numbers that are stored but not computed with; products of a few such numbers do not
/// overflow a double.
constexpr double largest_figure = 1e100;

[[noreturn]] void throw_field_error(const std::string& field, const std::string& what);

/// An object inside a document, and its path from the root, for messages.
struct JsonObject {
    const Json& json;
    std::string path;

    std::string path_of(const char* field) const
    {
        return path.empty() ? field : path + "." + field;
    }
    bool has(const char* field) const { return json.contains(field); }
    const Json& at(const char* field) const;
};

JsonObject object_at(const JsonObject& parent, const char* field);

/// Throws if the object has a field that is not in `legal`.
void throw_on_unknown_fields(const JsonObject& object, std::initializer_list<const char*> legal);

/// A number in [least, greatest].
double number_in(const Json& json, const std::string& path, double least, double greatest);
double number_at(const JsonObject& object, const char* field, double least, double greatest);

/// A list of `count` numbers in [least, greatest].
std::vector<double> numbers_in(const Json& json, const std::string& path, std::size_t count,
                               double least, double greatest);
std::vector<double> numbers_at(const JsonObject& object, const char* field, std::size_t count,
                               double least, double greatest);

std::string string_at(const JsonObject& object, const char* field);

/// A whole number in [least, greatest].
template <class Whole>
Whole whole_at(const JsonObject& object, const char* field, Whole least, Whole greatest)
{
    if (!object.at(field).is_number_integer())
        throw_field_error(object.path_of(field), "must be a whole number");
    return static_cast<Whole>(number_at(object, field, double(least), double(greatest)));
}

/// The text of a document, one line for each top-level field: compact enough for a PNG chunk, and
/// still readable.
std::string text_of(const Json& document);

} // namespace integral

#endif
