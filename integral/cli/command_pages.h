// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes the pages about a program's commands: overview, manual pages (Markdown), man pages and
// bash completion.
#ifndef INTEGRAL_CLI_COMMAND_PAGES_H
#define INTEGRAL_CLI_COMMAND_PAGES_H

#include <string>
#include <vector>

namespace integral {

/// An option's texts for a page.
struct PageOption {
    std::string name;        ///< --NAME
    std::string letter;      ///< -L, or empty
    std::string value;       ///< placeholder for its value; empty: a switch
    std::string choices;     ///< possible values, separated by blanks; empty: any text
    std::string description; ///< with the default
};

/// A command's texts for a page.
struct PageCommand {
    std::string name, summary, usage;
    std::string description; ///< lines that begin with a blank are an example, copied unchanged
    std::vector<PageOption> options;
    bool laboratory = false; ///< listed after the everyday commands
};
using PageCommands = std::vector<PageCommand>;

/// The text of `integral help`.
std::string overview(const PageCommands& commands);

/// The head of doc/commands/NAME.md: usage, description and options. Its last line marks the
/// beginning of the handwritten part.
std::string markdown_head(const PageCommand& command);

/// The man pages integral(1) and integral-NAME(1), as roff.
std::string manual_page(const PageCommands& commands);
std::string manual_page(const PageCommand& command);

/// A bash script that completes commands, options, and values that are words or files.
std::string bash_completion(const PageCommands& commands);

} // namespace integral

#endif
