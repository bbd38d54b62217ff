// SPDX-License-Identifier: AGPL-3.0-or-later
// The depths of a scene, found before it is rendered.
#ifndef INTEGRAL_BATCH_SCENE_DEPTHS_H
#define INTEGRAL_BATCH_SCENE_DEPTHS_H

#include "integral/base/parallel.h"
#include "integral/lightfield/depth_range.h"
#include "integral/lightfield/frame.h"

#include <string>
#include <vector>

namespace integral {

struct SceneDepths {
    DepthFrame depths;
    std::optional<Frame> colours; ///< the scene's frame without lights; may be absent
};

/// Reads a depth frame (.exr); or has povray-integral trace a scene (names_scene) with one ray a
/// pixel and quality 1, and reads the frames of that. `all_pixels`: trace the frame's own pixels,
/// for a picture; otherwise a few thousand spread over it, and `colours` is empty. Either way the
/// metadata are the print's, whether or not the frame is a draft of it. `options` are further words
/// of povray-integral's command line. `progress` counts hundredths. Throws InputError.
SceneDepths depths_of_scene(const std::string& path, const std::vector<std::string>& options,
                            bool all_pixels, const Progress& progress = {});

} // namespace integral

#endif
