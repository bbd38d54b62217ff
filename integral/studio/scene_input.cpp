// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/scene_input.h"

#include "integral/batch/renderer_options.h"
#include "integral/batch/scene_files.h"
#include "integral/io/markup.h"

#include <algorithm>
#include <filesystem>

namespace integral {
namespace {

/// The value of an option that is a whole number > 0, such as +W; 0: not given.
int size_option(const std::vector<std::string>& words, const char* keyword, const char* letter)
{
    return std::max(0, std::atoi(value_of_option(words, keyword, letter).c_str()));
}

/// A file's name on a shell's line for povray-integral, which reads words with blanks in quotation
/// marks of its own.
std::string for_renderer(const std::string& name)
{
    return for_shell(name) == name ? name : for_shell(quoted(name));
}

/// A picture by povray-integral with these words on its command line.
Making rendered(std::vector<std::string> words)
{
    words.insert(words.begin(), renderer_program());
    return {std::move(words), {}};
}

} // namespace

SceneInput::SceneInput(const std::string& scene, const std::vector<std::string>& options)
    : scene_(scene), options_(options)
{
    scene_words(scene); // throws for a name that cannot work
}

std::string SceneInput::name() const
{
    return std::filesystem::path(without_section(scene_)).stem().string();
}

double SceneInput::aspect() const
{
    const int width = size_option(options_, "width", "w"),
              height = size_option(options_, "height", "h");
    return width > 0 && height > 0 ? double(width) / height : 4.0 / 3;
}

std::vector<std::string> SceneInput::files() const
{
    std::vector<std::string> files;
    for (const SceneFile& file :
         files_of_scene(scene_, {".", scene_words(scene_, options_), ""}))
        files.push_back(file.path);
    return files;
}

Making SceneInput::probe(const ProbeRequest& request, const ScratchFolder& scratch)
{
    return rendered(probe_words(scene_, options_, request, scratch));
}

Probe SceneInput::made_probe(const ProbeRequest& request, const ScratchFolder& scratch)
{
    return read_probe(request, scratch);
}

Making SceneInput::print(const PlacementSettings& settings, const FrameMetadata& frame,
                         std::optional<int> draft, const std::string& file)
{
    std::vector<std::string> words = words_for(settings, frame);
    if (draft)
        words.insert(words.end(), {"-A", "Integral_Audit=off",
                                   "Integral_Depth_Image=", "Integral_Error_Image="});
    else
        words.push_back("+A0.3");
    words.push_back("Integral_Draft=" + std::to_string(draft.value_or(1)));
    words.push_back("+O" + quoted(file));
    return rendered(words);
}

std::string SceneInput::words(const PlacementSettings& settings, const FrameMetadata& frame) const
{
    return words_of_settings(settings, frame);
}

SavedPlacement SceneInput::save(const PlacementSettings& settings, const FrameMetadata& frame,
                                const std::string& picture) const
{
    const std::string file = std::filesystem::path(picture).replace_extension(".ini").string(),
                      command = "povray-integral " + for_renderer(file) + " +A0.3";
    std::string text = "; " + name() + ", placed on a sheet by integral studio.\n; " + command +
                       "\n";
    if (settings.panel)
        text += "; integral lcd " + for_shell(picture) + " --panel " +
                for_shell(settings.panel->name) + " --show auto\n";
    for (const std::string& word : words_for(settings, frame))
        text += word + "\n";
    text += "+O" + quoted(picture) + "\n";
    write_file(file, text);
    return {file, command};
}

/// The words of povray-integral's command line for drafts and print, which are also lines of a
/// settings file.
std::vector<std::string> SceneInput::words_for(const PlacementSettings& settings,
                                               const FrameMetadata& frame) const
{
    std::vector<std::string> words = scene_words(scene_, options_);
    for (const char* word : {"-P", "+FN8", "Integral_Fit=off", "Integral_Quilt="})
        words.push_back(word);
    words.push_back("+W" + std::to_string(frame.film.width));
    words.push_back("+H" + std::to_string(frame.film.height));
    words.push_back("Integral_Camera=\"" + words_of_settings(settings, frame) + "\"");
    return words;
}

} // namespace integral
