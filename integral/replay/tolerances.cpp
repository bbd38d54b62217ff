// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/tolerances.h"

#include "integral/lightfield/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fnmatch.h>
#include <iterator>
#include <map>
#include <stdexcept>

namespace integral {
namespace {

using Json = nlohmann::ordered_json;
using Path = std::vector<std::string>;

[[noreturn]] void refuse(int line, const std::string& what)
{
    throw std::invalid_argument("line " + std::to_string(line) + ": " + what);
}

/// A text's characters; counts the lines that it has passed.
struct CountingIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    const char* at;
    int* line;
    const char& operator*() const { return *at; }
    CountingIterator& operator++()
    {
        *line += *at == '\n';
        ++at;
        return *this;
    }
    CountingIterator operator++(int)
    {
        const CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(CountingIterator a, CountingIterator b) { return a.at == b.at; }
    friend bool operator!=(CountingIterator a, CountingIterator b) { return a.at != b.at; }
};

/// The document, and where its fields stand.
struct Document {
    Json json;
    std::map<Path, int> lines;
    std::vector<std::pair<Path, int>> repeated; ///< fields that are there already

    explicit Document(const std::string& text)
    {
        int line = 1;
        Path path;
        const auto note_keys = [&](int depth, Json::parse_event_t event, Json& parsed) {
            if (event == Json::parse_event_t::key) {
                path.resize(std::size_t(depth - 1));
                path.push_back(parsed.get<std::string>());
                if (!lines.emplace(path, line).second)
                    repeated.emplace_back(path, line);
            }
            return true;
        };
        try {
            json = Json::parse(CountingIterator{text.data(), &line}, CountingIterator{text.data() + text.size(), &line}, note_keys);
        } catch (const nlohmann::json::parse_error&) {
            refuse(line, "this is not JSON");
        } catch (const nlohmann::json::exception&) {
            refuse(line, "a number is out of range");
        }
    }

    int line_of(const Path& path) const
    {
        const auto found = lines.find(path);
        return found == lines.end() ? 1 : found->second;
    }
};

std::string quoted(const std::string& text) { return '"' + text + '"'; }

const Json& object_at(const Document& document, const Path& path, const Json& json)
{
    if (!json.is_object())
        refuse(document.line_of(path), (path.empty() ? "the document" : quoted(path.back())) + " must be an object, { ... }");
    return json;
}

std::vector<std::pair<std::size_t, std::optional<double>>> limits_at(const Document& document, const Path& path, const Json& json)
{
    std::vector<std::pair<std::size_t, std::optional<double>>> limits;
    for (const auto& [word, value] : object_at(document, path, json).items()) {
        Path field = path;
        field.push_back(word);
        const int line = document.line_of(field);
        std::size_t kind = 0;
        while (kind < limit_count && word != limit_kinds[kind].word)
            ++kind;
        if (kind == limit_count) {
            std::string words;
            for (const LimitKind& known : limit_kinds)
                words += std::string(words.empty() ? "" : ", ") + known.word;
            refuse(line, quoted(word) + " in " + quoted(path.back()) + " is unknown; there are: " + words);
        }
        const double least = limit_kinds[kind].least, greatest = limit_kinds[kind].greatest;
        if (!value.is_null() && !(value.is_number() && value.get<double>() >= least && value.get<double>() <= greatest))
            refuse(line, quoted(word) + " must be a number from " + with_digits(least, 6) + " to " + with_digits(greatest, 6) +
                             ", or null for no limit");
        limits.emplace_back(kind, value.is_null() ? std::nullopt : std::optional<double>(value.get<double>()));
    }
    return limits;
}

} // namespace

Tolerances tolerances_from_json(const std::string& text)
{
    const Document document(text);
    Tolerances tolerances;
    for (const auto& [word, value] : object_at(document, {}, document.json).items()) {
        if (word == "defaults") {
            for (const auto& [kind, limit] : limits_at(document, {word}, value))
                tolerances.defaults[kind] = limit;
        } else if (word == "files") {
            for (const auto& [pattern, limits] : object_at(document, {word}, value).items()) {
                const Path path = {word, pattern};
                tolerances.entries.push_back({pattern, document.line_of(path), limits_at(document, path, limits)});
            }
        } else {
            refuse(document.line_of({word}), quoted(word) + " is unknown; there are: defaults, files");
        }
    }
    if (!document.repeated.empty())
        refuse(document.repeated.front().second, quoted(document.repeated.front().first.back()) + " is there twice");
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
    if (std::none_of(limits.begin(), limits.end(), [](const auto& limit) { return limit.has_value(); }))
        limits[3] = 0; // max_difference
    return limits;
}

} // namespace integral
