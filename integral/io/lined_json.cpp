// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/lined_json.h"

#include <istream>
#include <set>
#include <streambuf>
#include <vector>

namespace integral {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t deepest = 100; // pointers are as long as a value lies deep

/// Hands a text out one character at a time and counts its lines: the parser's last token ends at the last character, handed
/// out, that was no space.
class LineCounter : public std::streambuf {
public:
    explicit LineCounter(const std::string& text) : text_(text) {}
    int line() const { return token_line_; }

protected:
    int_type underflow() override { return at_ < text_.size() ? traits_type::to_int_type(text_[at_]) : traits_type::eof(); }
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

/// Follows the parser and notes the line of each value.
class LineNoter : public nlohmann::json_sax<Json> {
public:
    explicit LineNoter(const LineCounter& counter) : counter_(counter) {}
    bool null() override { return note(); }
    bool boolean(bool) override { return note(); }
    bool number_integer(Json::number_integer_t) override { return note(); }
    bool number_unsigned(Json::number_unsigned_t) override { return note(); }
    bool number_float(Json::number_float_t, const Json::string_t&) override { return note(); }
    bool string(Json::string_t&) override { return note(); }
    bool binary(Json::binary_t&) override { return note(); }
    bool start_object(std::size_t) override { return open(false); }
    bool start_array(std::size_t) override { return open(true); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(Json::string_t& name) override
    {
        if (!open_.back().keys.insert(name).second)
            throw LinedJsonError(counter_.line(), "the field " + name + " stands twice in one object");
        open_.back().next = pointer_part(name);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override
    {
        // [json.exception.parse_error.101] parse error at line 7, column 5: syntax error while ... - unexpected ...
        const std::string said = error.what();
        const auto reason = said.rfind(" - ");
        const auto colon = said.find(": ");
        const std::string what = reason != std::string::npos ? said.substr(reason + 3) : colon != std::string::npos ? said.substr(colon + 2) : said;
        trouble = error.id == 406 ? "a number is out of range" : "this is no JSON: " + what;
        return false;
    }

    std::map<std::string, int> lines;
    std::string trouble;

private:
    struct Open {
        std::string pointer, next;
        bool is_list;
        int count;
        std::set<std::string> keys;
    };
    std::string place()
    {
        if (open_.empty())
            return "";
        Open& in = open_.back();
        return in.pointer + (in.is_list ? pointer_part(std::to_string(in.count++)) : in.next);
    }
    bool note()
    {
        lines[place()] = counter_.line();
        return true;
    }
    bool open(bool is_list)
    {
        if (open_.size() == deepest)
            throw LinedJsonError(counter_.line(), "this is nested more than " + std::to_string(deepest) + " deep");
        const std::string pointer = place();
        lines[pointer] = counter_.line();
        open_.push_back({pointer, "", is_list, 0, {}});
        return true;
    }
    bool close()
    {
        open_.pop_back();
        return true;
    }

    const LineCounter& counter_;
    std::vector<Open> open_;
};

} // namespace

int LinedJson::line_of(const std::string& pointer) const
{
    const auto found = lines.find(pointer);
    return found == lines.end() ? 1 : found->second;
}

std::string pointer_part(const std::string& name)
{
    std::string text = "/";
    for (const char c : name)
        text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

LinedJson parse_lined_json(const std::string& text)
{
    LineCounter counter(text);
    std::istream stream(&counter);
    LineNoter noter(counter);
    if (!Json::sax_parse(stream, &noter))
        throw LinedJsonError(counter.line(), noter.trouble);
    return {Json::parse(text), std::move(noter.lines)};
}

} // namespace integral
