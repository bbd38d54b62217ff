// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes the frame that shows given views. The views are in memory, the frame is not.
#ifndef INTEGRAL_VIEWS_FRAME_OF_VIEWS_H
#define INTEGRAL_VIEWS_FRAME_OF_VIEWS_H

#include "integral/views/view_input.h"

namespace integral {

/// Writes to `output` the frame of that geometry that shows the views; the geometry's quilt record
/// is left out. If `eyes` is given, the views are of eyes and lie on the film as in `picture`; else
/// they are parallel. `threads` and `progress` as in for_each_row. Throws std::invalid_argument if
/// the views do not fit the geometry, OutputError, and Interrupted if `progress` stops the work.
void write_frame_of_views(const std::string& output, const ViewInput& given,
                          const FrameMetadata& geometry, const std::optional<EyeGrid>& eyes,
                          const FittedPicture& picture, int threads, const Progress& progress);

} // namespace integral

#endif
