// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the files on which a frame depends, as far as its scene's text names them.
#ifndef INTEGRAL_BATCH_SCENE_FILES_H
#define INTEGRAL_BATCH_SCENE_FILES_H

#include <string>
#include <vector>

namespace integral {

struct SceneFile {
    std::string name; ///< as it stands in the text
    std::string path;
};

/// Folders and options that determine where the renderer finds files and settings.
struct SceneSearch {
    std::string folder;               ///< the renderer's working folder: the scene's
    std::vector<std::string> options; ///< of its command line: +L, Library_Path= and .ini files
                                      ///< count
    std::string share; ///< its own folder of include files, scenes and settings; may not exist
};

/// Lists, each once: the scene (.pov or .ini; a path from `search.folder`); the settings files that
/// the renderer reads (POVINI, povray.ini); and every existing file whose name is in quotation
/// marks in a listed file (in settings, also after =) or in an option: includes, image maps, height
/// fields. Does not find names that a scene composes during parsing. Throws InputError if the scene
/// cannot be read.
std::vector<SceneFile> files_of_scene(const std::string& scene, const SceneSearch& search);

} // namespace integral

#endif
