// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/located_json.h"

#include "integral/io/file_bytes.h"

#include <cmath>
#include <istream>
#include <set>
#include <streambuf>

namespace integral {
namespace {

using Json = nlohmann::ordered_json;

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

std::string escaped(const std::string& key)
{
    std::string text;
    for (const char c : key)
        text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

struct Duplicate {
    std::string field;
    int line;
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
            throw Duplicate{name, counter_.line()};
        open_.back().next = escaped(name);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override
    {
        // [json.exception.parse_error.101] parse error at line 7, column 5: syntax error while ... - unexpected ...
        const std::string said = error.what();
        const auto reason = said.rfind(" - ");
        const auto colon = said.find(": ");
        trouble = error.id == 406 ? "a number is out of range" : reason != std::string::npos ? said.substr(reason + 3) : colon != std::string::npos ? said.substr(colon + 2) : said;
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
        return in.pointer + "/" + (in.is_list ? std::to_string(in.count++) : in.next);
    }
    bool note()
    {
        lines[place()] = counter_.line();
        return true;
    }
    bool open(bool is_list)
    {
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

Located::Located(std::shared_ptr<const Document> document, const Json* value, std::string pointer, std::string name)
    : document_(std::move(document)), value_(value), pointer_(std::move(pointer)), name_(std::move(name))
{
}

Located Located::parse(const std::string& path, const std::string& text)
{
    LineCounter counter(text);
    std::istream stream(&counter);
    LineNoter noter(counter);
    const auto refuse = [&](int line, const std::string& what) { throw InputError(path + ":" + std::to_string(line) + ": " + what); };
    try {
        if (!Json::sax_parse(stream, &noter))
            refuse(counter.line(), "this is no JSON: " + noter.trouble);
    } catch (const Duplicate& twice) {
        refuse(twice.line, "the field " + twice.field + " stands twice in one object");
    }
    auto document = std::make_shared<Document>();
    document->path = path;
    document->lines = std::move(noter.lines);
    document->json = Json::parse(text);
    const Json* root = &document->json;
    return Located(document, root, "", "");
}

int Located::line() const
{
    const auto found = document_->lines.find(pointer_);
    return found == document_->lines.end() ? 1 : found->second;
}

std::string Located::place() const { return document_->path + ":" + std::to_string(line()) + (name_.empty() ? "" : ": " + name_); }

void Located::refuse(const std::string& what) const { throw InputError(place() + ": " + what); }

Located Located::at(const std::string& key, const Json& value, const std::string& name) const
{
    return Located(document_, &value, pointer_ + "/" + escaped(key), name);
}

bool Located::has(const char* field) const { return value_->is_object() && value_->contains(field); }

Located Located::field(const char* name) const
{
    if (!has(name))
        refuse(std::string("the field ") + name + " is missing");
    return at(name, (*value_)[name], (name_.empty() ? "" : name_ + ".") + name);
}

void Located::allow(const std::vector<const char*>& names) const
{
    std::string legal;
    for (const char* name : names)
        legal += std::string(legal.empty() ? "" : ", ") + name;
    if (!value_->is_object())
        refuse("an object {...} is expected, of the fields " + legal);
    for (const auto& [name, field] : fields()) {
        bool known = false;
        for (const char* other : names)
            known = known || name == other;
        if (!known)
            field.refuse("there is no such field; there are: " + legal);
    }
}

std::vector<Located> Located::list() const
{
    if (!value_->is_array())
        refuse("a list [...] is expected");
    std::vector<Located> all;
    for (std::size_t i = 0; i < value_->size(); ++i)
        all.push_back(at(std::to_string(i), (*value_)[i], name_ + "[" + std::to_string(i) + "]"));
    return all;
}

std::vector<std::pair<std::string, Located>> Located::fields() const
{
    if (!value_->is_object())
        refuse("an object {...} is expected");
    std::vector<std::pair<std::string, Located>> all;
    for (const auto& item : value_->items())
        all.emplace_back(item.key(), at(item.key(), item.value(), (name_.empty() ? "" : name_ + ".") + item.key()));
    return all;
}

std::string Located::text() const
{
    if (!value_->is_string())
        refuse("a text \"...\" is expected");
    const std::string text = value_->get<std::string>();
    if (text.find('\0') != std::string::npos)
        refuse("a text without NUL is expected");
    return text;
}

std::vector<std::string> Located::texts() const
{
    std::vector<std::string> all;
    for (const Located& one : list())
        all.push_back(one.text());
    return all;
}

int Located::whole(int least, int most) const
{
    const bool right = value_->is_number_integer() && value_->get<double>() >= least && value_->get<double>() <= most;
    if (!right)
        refuse("a whole number from " + std::to_string(least) + " to " + std::to_string(most) + " is expected");
    return value_->get<int>();
}

} // namespace integral
