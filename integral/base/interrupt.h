// SPDX-License-Identifier: AGPL-3.0-or-later
// Lets long work stop cleanly on SIGINT, SIGTERM or SIGHUP.
#ifndef INTEGRAL_BASE_INTERRUPT_H
#define INTEGRAL_BASE_INTERRUPT_H

#include <stdexcept>

namespace integral {

/// Thrown by stop_if_interrupted() after one of these signals.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Makes the first SIGINT, SIGTERM or SIGHUP set a flag instead of ending the program; a second
/// signal of the same kind ends the program. Signals that are ignored stay ignored.
void catch_interrupts();

/// Whether the flag is set.
bool interrupted();

/// Throws Interrupted if the flag is set. Call it between the steps of long work.
void stop_if_interrupted();

} // namespace integral

#endif
