// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/tolerances.h"

#include "integral/base/json.h"
#include "integral/base/message_text.h"
#include "integral/base/number_text.h"

#include <algorithm>
#include <fnmatch.h>
#include <stdexcept>

namespace integral {
namespace {

[[noreturn]] void refuse(int line, const std::string& what)
{
    throw std::invalid_argument("line " + std::to_string(line) + ": " + what);
}

std::string quoted(const std::string& text) { return '"' + excerpt(text) + '"'; }

/// Throws unless a value is an object; `name` is its field's.
void expect_object(int line, const std::string& name, const Json& json)
{
    if (!json.is_object())
        refuse(line, name + " must be an object, { ... }");
}

std::vector<std::pair<std::size_t, std::optional<double>>> limits_at(const LinedJson& document,
                                                                     const std::string& name,
                                                                     const Json& json)
{
    expect_object(document.line_of(json), quoted(name), json);
    std::vector<std::pair<std::size_t, std::optional<double>>> limits;
    for (const auto& [word, value] : json.items()) {
        const int line = document.line_of(value);
        std::size_t kind = 0;
        while (kind < limit_count && word != limit_kinds[kind].word)
            ++kind;
        if (kind == limit_count) {
            std::string words;
            for (const LimitKind& known : limit_kinds)
                words += std::string(words.empty() ? "" : ", ") + known.word;
            refuse(line, quoted(word) + " in " + quoted(name) + " is unknown; there are: " + words);
        }
        const double least = limit_kinds[kind].least, greatest = limit_kinds[kind].greatest;
        if (!value.is_null() &&
            !(value.is_number() && value.get<double>() >= least && value.get<double>() <= greatest))
            refuse(line, quoted(word) + " must be a number from " + with_digits(least, 6) + " to " +
                             with_digits(greatest, 6) + ", or null for no limit");
        limits.emplace_back(kind, value.is_null() ? std::nullopt
                                                  : std::optional<double>(value.get<double>()));
    }
    return limits;
}

} // namespace

Tolerances tolerances_from_json(const std::string& text)
{
    const LinedJson document(text);
    const Json& root = document.root();
    expect_object(document.line_of(root), "the document", root);
    Tolerances tolerances;
    for (const auto& [word, value] : root.items()) {
        const int line = document.line_of(value);
        if (word == "defaults") {
            for (const auto& [kind, limit] : limits_at(document, word, value))
                tolerances.defaults[kind] = limit;
        } else if (word == "files") {
            expect_object(line, quoted(word), value);
            for (const auto& [pattern, limits] : value.items())
                tolerances.entries.push_back(
                    {pattern, document.line_of(limits), limits_at(document, pattern, limits)});
        } else {
            refuse(line, quoted(word) + " is unknown; there are: defaults, files");
        }
    }
    return tolerances;
}

bool matches(const std::string& pattern, const std::string& name)
{
    return pattern == name || fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

Limits limits_for(const Tolerances& tolerances, const std::string& name)
{
    Limits limits = tolerances.defaults;
    for (const Tolerances::Entry& entry : tolerances.entries)
        if (matches(entry.pattern, name))
            for (const auto& [kind, limit] : entry.limits)
                limits[kind] = limit;
    if (std::none_of(limits.begin(), limits.end(),
                     [](const auto& limit) { return limit.has_value(); }))
        limits[3] = 0; // max_difference
    return limits;
}

} // namespace integral
