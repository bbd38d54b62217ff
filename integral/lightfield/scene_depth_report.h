// SPDX-License-Identifier: AGPL-3.0-or-later
// How much of a scene lies within the depth budget of its sheet and film, and what would help: a
// part of the report of `integral sheet`.
#ifndef INTEGRAL_LIGHTFIELD_SCENE_DEPTH_REPORT_H
#define INTEGRAL_LIGHTFIELD_SCENE_DEPTH_REPORT_H

#include "integral/lightfield/depth_range.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace integral {

/// The verdict, three lines after its heading: which part of the picture is sharp, what would make
/// more of it sharp and how much, and whether the backdrop is closed. Where compressing depth
/// helps, the scene words that do it follow. `scene` is the name to call it by.
std::string scene_verdict_text(const std::string& scene, const DepthFrame& depths);

/// A table of the scene's depths with the resolution there.
std::string scene_depth_text(const DepthFrame& depths);

/// The same figures, lengths in mm. Those that the scene or the sheet does not have are null.
nlohmann::ordered_json scene_depth_json(const std::string& scene, const DepthFrame& depths);

} // namespace integral

#endif
