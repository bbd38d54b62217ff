// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the part of the sheet that a view shows, so that a picture of any shape shows it
// unstretched.
#ifndef INTEGRAL_REPLAY_FIT_PART_H
#define INTEGRAL_REPLAY_FIT_PART_H

#include "integral/frame/picture_fit.h"
#include "integral/replay/replay.h"

namespace integral {

/// The part of the sheet, or of its projected image, that the view shows: view.part, or all.
SheetPart part_seen(const View& view, const FrameMetadata& metadata);

/// Fits the view's part into a picture with width/height `shape` (picture_fit.h): makes the part
/// larger, even beyond the sheet's edges (contain), or smaller (cover), about its middle.
FittedPicture fit_part(View& view, const FrameMetadata& metadata, double shape, Fit fit);

/// The same for the view's size in square pixels. Does nothing if the size is the part's shape
/// rounded to whole pixels.
FittedPicture fit_part_to_size(View& view, const FrameMetadata& metadata, Fit fit);

} // namespace integral

#endif
