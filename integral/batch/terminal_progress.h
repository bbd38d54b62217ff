// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows how far a batch is.
#ifndef INTEGRAL_BATCH_TERMINAL_PROGRESS_H
#define INTEGRAL_BATCH_TERMINAL_PROGRESS_H

#include "integral/batch/batch_progress.h"

namespace integral {

/// On a terminal a bar on standard error, with the jobs at work and the time left; else a line for
/// each job that has ended. Stops the batch if interrupted.
BatchReporter batch_reporter();

} // namespace integral

#endif
