// SPDX-License-Identifier: AGPL-3.0-or-later
// Renders a scene by perspective cameras in the places of eyes in front of a frame's sheet.
#ifndef INTEGRAL_LABORATORY_SCENE_PICTURES_H
#define INTEGRAL_LABORATORY_SCENE_PICTURES_H

#include "integral/batch/renderer.h"
#include "integral/frame/frame.h"
#include "integral/replay/replay.h"

#include <string>
#include <vector>

namespace integral {

enum class Cameras {
    parallel,   ///< their common image plane is the sheet
    converging, ///< each turns to the sheet's middle, with an image plane of its own
};

/// `camera { perspective ... }` at an eye, for a picture of `window` mm of the sheet about its
/// middle. The geometry must have a placement.
std::string perspective_camera(const FrameMetadata& geometry, Eye eye, Vec2 window,
                               Cameras cameras);

/// A scene (.pov), with further words of povray-integral's command line for rendering it.
class ScenePictures {
public:
    /// Throws InputError where the scene cannot be read; OutputError.
    ScenePictures(const std::string& scene, std::vector<std::string> words);

    /// The scene's frame, as its own integral camera renders it, to the file `path`. Throws
    /// InputError where it cannot be rendered or its camera is not integral; Interrupted.
    Frame frame(const std::string& path, const Progress& progress) const;

    /// The scene's picture by another camera than its own: opaque, three channels of 8 bits. Throws
    /// as `frame` does.
    Image picture(const std::string& camera, int width, int height, const Progress& progress) const;

private:
    std::string scene_, text_;
    std::vector<std::string> words_;
    ScratchFolder scratch_;
};

} // namespace integral

#endif
