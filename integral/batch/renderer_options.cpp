// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/renderer_options.h"

#include "integral/base/file_bytes.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace integral {
std::string in_small_letters(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

namespace {

using Kind = RendererOption::Kind;

constexpr char blanks[] = " \t\n\v\f\r";
constexpr char value_ends[] = " \t\n\v\f\r;#\"'", name_ends[] = " \t\n\v\f\r;#\"'[]=";

bool is_quote(char c) { return c == '"' || c == '\''; }

bool begins(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }

/// Reads a word from beginning to end.
struct Reader {
    const std::string& word;
    std::size_t at = 0;

    bool at_end() const { return at >= word.size(); }
    bool at_quote() const { return !at_end() && is_quote(word[at]); }
    std::string until(const char* ends)
    {
        const std::size_t begin = at;
        at = std::min(word.find_first_of(ends, at), word.size());
        return word.substr(begin, at - begin);
    }
    /// Reads the text in the quotation marks that begin here, up to the word's end if the closing
    /// mark is missing.
    std::string in_quotes()
    {
        const std::size_t begin = at + 1, end = std::min(word.find(word[at], begin), word.size());
        at = std::min(end + 1, word.size());
        return word.substr(begin, end - begin);
    }
    std::string value() { return at_quote() ? in_quotes() : until(value_ends); }
};

bool is_one_of(const std::string& name, std::initializer_list<const char*> names)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr char
    of_sheet[] = "the batch chooses the sheet; the field \"camera\" of \"sheets\" has its words",
    of_size[] = "there is the field \"size\"",
    of_output[] = "the batch names the output itself; the field \"frames\" says its kind",
    of_one_frame[] = "a job is one frame", of_log[] = "the batch keeps what the renderer says",
    of_window[] = "a batch has no window",
    of_resume[] = "the batch itself continues where it was interrupted",
    of_frames[] = "a batch makes frames; integral views makes quilts of them",
    of_input[] = "there is the field \"file\"";

std::string refused_keyword(const std::string& name)
{
    const auto is = [&](std::initializer_list<const char*> names) {
        return is_one_of(name, names);
    };
    if (is({"integral_camera", "integral_sheet"}))
        return of_sheet;
    if (is({"integral_quilt"}))
        return of_frames;
    if (is({"width", "height"}))
        return of_size;
    if (is({"output_file_name", "output_file_type", "output_to_file"}))
        return of_output;
    if (is({"input_file_name"}))
        return of_input;
    if (is({"initial_frame", "final_frame", "initial_clock", "final_clock", "subset_start_frame",
            "subset_end_frame", "frame_step", "field_render", "clockless_animation",
            "real_time_raytracing"}))
        return of_one_frame;
    if (is({"all_file", "debug_file", "fatal_file", "render_file", "statistic_file", "warning_file",
            "create_ini"}))
        return of_log;
    if (is({"display", "pause_when_done"}))
        return of_window;
    return is({"continue_trace"}) ? of_resume : "";
}

std::string refused_letters(const std::string& letters, bool has_value)
{
    const auto with = [&](std::initializer_list<const char*> starts) {
        return std::any_of(starts.begin(), starts.end(),
                           [&](const char* start) { return begins(letters, start); });
    };
    if ((with({"w"}) && !with({"wt", "wl"})) || (with({"h"}) && !with({"hi", "hr"})))
        return of_size;
    if (with({"o", "f"}))
        return of_output;
    if (with({"i"}))
        return of_input;
    if (with({"ki", "kf", "kla", "sf", "ef", "uf", "stp", "rtr"}))
        return of_one_frame;
    if (with({"gi"}) || (with({"g"}) && (letters.size() > 2 || has_value)))
        return of_log;
    if (with({"d", "p"}))
        return of_window;
    return with({"c"}) ? of_resume : "";
}

} // namespace

std::vector<RendererOption> renderer_options_in(const std::string& word)
{
    std::vector<RendererOption> all;
    const std::string camera = "integral_camera";
    if (begins(in_small_letters(word.substr(0, camera.size() + 1)), camera + "="))
        return {{Kind::keyword, camera, word.substr(camera.size() + 1)}};
    Reader reader{word};
    while ((reader.at = std::min(word.find_first_not_of(blanks, reader.at), word.size())) <
           word.size()) {
        const std::size_t begin = reader.at;
        if (reader.at_quote()) {
            all.push_back({Kind::path, "", reader.in_quotes()});
            continue;
        }
        if (word[begin] == '+' || word[begin] == '-') {
            ++reader.at;
            const std::string letters = reader.until(name_ends);
            all.push_back({Kind::letters, letters, reader.at_quote() ? reader.in_quotes() : "",
                           word[begin] == '+'});
            continue;
        }
        const std::string name = reader.until(name_ends);
        if (!reader.at_end() && word[reader.at] == '=') {
            ++reader.at;
            all.push_back({Kind::keyword, name, reader.value()});
            continue;
        }
        reader.at = begin;
        const std::string path = reader.until(value_ends);
        if (path.empty()) // skips a ; or #
            ++reader.at;
        else
            all.push_back({Kind::path, "", path});
    }
    return all;
}

std::string quoted(const std::string& name)
{
    const char quote = name.find('"') == std::string::npos ? '"' : '\'';
    return quote + name + quote;
}

std::string without_quotes(const std::string& text)
{
    const bool quoted = text.size() >= 2 && (text[0] == '"' || text[0] == '\'') &&
                        text.back() == text[0];
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::string without_section(const std::string& name) { return name.substr(0, name.find('[')); }

bool names_settings(const std::string& name)
{
    return extension_of(without_section(name)) == "ini";
}

bool names_scene(const std::string& name)
{
    const std::string extension = extension_of(without_section(name));
    return extension == "pov" || extension == "ini" || extension.empty();
}

std::string unopenable_name(const std::string& name)
{
    if (std::none_of(name.begin(), name.end(), [](char c) { return (unsigned char)c > 127; }))
        return "";
    return "povray-integral finds no file whose name has letters outside of ASCII; rename it";
}

bool can_be_quoted(const std::string& name)
{
    return name.find('"') == std::string::npos || name.find('\'') == std::string::npos;
}

std::vector<std::string> values_of_option(const std::vector<std::string>& words,
                                          const std::string& keyword, const std::string& letters)
{
    std::vector<std::string> values;
    for (const std::string& word : words)
        for (const RendererOption& option : renderer_options_in(word)) {
            const std::string name = in_small_letters(option.name);
            if (option.kind == Kind::keyword && name == keyword)
                values.push_back(option.value);
            else if (option.kind == Kind::letters && !letters.empty() && begins(name, letters) &&
                     name.size() + option.value.size() > letters.size())
                values.push_back(option.name.substr(letters.size()) + option.value);
        }
    return values;
}

std::string value_of_option(const std::vector<std::string>& words, const std::string& keyword,
                            const std::string& letters)
{
    const auto values = values_of_option(words, keyword, letters);
    return values.empty() ? "" : values.back();
}

std::string refused_renderer_option(const std::string& word)
{
    if (is_one_of(word, {"--help", "-help", "-h", "-?", "--version", "-version", "--V",
                         "--benchmark", "-benchmark"}))
        return "a batch renders scenes";
    const auto options = renderer_options_in(word);
    if (options.empty())
        return "an option of povray-integral is expected";
    for (const RendererOption& option : options) {
        const std::string name = in_small_letters(option.name);
        std::string why;
        if (option.kind == Kind::keyword)
            why = refused_keyword(name);
        else if (option.kind == Kind::letters)
            why = refused_letters(name, !option.value.empty());
        else if (extension_of(option.value) == "pov")
            why = of_input;
        if (!why.empty())
            return why;
    }
    return "";
}

} // namespace integral
