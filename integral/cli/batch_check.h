// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks a manifest's papers, panels and previews with the code of the commands that make them.
#ifndef INTEGRAL_CLI_BATCH_CHECK_H
#define INTEGRAL_CLI_BATCH_CHECK_H

#include "integral/batch/plan.h"
#include "integral/optics/vec.h"

namespace integral {

/// Throws InputError, with line and field, for a paper, panel or option that its command rejects.
/// Warns on standard error of assumed values in a panel's calibration.
void check_targets(const Manifest& manifest);

/// An OutputPixels (batch/batch_memory.h). A PDF file counts as 0, because it contains the frame's
/// own pixels. A panel's image counts with four views if --size gives the views' size.
double output_pixels(const Manifest& manifest, const BatchStep& step, Vec2 pixel_pitch);

} // namespace integral

#endif
