// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows the progress of a batch.
#ifndef INTEGRAL_BATCH_TERMINAL_PROGRESS_H
#define INTEGRAL_BATCH_TERMINAL_PROGRESS_H

#include "integral/batch/batch_progress.h"

namespace integral {

/// Draws a bar on a terminal's standard error, with the running jobs and the time left; elsewhere
/// prints a line for each ended job. Stops the batch if interrupted.
BatchReporter batch_reporter();

} // namespace integral

#endif
