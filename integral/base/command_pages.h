// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes the pages about a program's commands: its overview, pages of the manual (Markdown), man
// pages and completion for bash.
#ifndef INTEGRAL_BASE_COMMAND_PAGES_H
#define INTEGRAL_BASE_COMMAND_PAGES_H

#include <string>
#include <vector>

namespace integral {

/// An option as a page shows it.
struct PageOption {
    std::string name;        ///< --NAME
    std::string letter;      ///< -L, or empty
    std::string value;       ///< the word that stands for its value, or empty: a switch
    std::string choices;     ///< the values that are possible, separated by blanks; empty: any text
    std::string description; ///< with the default
};

/// A command as a page shows it.
struct PageCommand {
    std::string name, summary, usage;
    std::string description; ///< lines that begin with a blank are an example, kept as it is
    std::vector<PageOption> options;
    bool laboratory = false; ///< listed after those of every day
};
using PageCommands = std::vector<PageCommand>;

/// What `integral help` prints.
std::string overview(const PageCommands& commands);

/// The head of doc/commands/NAME.md: usage, description and options. Ends with a line after which
/// the page is written by hand.
std::string markdown_head(const PageCommand& command);

/// The man pages integral(1) and integral-NAME(1), as roff.
std::string manual_page(const PageCommands& commands);
std::string manual_page(const PageCommand& command);

/// A script for bash, which completes commands, options, and values where they are words or files.
std::string bash_completion(const PageCommands& commands);

} // namespace integral

#endif
