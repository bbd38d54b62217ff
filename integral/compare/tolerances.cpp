// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/tolerances.h"

#include "integral/base/json.h"
#include "integral/base/message_text.h"
#include "integral/base/number_text.h"

#include <algorithm>
#include <fnmatch.h>
#include <iterator>
#include <stdexcept>

namespace integral {
namespace {

[[noreturn]] void throw_input(int line, const std::string& what)
{
    throw std::invalid_argument("line " + std::to_string(line) + ": " + what);
}

std::string quoted(const std::string& text) { return '"' + excerpt(text) + '"'; }

/// Throws unless a value is an object; `name` is its field's.
void expect_object(int line, const std::string& name, const Json& json)
{
    if (!json.is_object())
        throw_input(line, name + " must be an object, { ... }");
}

/// The words that are no limits.
const char* const other_words[] = {
    "channel_tolerance", "ppd", "ignore", "weights", "mask", "seen", "eyes"};

/// Reads a limit: null, or a number in the kind's range; a share also as "0.1%".
std::optional<double> limit_at(int line, const std::string& word, const LimitKind& kind,
                               const Json& value)
{
    if (value.is_null())
        return std::nullopt;
    std::optional<double> limit;
    if (value.is_number())
        limit = value.get<double>();
    else if (kind.is_share && value.is_string())
        limit = share_of(value.get<std::string>());
    if (!limit || !(*limit >= kind.least && *limit <= kind.greatest))
        throw_input(line, quoted(word) + " must be a number from " + with_digits(kind.least, 6) +
                              " to " + with_digits(kind.greatest, 6) +
                              (kind.is_share ? ", or a share such as \"0.1%\"" : "") +
                              ", or null for no limit");
    return limit;
}

double number_at(int line, const std::string& word, const Json& value, double least,
                 double greatest)
{
    if (!(value.is_number() && value.get<double>() >= least && value.get<double>() <= greatest))
        throw_input(line, quoted(word) + " must be a number from " + with_digits(least, 6) +
                              " to " + with_digits(greatest, 6));
    return value.get<double>();
}

Region region_at(int line, const std::string& words, double weight)
{
    try {
        return region_of(words, weight);
    } catch (const std::invalid_argument& error) {
        throw_input(line, error.what());
    }
}

/// Reads a word that is no limit.
void read_other(ToleranceChanges& changes, const LinedJson& document, const std::string& word,
                const Json& value)
{
    const int line = document.line_of(value);
    if (word == "channel_tolerance") {
        changes.channel_tolerance = number_at(line, word, value, 0, 1e6);
    } else if (word == "ppd") {
        changes.ppd = number_at(line, word, value, least_ppd, greatest_ppd);
    } else if (word == "seen") {
        if (!value.is_boolean())
            throw_input(line, "\"seen\" must be true or false");
        changes.seen = value.get<bool>();
    } else if (word == "eyes") {
        std::vector<std::string> words;
        for (const Json& eye : value.is_array() ? value : Json::array({value}))
            words.push_back(eye.is_string() ? eye.get<std::string>() : eye.dump());
        try {
            changes.eyes = seen_eyes_of(words);
        } catch (const std::invalid_argument& error) {
            throw_input(line, error.what());
        }
    } else if (word == "mask") {
        if (!value.is_string() || value.get<std::string>().empty())
            throw_input(line, "\"mask\" must be the path of a picture");
        changes.mask = value.get<std::string>();
    } else if (word == "ignore") {
        if (!value.is_array())
            throw_input(line, "\"ignore\" must be a list of regions, [\"X,Y,WxH\", ...]");
        for (const Json& region : value) {
            if (!region.is_string())
                throw_input(document.line_of(region), "a region in \"ignore\" must be text, "
                                                      "\"X,Y,WxH\" or \"lens:COLUMN,ROW\"");
            changes.regions.push_back(
                region_at(document.line_of(region), region.get<std::string>(), 0));
        }
    } else {
        expect_object(line, "\"weights\"", value);
        for (const auto& [region, weight] : value.items())
            changes.regions.push_back(
                region_at(document.line_of(weight), region,
                          number_at(document.line_of(weight), region, weight, 0, 1e6)));
    }
}

/// Reads an object of limits and other words into `changes`.
void read_changes(ToleranceChanges& changes, const LinedJson& document, const std::string& name,
                  const Json& json)
{
    expect_object(document.line_of(json), quoted(name), json);
    for (const auto& [word, value] : json.items()) {
        const int line = document.line_of(value);
        std::size_t kind = 0;
        while (kind < limit_count && word != limit_kinds[kind].word)
            ++kind;
        if (kind < limit_count) {
            changes.limits.emplace_back(kind, limit_at(line, word, limit_kinds[kind], value));
            continue;
        }
        if (std::find(std::begin(other_words), std::end(other_words), word) ==
            std::end(other_words)) {
            std::string words;
            for (const LimitKind& known : limit_kinds)
                words += std::string(words.empty() ? "" : ", ") + known.word;
            for (const char* known : other_words)
                words += std::string(", ") + known;
            throw_input(line,
                        quoted(word) + " in " + quoted(name) + " is unknown; there are: " + words);
        }
        read_other(changes, document, word, value);
    }
}

void change(const ToleranceChanges& changes, Limits& limits)
{
    for (const auto& [kind, limit] : changes.limits)
        limits[kind] = limit;
}

void change(const ToleranceChanges& changes, ComparisonRules& rules)
{
    if (changes.channel_tolerance)
        rules.channel_tolerance = *changes.channel_tolerance;
    if (changes.ppd)
        rules.ppd = changes.ppd;
    if (changes.mask)
        rules.mask = *changes.mask;
    if (changes.eyes)
        rules.seen = *changes.eyes;
    else if (changes.seen == true && !rules.seen)
        rules.seen.emplace();
    if (changes.seen == false)
        rules.seen.reset();
    rules.regions.insert(rules.regions.end(), changes.regions.begin(), changes.regions.end());
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
            ToleranceChanges changes;
            read_changes(changes, document, word, value);
            change(changes, tolerances.defaults);
            change(changes, tolerances.default_rules);
        } else if (word == "files") {
            expect_object(line, quoted(word), value);
            for (const auto& [pattern, changes] : value.items()) {
                Tolerances::Entry entry;
                entry.pattern = pattern;
                entry.line = document.line_of(changes);
                read_changes(entry, document, pattern, changes);
                tolerances.entries.push_back(entry);
            }
        } else {
            throw_input(line, quoted(word) + " is unknown; there are: defaults, files");
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
            change(entry, limits);
    if (std::none_of(limits.begin(), limits.end(),
                     [](const auto& limit) { return limit.has_value(); }))
        limits[3] = 0; // max_difference
    return limits;
}

ComparisonRules rules_for(const Tolerances& tolerances, const std::string& name)
{
    ComparisonRules rules = tolerances.default_rules;
    for (const Tolerances::Entry& entry : tolerances.entries)
        if (matches(entry.pattern, name))
            change(entry, rules);
    rules.flip |= limits_for(tolerances, name)[flip_limit].has_value();
    return rules;
}

} // namespace integral
