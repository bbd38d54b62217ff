// SPDX-License-Identifier: AGPL-3.0-or-later
// The depths of a scene, found before it is rendered.
#ifndef INTEGRAL_BATCH_SCENE_DEPTHS_H
#define INTEGRAL_BATCH_SCENE_DEPTHS_H

#include "integral/lightfield/depth_range.h"

#include <string>
#include <vector>

namespace integral {

/// Reads a depth frame (.exr); or has povray-integral trace a scene (.pov, .ini) with one ray a
/// pixel and quality 1, and reads the depth frame of that. `options` are further words of
/// povray-integral's command line. Throws InputError.
DepthFrame depths_of_scene(const std::string& path, const std::vector<std::string>& options);

} // namespace integral

#endif
