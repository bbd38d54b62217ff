// SPDX-License-Identifier: AGPL-3.0-or-later
// Passes on notices: facts about an input that a user should know although the work goes on.
#ifndef INTEGRAL_BASE_NOTICES_H
#define INTEGRAL_BASE_NOTICES_H

#include <functional>
#include <string>

namespace integral {

/// Passes on a line, in the form of InputError's message: "FILE: what was found; what would help".
/// Each line is passed on once, even if a file is read several times. Thread-safe.
void give_notice(const std::string& line);

/// Sets the function that gets all later lines, one call at a time. Until then, lines are dropped.
void receive_notices(std::function<void(const std::string&)> receiver);

} // namespace integral

#endif
