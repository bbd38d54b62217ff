// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports the share of a scene within the depth budget of its sheet and film, and changes that
// help: a part of the report of `integral sheet`.
#ifndef INTEGRAL_SHEET_SCENE_DEPTH_REPORT_H
#define INTEGRAL_SHEET_SCENE_DEPTH_REPORT_H

#include "integral/frame/depth_range.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace integral {

/// The verdict: for each fit, its scene words and the shares of the picture; the present shares;
/// the depths; a finer film that helps; and the share of the picture that shows no surface. `scene`
/// is the name in the heading.
std::string scene_verdict_text(const std::string& scene, const DepthFrame& depths);

/// A table of the scene's depths, with the resolution at each.
std::string scene_depth_text(const DepthFrame& depths);

/// The same figures as JSON, lengths in mm. Missing figures are null.
nlohmann::ordered_json scene_depth_json(const std::string& scene, const DepthFrame& depths);

} // namespace integral

#endif
