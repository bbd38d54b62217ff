// SPDX-License-Identifier: AGPL-3.0-or-later
// The fields of JSON documents, read with messages that name them. For the files that read and
// write JSON alone.
//
// All of these throw std::invalid_argument, "FIELD what is wrong with it", where FIELD is the path
// from the document.
#ifndef INTEGRAL_BASE_JSON_FIELDS_H
#define INTEGRAL_BASE_JSON_FIELDS_H

#include "integral/base/json.h"

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace integral {

constexpr double largest_figure = 1e100; // of what is only handed on; no few of them overflow

[[noreturn]] void refuse(const std::string& field, const std::string& what);

/// An object of a document, with the path by which messages name it.
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

/// Refuses fields of other names than these.
void refuse_others(const JsonObject& object, std::initializer_list<const char*> legal);

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
        refuse(object.path_of(field), "must be a whole number");
    return static_cast<Whole>(number_at(object, field, double(least), double(greatest)));
}

/// A document's text: one line per object of its own, short enough for a chunk and plain enough to
/// read.
std::string text_of(const Json& document);

} // namespace integral

#endif
