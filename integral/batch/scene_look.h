// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows what an eye will see of a scene's print, by a draft of it.
#ifndef INTEGRAL_BATCH_SCENE_LOOK_H
#define INTEGRAL_BATCH_SCENE_LOOK_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"

#include <string>
#include <vector>

namespace integral {

/// Has povray-integral render a draft of a scene (names_scene) whose print has this geometry, and
/// replays it for an eye in the middle, filled in as the print will be: at most `longest` pixels on
/// its longer side. The draft has at least four pixels a lens, as far as the print has so many.
/// `options` are further words of povray-integral's command line; `fit` is the value of
/// Integral_Fit=, or empty to leave that as it is. `progress` counts hundredths. Throws InputError.
Image look_of_scene(const std::string& scene, const std::vector<std::string>& options,
                    const FrameMetadata& print, const std::string& fit, int longest,
                    const Progress& progress = {});

} // namespace integral

#endif
