// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/scene_files.h"

#include "integral/io/file_bytes.h"

#include <algorithm>
#include <cctype>
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

std::string from(const std::string& folder, const std::string& name) { return name[0] == '/' ? name : folder + "/" + name; }

std::string without_quotes(const std::string& text)
{
    const bool quoted = text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::string small(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

/// What begins as a scene's text or as settings; other files (pictures, fonts, meshes of data) name no files.
bool names_files(const std::string& path)
{
    const std::string extension = extension_of(path);
    return extension == "pov" || extension == "inc" || extension == "ini" || extension == "mcr" || extension == "macro" || extension == "h";
}

/// The folder that an option adds to the library path, or "".
std::string library_in(const std::string& word)
{
    if (word.size() > 2 && (word[0] == '+' || word[0] == '-') && (word[1] == 'L' || word[1] == 'l'))
        return without_quotes(word.substr(2));
    const auto equals = word.find('=');
    if (equals == std::string::npos || small(word.substr(0, equals)) != "library_path")
        return "";
    return without_quotes(word.substr(equals + 1));
}

/// An .ini file among the options, without its [SECTION].
std::string settings_in(const std::string& word)
{
    std::string name = without_quotes(word);
    name = name.substr(0, name.find('['));
    return name.empty() || name[0] == '+' || name[0] == '-' || name.find('=') != std::string::npos ? "" : name;
}

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// All that stands in quotation marks on one line of a text; in settings, also what follows =.
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
            open = line.find('"', close); // the closing mark may open the next name in a line that a comment's mark shifted
        }
        if (settings) {
            const std::string plain = trimmed(line.substr(0, line.find(';')));
            const auto equals = plain.find('=');
            names.push_back(equals == std::string::npos ? plain : without_quotes(trimmed(plain.substr(equals + 1))));
        }
    }
    return names;
}

class Search {
public:
    Search(const SceneSearch& given) : given_(given)
    {
        libraries_.push_back(given.folder);
        for (const std::string& word : given.options)
            add_library(library_in(word));
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
                std::string line = trimmed(text.substr(begin, end - begin));
                line.erase(std::remove(line.begin(), line.end(), ' '), line.end());
                add_library(library_in(line));
                begin = end + 1;
            }
        for (const std::string& next : names_in(text, settings))
            look_for(next);
    }

    void look_for(const std::string& name)
    {
        if (name.empty() || name.size() > longest_name || name.find('\0') != std::string::npos || !looked_for_.insert(name).second)
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

/// The settings that the renderer reads by itself: the first that exists.
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
    for (const std::string& word : given.options) {
        const std::string name = settings_in(word);
        if (!name.empty())
            search.look_for(name);
        for (const std::string& quoted : names_in(word, false)) // Declare=MAP="sky.png", Integral_Camera's files
            search.look_for(quoted);
    }
    search.add(scene, from(given.folder, scene));
    return search.found();
}

} // namespace integral
