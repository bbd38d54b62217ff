// SPDX-License-Identifier: AGPL-3.0-or-later
// The report on a scene's depths as a page of HTML, and its picture.
#ifndef INTEGRAL_REPLAY_DEPTH_PAGE_H
#define INTEGRAL_REPLAY_DEPTH_PAGE_H

#include "integral/replay/depth_picture.h"

#include <string>

namespace integral {

/// The depth_picture of a scene by its sheet's own depth budget. Throws std::invalid_argument where
/// the sheet has none.
Image scene_picture(const DepthFrame& depths, const std::optional<Frame>& colours);

/// What an eye sees of a scene behind its sheet: as it is, and with a fit.
struct SceneLooks {
    Image as_it_is, fitted;
    std::string fit; ///< the value of Integral_Fit=
};

/// A page of verdict, pictures and tables about `scene`.
std::string depth_page(const std::string& scene, const std::string& verdict, const Image& picture,
                       const std::optional<SceneLooks>& looks, const std::string& tables);

} // namespace integral

#endif
