// SPDX-License-Identifier: AGPL-3.0-or-later
// Report on a scene's depths as an HTML page, and its picture.
#ifndef INTEGRAL_DEPTH_DEPTH_PAGE_H
#define INTEGRAL_DEPTH_DEPTH_PAGE_H

#include "integral/depth/depth_picture.h"

#include <string>

namespace integral {

/// The depth_picture of a scene, tinted by its sheet's depth budget. Throws std::invalid_argument
/// if the sheet has none.
Image scene_picture(const DepthFrame& depths, const std::optional<Frame>& colours);

/// Views of a scene through its sheet: of the scene as it is, and of the scene with Integral_Fit.
struct SceneLooks {
    Image as_it_is, fitted;
    std::string fit; ///< the value of Integral_Fit=
};

/// A page of verdict, pictures and tables about `scene`.
std::string depth_page(const std::string& scene, const std::string& verdict, const Image& picture,
                       const std::optional<SceneLooks>& looks, const std::string& tables);

} // namespace integral

#endif
