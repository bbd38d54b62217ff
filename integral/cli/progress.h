// SPDX-License-Identifier: AGPL-3.0-or-later
// Progress bars.
#ifndef INTEGRAL_CLI_PROGRESS_H
#define INTEGRAL_CLI_PROGRESS_H

#include "integral/base/interrupt.h"
#include "integral/base/parallel.h"

namespace integral {

/// Draws a bar on standard error if that is a terminal, and stops the work if interrupted.
Progress progress_bar(const char* what);

} // namespace integral

#endif
