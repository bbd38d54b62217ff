// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the files that a frame depends on, as far as its scene's text names them.
#ifndef INTEGRAL_BATCH_SCENE_FILES_H
#define INTEGRAL_BATCH_SCENE_FILES_H

#include <string>
#include <vector>

namespace integral {

struct SceneFile {
    std::string name; ///< as the text that names it has it
    std::string path;
};

/// Where the renderer looks for files and settings.
struct SceneSearch {
    std::string folder;               ///< in which it runs: the scene's
    std::vector<std::string> options; ///< of its command line: +L, Library_Path= and .ini files
                                      ///< count
    std::string share; ///< its own folder of include files, scenes and settings; may not exist
};

/// The scene (.pov or .ini; a path from `search.folder`), the settings files that the renderer
/// reads (POVINI, povray.ini), and each file that exists under a name that stands in quotation
/// marks in one of them (in settings, after = as well): includes, image maps, height fields;
/// includes' own, and so on. Names that a scene puts together while it is parsed are not found.
/// Each file once. Throws InputError where the scene cannot be read.
std::vector<SceneFile> files_of_scene(const std::string& scene, const SceneSearch& search);

} // namespace integral

#endif
