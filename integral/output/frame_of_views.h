// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes the frame that shows given views. The views are in memory, the frame is not.
#ifndef INTEGRAL_OUTPUT_FRAME_OF_VIEWS_H
#define INTEGRAL_OUTPUT_FRAME_OF_VIEWS_H

#include "integral/output/given_views.h"

namespace integral {

/// Writes to `output` the frame of that geometry, whose quilt record is left out. The views are of
/// eyes if there are `eyes`, and lie on the film as `picture` has it; else they are parallel ones.
/// `threads` and `progress` as in for_each_row.
/// Throws std::invalid_argument where the views do not go with the geometry, OutputError, and
/// Interrupted where `progress` stops the work.
void write_frame_of_views(const std::string& output, const GivenViews& given,
                          const FrameMetadata& geometry, const std::optional<EyeGrid>& eyes,
                          const FittedPicture& picture, int threads, const Progress& progress);

} // namespace integral

#endif
