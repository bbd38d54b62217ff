// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/manifest_fields.h"

#include "integral/base/message_text.h"
#include "integral/batch/renderer_options.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace integral {
namespace {

constexpr int largest_side = 1000000;     // pixels
constexpr std::size_t most_listed = 20;   // names in a message
constexpr std::size_t longest_name = 100; // characters
constexpr char letters_digits_underscore[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                             "0123456789_";

bool is_identifier(const std::string& name)
{
    return !name.empty() &&
           name.find_first_not_of(letters_digits_underscore) == std::string::npos &&
           !(name[0] >= '0' && name[0] <= '9');
}

/// Rejects an option of print, lcd or replay that the batch sets itself or cannot use.
void check_command_option(const SourceJson& field, const std::string& word,
                          const std::string& own_field)
{
    const std::string name = word.substr(0, word.find('='));
    const bool short_output = word.size() >= 2 && word[0] == '-' && word[1] == 'o';
    if (word.empty())
        field.throw_input("an option of the command is expected");
    if (name == "--output" || short_output || name == "--html")
        field.throw_input(
            excerpt(word) +
            ": the batch names the output itself; the field \"format\" says its kind");
    for (const char* other : {"--printer", "--show", "--play", "--help", "--chart", "--even"})
        if (name == other)
            field.throw_input(excerpt(word) +
                              ": a batch writes files, which are printed and shown afterwards");
    if (name == "--" + own_field)
        field.throw_input(excerpt(word) + ": there is a field for it");
    if (word.rfind("--", 0) == 0 && name.find(' ') != std::string::npos)
        field.throw_input(excerpt(word) +
                          ": each word stands by itself, as in \"--eye\", \"-30,0,120\"");
}

} // namespace

std::string list_of(const Names& names)
{
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most_listed); ++i)
        text += (text.empty() ? "" : ", ") + names[i];
    return text.empty() ? "none" : text + (names.size() > most_listed ? ", ..." : "");
}

std::string name_in(const SourceJson& field)
{
    const std::string name = field.text();
    const std::string legal = std::string(letters_digits_underscore) + "-";
    const bool right = !name.empty() && name.size() <= longest_name && name[0] != '-' &&
                       name.find_first_not_of(legal) == std::string::npos;
    if (!right)
        field.throw_input("a name of letters, digits, _ and - is expected, at most 100 of them");
    return name;
}

FrameSize size_in(const SourceJson& object)
{
    if (!object.has("size"))
        return {};
    const SourceJson field = object.field("size");
    const auto sides = field.list();
    if (sides.size() != 2)
        field.throw_input("[WIDTH, HEIGHT] in pixels is expected");
    return {sides[0].whole(1, largest_side), sides[1].whole(1, largest_side)};
}

std::string readable_file(const SourceJson& field, const std::string& folder)
{
    const std::string name = field.text(), path = path_in(folder, name);
    struct stat status;
    if (name.empty())
        field.throw_input("the name of a file is expected");
    if (stat(path.c_str(), &status) != 0 ||
        (S_ISREG(status.st_mode) && access(path.c_str(), R_OK) != 0))
        field.throw_input(excerpt(name) + " cannot be read: " + std::strerror(errno) +
                          "; names start at the manifest's folder");
    if (!S_ISREG(status.st_mode))
        field.throw_input(excerpt(name) + " is no file");
    return name;
}

void check_quotable(const SourceJson& field, const std::string& text)
{
    if (!can_be_quoted(text))
        field.throw_input("both kinds of quotation marks in it cannot be passed on");
}

void check_renderer_name(const SourceJson& field, const std::string& name)
{
    check_quotable(field, name);
    const std::string why = unopenable_name(name);
    if (!why.empty())
        field.throw_input(excerpt(name) + ": " + why);
}

Names renderer_options(const SourceJson& object)
{
    Names all;
    if (!object.has("options"))
        return all;
    for (const SourceJson& one : object.field("options").list()) {
        all.push_back(one.text());
        const std::string why = refused_renderer_option(all.back());
        if (!why.empty())
            one.throw_input(excerpt(all.back()) + ": " + why);
    }
    return all;
}

Names command_options(const SourceJson& object, const std::string& own_field)
{
    Names all;
    if (!object.has("options"))
        return all;
    for (const SourceJson& one : object.field("options").list()) {
        all.push_back(one.text());
        check_command_option(one, all.back(), own_field);
    }
    return all;
}

std::vector<std::pair<std::string, std::string>> declarations(const SourceJson& object)
{
    std::vector<std::pair<std::string, std::string>> all;
    if (!object.has("declare"))
        return all;
    for (const auto& [name, value] : object.field("declare").fields()) {
        if (!is_identifier(name) || !value.json().is_number())
            value.throw_input("a scene's identifier and a number are expected");
        all.emplace_back(name, value.json().dump());
    }
    return all;
}

std::string format_in(const SourceJson& object, const Names& formats)
{
    if (!object.has("format"))
        return formats[0];
    const std::string format = object.field("format").text();
    if (std::find(formats.begin(), formats.end(), format) == formats.end())
        object.field("format").throw_input(list_of(formats) + ": one of these is expected");
    return format;
}

} // namespace integral
