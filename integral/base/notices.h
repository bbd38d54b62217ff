// SPDX-License-Identifier: AGPL-3.0-or-later
// Passes on what a user should know about an input although the work goes on.
#ifndef INTEGRAL_BASE_NOTICES_H
#define INTEGRAL_BASE_NOTICES_H

#include <functional>
#include <string>

namespace integral {

/// Passes on a line of the form of InputError's message, "FILE: what was found; what would help".
/// Each line is passed on once, even if a file is read several times. Threads may call it.
void give_notice(const std::string& line);

/// Sets the function that gets all later lines, one call at a time. Without one they are dropped.
void receive_notices(std::function<void(const std::string&)> receiver);

} // namespace integral

#endif
