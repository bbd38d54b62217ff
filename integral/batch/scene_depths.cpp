// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/scene_depths.h"

#include "integral/batch/renderer.h"
#include "integral/io/image_file.h"

#include <filesystem>

namespace integral {

SceneDepths depths_of_scene(const std::string& path, const std::vector<std::string>& options,
                            const Progress& progress)
{
    const std::string extension = extension_of(path);
    if (extension == "exr")
        return {read_depths(path), std::nullopt};
    if (extension != "pov" && extension != "ini")
        throw InputError(path + ": it is no scene (.pov, .ini) and no depth frame (.exr); a "
                                "micro-image frame holds no depths: "
                                "Integral_Depth_Image=FILE.exr writes them beside it");
    const ScratchFolder scratch;
    const std::string depths = scratch.path("depths.exr"), colours = scratch.path("colours.png");
    std::vector<std::string> words = scene_words(path);
    words.insert(words.end(), options.begin(), options.end());
    for (const std::string& word :
         {"+FN8 +O\"" + colours + "\"", std::string("-A"), std::string("-P"), std::string("+Q1"),
          std::string("Integral_Audit=off"), "Integral_Depth_Image=\"" + depths + "\""})
        words.push_back(word);
    render(path, words, scratch, progress);
    if (!std::filesystem::exists(depths))
        throw InputError(path + ": its camera is not integral; Integral_Camera=\"lens_sheet{...} "
                                "film{...}\" after it makes it so");
    SceneDepths read{read_depths(depths), std::nullopt};
    if (std::filesystem::exists(colours))
        read.colours = read_frame(colours);
    return read;
}

} // namespace integral
