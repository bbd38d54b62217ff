// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/located_json.h"

#include "integral/base/file_bytes.h"
#include "integral/base/message_text.h"

namespace integral {

Located::Located(std::shared_ptr<const Document> document, const Json* value, std::string name)
    : document_(std::move(document)), value_(value), name_(std::move(name))
{
}

Located Located::parse(const std::string& path, const std::string& text)
{
    try {
        const auto document = std::make_shared<const Document>(path, text);
        return Located(document, &document->json.root(), "");
    } catch (const JsonError& error) {
        throw InputError(path + ":" + std::to_string(error.line) + ": " + error.reason);
    }
}

int Located::line() const { return document_->json.line_of(*value_); }

std::string Located::place() const
{
    return document_->path + ":" + std::to_string(line()) + (name_.empty() ? "" : ": " + name_);
}

void Located::refuse(const std::string& what) const { throw InputError(place() + ": " + what); }

Located Located::at(const Json& value, const std::string& name) const
{
    return Located(document_, &value, name);
}

bool Located::has(const char* field) const
{
    return value_->is_object() && value_->contains(field);
}

Located Located::field(const char* name) const
{
    if (!has(name))
        refuse(std::string("the field ") + name + " is missing");
    return at((*value_)[name], (name_.empty() ? "" : name_ + ".") + name);
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
        all.push_back(at((*value_)[i], name_ + "[" + std::to_string(i) + "]"));
    return all;
}

std::vector<std::pair<std::string, Located>> Located::fields() const
{
    if (!value_->is_object())
        refuse("an object {...} is expected");
    std::vector<std::pair<std::string, Located>> all;
    for (const auto& item : value_->items())
        all.emplace_back(
            item.key(), at(item.value(), (name_.empty() ? "" : name_ + ".") + excerpt(item.key())));
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
    const bool right = value_->is_number_integer() && value_->get<double>() >= least &&
                       value_->get<double>() <= most;
    if (!right)
        refuse("a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
               " is expected");
    return value_->get<int>();
}

} // namespace integral
