// SPDX-License-Identifier: AGPL-3.0-or-later
// A manifest's papers, panels and previews, against the commands that make them.
#ifndef INTEGRAL_CLI_BATCH_CHECK_H
#define INTEGRAL_CLI_BATCH_CHECK_H

#include "integral/batch/manifest.h"

namespace integral {

/// Before anything is rendered: that the commands know the papers, the panels and the options' names. Throws InputError with line and field. Says on
/// standard error what a panel's calibration lacks.
void check_targets(const Manifest& manifest);

} // namespace integral

#endif
