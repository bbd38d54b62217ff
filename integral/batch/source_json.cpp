// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/source_json.h"

#include "integral/base/file_bytes.h"
#include "integral/base/message_text.h"

namespace integral {

SourceJson::SourceJson(std::shared_ptr<const Document> document, const Json* value,
                       std::string name)
    : document_(std::move(document)), value_(value), name_(std::move(name))
{
}

SourceJson SourceJson::parse(const std::string& path, const std::string& text)
{
    try {
        const auto document = std::make_shared<const Document>(path, text);
        return SourceJson(document, &document->json.root(), "");
    } catch (const JsonError& error) {
        throw InputError(path + ":" + std::to_string(error.line) + ": " + error.reason);
    }
}

int SourceJson::line() const { return document_->json.line_of(*value_); }

std::string SourceJson::place() const
{
    return document_->path + ":" + std::to_string(line()) + (name_.empty() ? "" : ": " + name_);
}

void SourceJson::throw_input(const std::string& what) const
{
    throw InputError(place() + ": " + what);
}

SourceJson SourceJson::at(const Json& value, const std::string& name) const
{
    return SourceJson(document_, &value, name);
}

bool SourceJson::has(const char* field) const
{
    return value_->is_object() && value_->contains(field);
}

SourceJson SourceJson::field(const char* name) const
{
    if (!has(name))
        throw_input(std::string("the field ") + name + " is missing");
    return at((*value_)[name], (name_.empty() ? "" : name_ + ".") + name);
}

void SourceJson::allow(const std::vector<const char*>& names) const
{
    std::string legal;
    for (const char* name : names)
        legal += std::string(legal.empty() ? "" : ", ") + name;
    if (!value_->is_object())
        throw_input("an object {...} is expected, of the fields " + legal);
    for (const auto& [name, field] : fields()) {
        bool known = false;
        for (const char* other : names)
            known = known || name == other;
        if (!known)
            field.throw_input("there is no such field; there are: " + legal);
    }
}

std::vector<SourceJson> SourceJson::list() const
{
    if (!value_->is_array())
        throw_input("a list [...] is expected");
    std::vector<SourceJson> all;
    for (std::size_t i = 0; i < value_->size(); ++i)
        all.push_back(at((*value_)[i], name_ + "[" + std::to_string(i) + "]"));
    return all;
}

std::vector<std::pair<std::string, SourceJson>> SourceJson::fields() const
{
    if (!value_->is_object())
        throw_input("an object {...} is expected");
    std::vector<std::pair<std::string, SourceJson>> all;
    for (const auto& item : value_->items())
        all.emplace_back(
            item.key(), at(item.value(), (name_.empty() ? "" : name_ + ".") + excerpt(item.key())));
    return all;
}

std::string SourceJson::text() const
{
    if (!value_->is_string())
        throw_input("a text \"...\" is expected");
    const std::string text = value_->get<std::string>();
    if (text.find('\0') != std::string::npos)
        throw_input("a text without NUL is expected");
    return text;
}

std::vector<std::string> SourceJson::texts() const
{
    std::vector<std::string> all;
    for (const SourceJson& one : list())
        all.push_back(one.text());
    return all;
}

int SourceJson::whole(int least, int most) const
{
    const bool right = value_->is_number_integer() && value_->get<double>() >= least &&
                       value_->get<double>() <= most;
    if (!right)
        throw_input("a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                    " is expected");
    return value_->get<int>();
}

} // namespace integral
