// SPDX-License-Identifier: AGPL-3.0-or-later
// The frame of perspective views: pictures whose windows lie on the sheet, taken from a grid of
// eyes.
#ifndef INTEGRAL_REPLAY_PERSPECTIVE_VIEWS_H
#define INTEGRAL_REPLAY_PERSPECTIVE_VIEWS_H

#include "integral/replay/parallel_views.h"

namespace integral {

/// The frame of that geometry which shows the views. They are numbered as parallel views are and of
/// one form, each a picture of the whole sheet of any size, taken from the middle of its part of
/// the eyes' zone. Each film pixel, or stripe of one, takes the colour of its own ray: interpolated
/// between the eyes around the point where it meets their plane, and in their pictures where it
/// leaves the sheet. Empty (black, transparent) where the film images nothing. `threads` and
/// `progress` as in replay. Throws std::invalid_argument where the views are not alike or not
/// grid.count().
std::optional<Image> frame_from_perspective_views(const std::vector<Image>& views,
                                                  const FrameMetadata& metadata, ViewGrid grid,
                                                  EyeGrid eyes, int threads = 0,
                                                  const Progress& progress = {});

} // namespace integral

#endif
