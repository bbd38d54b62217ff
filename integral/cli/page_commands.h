// SPDX-License-Identifier: AGPL-3.0-or-later
// Describes the commands for cli/command_pages, from their declarations (command.h).
#ifndef INTEGRAL_CLI_PAGE_COMMANDS_H
#define INTEGRAL_CLI_PAGE_COMMANDS_H

#include "integral/cli/command.h"
#include "integral/cli/command_pages.h"

namespace integral {

PageCommand page_command(const Command& command);

/// Every command, in the order of all_commands.
PageCommands page_commands();

} // namespace integral

#endif
