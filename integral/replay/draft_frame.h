// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows a draft as the print of finer pixels will look.
#ifndef INTEGRAL_REPLAY_DRAFT_FRAME_H
#define INTEGRAL_REPLAY_DRAFT_FRAME_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// Whether a frame with metadata is a draft of finer pixels (RenderRecord::draft > 1) without
/// subpixels.
bool is_draft(const Frame& frame);

/// A draft on the pixels of its final frame, or, where those are more than 40 million, on as fine
/// ones as that allows. Each is interpolated between the draft's pixels that the same lens images,
/// so that nothing is mixed across the border of two lenses. The metadata are those of the finer
/// film, without `draft`. `threads`: 0 for one per core. Nothing if `progress` stopped the work.
std::optional<Frame> with_final_pixels(const Frame& draft, int threads = 0,
                                       const Progress& progress = {});

} // namespace integral

#endif
