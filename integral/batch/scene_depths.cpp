// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/scene_depths.h"

#include "integral/batch/renderer.h"
#include "integral/io/image_file.h"

#include <filesystem>

namespace integral {

DepthFrame depths_of_scene(const std::string& path, const std::vector<std::string>& options)
{
    const std::string extension = extension_of(path);
    if (extension == "exr")
        return read_depths(path);
    if (extension != "pov" && extension != "ini")
        throw InputError(path + ": it is no scene (.pov, .ini) and no depth frame (.exr); a "
                                "micro-image frame holds no depths: "
                                "Integral_Depth_Image=FILE.exr writes them beside it");
    read_file(path);
    const ScratchFolder scratch;
    const std::string depths = scratch.path("depths.exr");
    const std::string folder = std::filesystem::path(path).parent_path().string();
    std::vector<std::string> words;
    if (!folder.empty())
        words.push_back("+L\"" + folder + "\"");
    words.push_back(extension == "pov" ? "+I\"" + path + "\"" : "\"" + path + "\"");
    for (const char* word : {"-D", "+KFI1", "+KFF1"}) // one picture of an animation
        words.push_back(word);
    words.insert(words.end(), options.begin(), options.end());
    for (const std::string& word :
         {std::string("-F"), std::string("-A"), std::string("-P"), std::string("+Q1"),
          std::string("Integral_Audit=off"), "Integral_Depth_Image=\"" + depths + "\""})
        words.push_back(word);
    render(path, words, scratch);
    if (!std::filesystem::exists(depths))
        throw InputError(path + ": its camera is not integral; Integral_Camera=\"lens_sheet{...} "
                                "film{...}\" after it makes it so");
    return read_depths(depths);
}

} // namespace integral
