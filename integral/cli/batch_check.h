// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks a manifest's papers, panels and previews by the commands that make them.
#ifndef INTEGRAL_CLI_BATCH_CHECK_H
#define INTEGRAL_CLI_BATCH_CHECK_H

#include "integral/batch/plan.h"
#include "integral/optics/vec.h"

namespace integral {

/// Throws InputError, with line and field, for a paper, a panel or an option that the commands
/// do not know. Says on standard error what a panel's calibration lacks.
void check_targets(const Manifest& manifest);

/// An OutputPixels of batch/batch_memory.h. Of a PDF file 0: it holds the frame itself. A panel's
/// image counts with its views if --size gives theirs.
double output_pixels(const Manifest& manifest, const BatchStep& step, Vec2 pixel_pitch);

} // namespace integral

#endif
