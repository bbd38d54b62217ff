// SPDX-License-Identifier: AGPL-3.0-or-later
// Progress bars, and stopping in good order.
#ifndef INTEGRAL_CLI_PROGRESS_H
#define INTEGRAL_CLI_PROGRESS_H

#include "integral/base/parallel.h"

namespace integral {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag; a second one ends the program.
void catch_interrupts();
bool interrupted();

/// Throws Interrupted if the flag is set: for use between the steps of a command.
void stop_if_interrupted();

/// Draws a bar on standard error if that is a terminal, and stops the work if interrupted.
Progress progress_bar(const char* what);

} // namespace integral

#endif
