// SPDX-License-Identifier: AGPL-3.0-or-later
// How much of a scene lies within the depth budget of its sheet and film: a part of the report of
// `integral sheet`.
#ifndef INTEGRAL_LIGHTFIELD_SCENE_DEPTH_REPORT_H
#define INTEGRAL_LIGHTFIELD_SCENE_DEPTH_REPORT_H

#include "integral/lightfield/depth_range.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace integral {

/// A paragraph: the scene's depths with the resolution there, how many of its surfaces are within
/// the budget, and what would bring the others there. `scene` is the name to call it by.
std::string scene_depth_text(const std::string& scene, const DepthFrame& depths);

/// The same figures, lengths in mm. Those that the scene or the sheet does not have are null.
nlohmann::ordered_json scene_depth_json(const std::string& scene, const DepthFrame& depths);

} // namespace integral

#endif
