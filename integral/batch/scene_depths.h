// SPDX-License-Identifier: AGPL-3.0-or-later
// Determines the depths of a scene before it is rendered.
#ifndef INTEGRAL_BATCH_SCENE_DEPTHS_H
#define INTEGRAL_BATCH_SCENE_DEPTHS_H

#include "integral/base/parallel.h"
#include "integral/frame/depth_range.h"
#include "integral/frame/frame.h"

#include <string>
#include <vector>

namespace integral {

struct SceneDepths {
    DepthFrame depths;
    std::optional<Frame> colours; ///< the scene's frame without lights; may be absent
};

/// Reads a depth frame (.exr); or has povray-integral trace a scene (names_scene) with one ray a
/// pixel and quality 1, and reads the resulting frames. `all_pixels`: traces every pixel, for a
/// picture; otherwise a few thousand spread over the frame, and `colours` is empty. The metadata
/// describe the print; but with `all_pixels`, a draft's .exr keeps its own film. `options`: further
/// words for povray-integral. `progress` counts hundredths. Throws InputError.
SceneDepths depths_of_scene(const std::string& path, const std::vector<std::string>& options,
                            bool all_pixels, const Progress& progress = {});

} // namespace integral

#endif
