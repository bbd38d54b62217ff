// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/json_fields.h"

#include "integral/base/message_text.h"
#include "integral/base/number_text.h"

#include <algorithm>
#include <stdexcept>

namespace integral {

void throw_field_error(const std::string& field, const std::string& what)
{
    throw std::invalid_argument(field + " " + what);
}

const Json& JsonObject::at(const char* field) const
{
    if (!has(field))
        throw_field_error(path_of(field), "is missing");
    return json.at(field);
}

JsonObject object_at(const JsonObject& parent, const char* field)
{
    const Json& json = parent.at(field);
    if (!json.is_object())
        throw_field_error(parent.path_of(field), "must be an object");
    return {json, parent.path_of(field)};
}

void throw_on_unknown_fields(const JsonObject& object, std::initializer_list<const char*> legal)
{
    for (const auto& field : object.json.items()) {
        if (std::find(legal.begin(), legal.end(), field.key()) != legal.end())
            continue;
        std::string names;
        for (const char* const name : legal)
            names += (names.empty()                ? ""
                      : name == *(legal.end() - 1) ? " and "
                                                   : ", ") +
                     std::string(name);
        throw_field_error(object.path_of(excerpt(field.key()).c_str()),
                          "is not a field of it: those are " + names);
    }
}

double number_in(const Json& json, const std::string& path, double least, double greatest)
{
    if (!json.is_number())
        throw_field_error(path, "must be a number");
    const double value = json.get<double>();
    if (!(value >= least && value <= greatest))
        throw_field_error(path, "is " + with_digits(value, 6) + ", and must be within " +
                                    with_digits(least, 6) + " and " + with_digits(greatest, 6));
    return value;
}

double number_at(const JsonObject& object, const char* field, double least, double greatest)
{
    return number_in(object.at(field), object.path_of(field), least, greatest);
}

std::vector<double> numbers_in(const Json& json, const std::string& path, std::size_t count,
                               double least, double greatest)
{
    if (!json.is_array() || json.size() != count)
        throw_field_error(path, "must be a list of " + std::to_string(count) + " numbers");
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(number_in(json[i], path + "[" + std::to_string(i) + "]", least, greatest));
    return values;
}

std::vector<double> numbers_at(const JsonObject& object, const char* field, std::size_t count,
                               double least, double greatest)
{
    return numbers_in(object.at(field), object.path_of(field), count, least, greatest);
}

std::string string_at(const JsonObject& object, const char* field)
{
    if (!object.at(field).is_string())
        throw_field_error(object.path_of(field), "must be a string");
    return object.at(field).get<std::string>();
}

std::string text_of(const Json& document)
{
    std::string text;
    for (const auto& field : document.items())
        text += (text.empty() ? "{\"" : ",\n \"") + field.key() +
                "\": " + field.value().dump(-1, ' ', false, Json::error_handler_t::replace);
    return text + "}\n";
}

} // namespace integral
