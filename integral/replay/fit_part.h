// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses which part of the sheet a view shows, so that a picture of any shape shows it
// unstretched.
#ifndef INTEGRAL_REPLAY_FIT_PART_H
#define INTEGRAL_REPLAY_FIT_PART_H

#include "integral/lightfield/picture_fit.h"
#include "integral/replay/replay.h"

namespace integral {

/// The part that the view shows, of the sheet or of its projected image: the view's own, or all.
SheetPart part_seen(const View& view, const FrameMetadata& metadata);

/// Fits the view's part into a picture of that shape (picture_fit.h): makes it larger, beyond the
/// sheet's edges too (contain), or smaller (cover), about its middle.
FittedPicture fit_part(View& view, const FrameMetadata& metadata, double shape, Fit fit);

/// The same for the view's size in square pixels. Nothing is done where no whole number of pixels
/// is nearer to the part's shape.
FittedPicture fit_part_to_size(View& view, const FrameMetadata& metadata, Fit fit);

} // namespace integral

#endif
