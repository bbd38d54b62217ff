// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows what an eye will see of a scene's print, from a draft of the print.
#ifndef INTEGRAL_BATCH_SCENE_LOOK_H
#define INTEGRAL_BATCH_SCENE_LOOK_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"

#include <string>
#include <vector>

namespace integral {

/// The number (Integral_Draft=) of the coarsest draft with at least four pixels a lens, or four
/// colour stripes of a panel's pixels, which is enough to judge depth. 1 if the print itself has
/// fewer.
int draft_of_four_views(const FrameMetadata& print);

/// Has povray-integral render a draft of a scene (names_scene) whose print has the geometry
/// `print`, expands the draft to the print's pixels, and replays it for an eye in the middle. The
/// result's longer side has `longest` pixels; the draft has at least four pixels a lens if the
/// print has. `options`: further words for povray-integral; `fit` is the value of Integral_Fit=, or
/// empty to leave that unchanged. `progress` counts hundredths. Throws InputError.
Image look_of_scene(const std::string& scene, const std::vector<std::string>& options,
                    const FrameMetadata& print, const std::string& fit, int longest,
                    const Progress& progress = {});

} // namespace integral

#endif
