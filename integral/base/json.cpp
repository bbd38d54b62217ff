// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/json.h"

#include "integral/base/message_text.h"

#include <istream>
#include <set>
#include <streambuf>
#include <vector>

template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace integral {
namespace {

/// A stream buffer that gives the parser one character at a time and counts lines. line() is the
/// line of the last character read that was not white space: the end of the parser's last token.
class LineCounter : public std::streambuf {
public:
    explicit LineCounter(const std::string& text) : text_(text) {}
    int line() const { return token_line_; }

protected:
    int_type underflow() override
    {
        return at_ < text_.size() ? traits_type::to_int_type(text_[at_]) : traits_type::eof();
    }
    int_type uflow() override
    {
        if (at_ == text_.size())
            return traits_type::eof();
        const char c = text_[at_++];
        if (c == '\n')
            ++line_;
        else if (c != ' ' && c != '\t' && c != '\r')
            token_line_ = line_;
        return traits_type::to_int_type(c);
    }

private:
    const std::string& text_;
    std::size_t at_ = 0;
    int line_ = 1, token_line_ = 1;
};

/// Builds the document from the parser's events and records the line of each value. The library's
/// own builder takes quadratic time for large objects and has no limits.
class Builder : public nlohmann::json_sax<Json> {
public:
    explicit Builder(const LineCounter& counter) : counter_(counter) {}
    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(Json::number_integer_t value) override { return add(value); }
    bool number_unsigned(Json::number_unsigned_t value) override { return add(value); }
    bool number_float(Json::number_float_t value, const Json::string_t&) override
    {
        return add(value);
    }
    bool string(Json::string_t& value) override { return add(std::move(value)); }
    bool binary(Json::binary_t&) override { return false; } // JSON has none
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(Json::string_t& name) override
    {
        Open& in = open_.back();
        if (name.size() > longest_json_name)
            refuse("the name of a field has more than " + std::to_string(longest_json_name) +
                   " bytes; shorten it");
        if (in.names.size() == most_json_fields)
            refuse("an object has more than " + std::to_string(most_json_fields) +
                   " fields; leave some out");
        if (!in.names.insert(name).second)
            refuse("the field " + excerpt(name) + " stands twice in one object");
        in.value->get_ref<Json::object_t&>().emplace_back(std::move(name), Json());
        return true;
    }
    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::detail::exception& error) override
    {
        // [json.exception.parse_error.101] parse error at line 7, column 5: syntax error while
        // parsing a value - unexpected ...
        const std::string said = error.what();
        const auto reason = said.find(" - "), colon = said.find(": ");
        const std::string what = reason != std::string::npos  ? said.substr(reason + 3)
                                 : colon != std::string::npos ? said.substr(colon + 2)
                                                              : said;
        refuse(error.id == 406 ? "a number is out of range"
                               : "this is no JSON: " + excerpt(what, 160));
    }

    Json root;
    std::vector<int> lines; ///< one for each value, in document order (a parent before its
                            ///< children)

private:
    struct Open {
        Json* value; ///< an object or a list
        std::set<std::string> names;
    };
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw JsonError(counter_.line(), what);
    }
    bool add(Json value)
    {
        place(std::move(value));
        return true;
    }
    bool open(Json value)
    {
        if (open_.size() == deepest_json)
            refuse("objects and lists are nested more than " + std::to_string(deepest_json) +
                   " deep; nest them less");
        Json& placed = place(std::move(value));
        open_.push_back({&placed, {}});
        return true;
    }
    bool close()
    {
        open_.pop_back();
        return true;
    }
    Json& place(Json value)
    {
        if (lines.size() == most_json_values)
            refuse("the document has more than " + std::to_string(most_json_values) +
                   " values; leave some out");
        lines.push_back(counter_.line());
        if (open_.empty())
            return root = std::move(value);
        Json& in = *open_.back().value;
        if (in.is_object())
            return in.get_ref<Json::object_t&>().back().second = std::move(value);
        Json::array_t& list = in.get_ref<Json::array_t&>();
        list.push_back(std::move(value));
        return list.back();
    }

    const LineCounter& counter_;
    std::vector<Open> open_;
};

/// Parses `text` and calls take(document, lines of its values).
template <class Take> void read(const std::string& text, Take take)
{
    if (text.size() > most_json_megabytes << 20)
        throw JsonError(1, "the document has more than " + std::to_string(most_json_megabytes) +
                               " MB; leave some of it out");
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw JsonError(1, "this is no JSON: it is empty");
    LineCounter counter(text);
    std::istream stream(&counter);
    Builder builder(counter);
    Json::sax_parse(stream, &builder);
    take(std::move(builder.root), builder.lines);
}

/// Records the line of a value and of all values inside it. `line` points to the value's entry in
/// Builder::lines; returns a pointer to the entry after the last one used.
const int* note(const Json& value, const int* line, std::unordered_map<const Json*, int>& lines)
{
    lines.emplace(&value, *line++);
    if (value.is_structured())
        for (const Json& inner : value)
            line = note(inner, line, lines);
    return line;
}

} // namespace

Json parse_json(const std::string& text)
{
    Json document;
    read(text, [&](Json root, const std::vector<int>&) { document = std::move(root); });
    return document;
}

LinedJson::LinedJson(const std::string& text)
{
    read(text, [&](Json root, const std::vector<int>& lines) {
        root_ = std::move(root);
        lines_.reserve(lines.size());
        note(root_, lines.data(), lines_);
    });
}

} // namespace integral
