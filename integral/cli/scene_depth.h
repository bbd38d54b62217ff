// SPDX-License-Identifier: AGPL-3.0-or-later
// The depths of a scene against the depth budget of sheet and film: what `integral sheet --report`
// adds.
#ifndef INTEGRAL_CLI_SCENE_DEPTH_H
#define INTEGRAL_CLI_SCENE_DEPTH_H

#include "integral/lightfield/depth_range.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace integral {

/// The depth frame of a depth frame's file (.exr), or of a scene (.pov, .ini), which
/// povray-integral renders for it with `options` besides and one ray a pixel, quality 1. Throws
/// InputError.
DepthFrame depths_of_scene(const std::string& path, const std::vector<std::string>& options);

/// A paragraph of the report.
std::string scene_depth_text(const std::string& path, const DepthFrame& depths);
nlohmann::ordered_json scene_depth_json(const std::string& path, const DepthFrame& depths);

} // namespace integral

#endif
