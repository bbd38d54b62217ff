// SPDX-License-Identifier: AGPL-3.0-or-later
// Converts a draft to the finer pixels of the final print.
#ifndef INTEGRAL_REPLAY_DRAFT_FRAME_H
#define INTEGRAL_REPLAY_DRAFT_FRAME_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"

namespace integral {

/// Whether a frame's metadata mark it as a draft (RenderRecord::draft > 1), and its film has no
/// subpixels.
bool is_draft(const Frame& frame);

/// Resamples a draft on the pixels of its final frame or, if these are more than 40 million, on the
/// finest pixels within that number. Each new pixel is interpolated between draft pixels that the
/// same lens images, so that nothing is mixed across the border of two lenses. The metadata
/// describe the finer film, with `draft` = 1. `threads`: 0 for one per core. Returns nothing if
/// `progress` stopped the work.
std::optional<Frame> with_final_pixels(const Frame& draft, int threads = 0,
                                       const Progress& progress = {});

} // namespace integral

#endif
