// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/scene_files.h"

#include "integral/base/file_bytes.h"
#include "integral/batch/renderer_options.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sys/stat.h>

namespace integral {
namespace {

constexpr std::size_t longest_name = 1000; // characters

bool is_file(const std::string& path)
{
    struct stat status;
    return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

std::string from(const std::string& folder, const std::string& name)
{
    return name[0] == '/' ? name : folder + "/" + name;
}

/// Whether a file is a scene's text or settings, by its name. Other files (pictures, fonts, mesh
/// data) name no files.
bool names_files(const std::string& path)
{
    const std::string extension = extension_of(path);
    return extension == "pov" || extension == "inc" || extension == "ini" || extension == "mcr" ||
           extension == "macro" || extension == "h";
}

/// Whether an option is a folder of include files.
bool is_folder(const RendererOption& option)
{
    return option.kind == RendererOption::Kind::path && !option.value.empty() &&
           option.value.back() == '/';
}

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The folder that a settings line adds to the library path, or "".
std::string library_in(const std::string& line)
{
    const auto equals = line.find('=');
    const bool keyword = equals != std::string::npos; // blanks may surround the sign
    const std::string option = keyword ? trimmed(line.substr(0, equals)) + "=" +
                                             trimmed(line.substr(equals + 1))
                                       : line;
    return value_of_option({option}, "library_path", "l");
}

/// Possible names of files: every text in quotation marks within one line; in settings, also the
/// text after =.
std::vector<std::string> names_in(const std::string& text, bool settings)
{
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = text.find('\n', begin);
        end = end == std::string::npos ? text.size() : end;
        const std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        for (std::size_t open = line.find('"'); open != std::string::npos;) {
            const std::size_t close = line.find('"', open + 1);
            if (close == std::string::npos)
                break;
            names.push_back(line.substr(open + 1, close - open - 1));
            open = line.find('"', close); // the closing mark may open the next name if a comment
                                          // on the line contains a single mark
        }
        if (settings) {
            const std::string plain = trimmed(line.substr(0, line.find(';')));
            const auto equals = plain.find('=');
            names.push_back(equals == std::string::npos
                                ? plain
                                : without_quotes(trimmed(plain.substr(equals + 1))));
        }
    }
    return names;
}

class Search {
public:
    Search(const SceneSearch& given) : given_(given)
    {
        libraries_.push_back(given.folder);
        for (const std::string& word : given.options) {
            for (const std::string& library : values_of_option({word}, "library_path", "l"))
                add_library(library);
            for (const RendererOption& option : renderer_options_in(word))
                if (is_folder(option))
                    add_library(option.value);
        }
        for (const char* part : {"", "/ini", "/include", "/scenes"})
            libraries_.push_back(given.share + part);
        if (const char* more = std::getenv("POVINC"))
            add_library(more);
    }

    void add(const std::string& name, const std::string& path)
    {
        if (!seen_.insert(path).second)
            return;
        found_.push_back({name, path});
        if (!names_files(path))
            return;
        const bool settings = extension_of(path) == "ini";
        const std::string text = read_file(path);
        if (settings)
            for (std::size_t begin = 0; begin < text.size();) {
                std::size_t end = text.find('\n', begin);
                end = end == std::string::npos ? text.size() : end;
                add_library(library_in(text.substr(begin, end - begin)));
                begin = end + 1;
            }
        for (const std::string& next : names_in(text, settings))
            look_for(next);
    }

    void look_for(const std::string& name)
    {
        if (name.empty() || name.size() > longest_name || name.find('\0') != std::string::npos ||
            !looked_for_.insert(name).second)
            return;
        for (const std::string& library : libraries_)
            for (const char* extension : {"", ".inc", ".pov", ".ini", ".INC", ".POV"}) {
                const std::string path = from(library, name + extension);
                if (is_file(path))
                    return add(name, path);
            }
    }

    std::vector<SceneFile> found() { return std::move(found_); }

private:
    void add_library(const std::string& folder)
    {
        if (!folder.empty())
            libraries_.push_back(from(given_.folder, folder));
    }

    const SceneSearch& given_;
    std::vector<std::string> libraries_;
    std::set<std::string> seen_, looked_for_;
    std::vector<SceneFile> found_;
};

/// The settings file that the renderer reads by itself: the first that exists.
std::string own_settings(const SceneSearch& search)
{
    std::vector<std::string> places;
    if (const char* given = std::getenv("POVINI"))
        places.push_back(from(search.folder, given));
    places.push_back(search.folder + "/povray.ini");
    if (const char* home = std::getenv("HOME"))
        places.push_back(std::string(home) + "/.povray/3.7/povray.ini");
    places.push_back(search.share + "/povray.ini");
    for (const std::string& place : places)
        if (is_file(place))
            return place;
    return "";
}

} // namespace

std::vector<SceneFile> files_of_scene(const std::string& scene, const SceneSearch& given)
{
    Search search(given);
    const std::string settings = own_settings(given);
    if (!settings.empty())
        search.add("povray.ini", settings);
    for (const std::string& more : values_of_option(given.options, "include_ini", ""))
        search.look_for(without_section(more));
    for (const std::string& header : values_of_option(given.options, "include_header", "hi"))
        search.look_for(header);
    for (const std::string& word : given.options) {
        for (const RendererOption& option : renderer_options_in(word))
            if (option.kind == RendererOption::Kind::path)
                search.look_for(without_section(option.value));
        for (const std::string& quoted : names_in(word, false)) // Declare=MAP="sky.png",
                                                                // Integral_Camera's files
            search.look_for(quoted);
    }
    search.add(scene, from(given.folder, scene));
    return search.found();
}

} // namespace integral
