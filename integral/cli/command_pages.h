// SPDX-License-Identifier: AGPL-3.0-or-later
// The commands' pages for the manual (Markdown), man pages and completion for bash, all written
// from what the commands declare (command.h).
#ifndef INTEGRAL_CLI_COMMAND_PAGES_H
#define INTEGRAL_CLI_COMMAND_PAGES_H

#include "integral/cli/command.h"

#include <string>

namespace integral {

/// What `integral help` prints.
std::string overview();

/// The head of doc/commands/NAME.md: usage, description and options. Ends with a line after which
/// the page is written by hand.
std::string markdown_head(const Command& command);

/// The man pages integral(1) and integral-NAME(1), as roff.
std::string manual_page();
std::string manual_page(const Command& command);

/// A script for bash, which completes commands, options, and values where they are words or files.
std::string bash_completion();

} // namespace integral

#endif
