// SPDX-License-Identifier: AGPL-3.0-or-later
// Stopping in good order when the user asks for it.
#ifndef INTEGRAL_BASE_INTERRUPT_H
#define INTEGRAL_BASE_INTERRUPT_H

#include <stdexcept>

namespace integral {

/// The user stopped the work.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag; a second one ends the program.
void catch_interrupts();

/// Whether the flag is set.
bool interrupted();

/// Throws Interrupted if the flag is set: for use between the steps of long work.
void stop_if_interrupted();

} // namespace integral

#endif
