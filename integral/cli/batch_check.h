// SPDX-License-Identifier: AGPL-3.0-or-later
// A manifest's papers, panels and previews, against the commands that make them.
#ifndef INTEGRAL_CLI_BATCH_CHECK_H
#define INTEGRAL_CLI_BATCH_CHECK_H

#include "integral/batch/plan.h"
#include "integral/optics/vec.h"

namespace integral {

/// Before anything is rendered: that the commands know the papers, the panels and the options'
/// names. Throws InputError with line and field. Says on standard error what a panel's calibration
/// lacks.
void check_targets(const Manifest& manifest);

/// Pixels of the picture that a step makes of a frame whose pixels have this pitch (mm): of a
/// printed page, a view or a sheet of views, a panel's image, with its views where --size says
/// theirs. Of a PDF file none: it holds the frame itself.
double output_pixels(const Manifest& manifest, const BatchStep& step, Vec2 pixel_pitch);

} // namespace integral

#endif
