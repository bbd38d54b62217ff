// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds programs.
#ifndef INTEGRAL_BASE_PROGRAM_PATH_H
#define INTEGRAL_BASE_PROGRAM_PATH_H

#include <optional>
#include <string>

namespace integral {

/// The path of the program that a bare name would run, by PATH; nothing if there is none.
std::optional<std::string> program_on_path(const std::string& name);

} // namespace integral

#endif
